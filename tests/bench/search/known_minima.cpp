#include "bench/search/known_minima.h"

#include <array>

namespace qm::bench {
namespace {

constexpr std::array rows{
    KnownMinima{"cube6.off", 8, 0, "1", -18.849556, -18.849556},
    KnownMinima{"yas_island.off", 4, 0, "1", 2.444242, 2.444242},
    KnownMinima{"gitter.off", 12, 0, "1", -52.367289, -52.367289},
    KnownMinima{"block_skel.obj", 24, 0, "1", -79.188544, -79.188544},
    KnownMinima{"rod.obj", 12, 4, "7", -143.680898, -143.680898},
    KnownMinima{"duck_miq_28.obj", 13, 5, "8", -46.093969, -46.093969},
    KnownMinima{"Cpadded.obj", 16, 8, "28", -40.007942, -40.007942},
    KnownMinima{"cactus.obj", 24, 8, "49", -210.594046, -210.594046},
    KnownMinima{"trebol.obj", 17, 15, "1604", -79.870150, -79.870150},
    KnownMinima{"cube_minus_sphere.obj", 14, 18, "296", -84.930052, -84.930052},
    KnownMinima{"lever_arm.obj", 32, 26, "580996", -37.640530, -37.640530},
    KnownMinima{"metatron.obj", 28, 48, "1", 356.070611, 356.070611},
    KnownMinima{"mount2.obj", 48, 52, "", -446.569723, -446.569723},
    KnownMinima{"joint_srf.obj", 24, 73, "", -439.088746, -439.088746},
    KnownMinima{"fandisk_dualsheet.obj", 38, 122, "", -336.483484, -340.259378},
    KnownMinima{"fandisk_qex.obj", 28, 220, "", -408.130369, -422.918187},
    KnownMinima{"awkward_valid.obj", 28, 220, "", -408.130369, -422.918188},
    KnownMinima{"neon_side.off", 33, 233, "", -1036.594677, -1127.312375},
    KnownMinima{"rockerarm_srf.obj", 48, 240, "", -331.188026, -363.713185, 1e-4},
    KnownMinima{"duck_miq_8.obj", 28, 241, "", -147.006595, -195.160114},
    KnownMinima{"circle_in_square.obj", 30, 262, "", 336.400000, 330.800000},
    KnownMinima{"bearing_plate_hex.obj", 72, 296, "", -991.095024, -1009.400063},
    KnownMinima{"rockerarm_125k.obj", 88, 320, "", 2416.571662, 2411.435670},
    KnownMinima{"fandisk_pmp.off", 30, 332, "", -364.991512, -384.913721},
    KnownMinima{"car_opensubdiv.obj", 346, 360, "", -1135.700921, -1152.052931},
    KnownMinima{"botijo_miq.obj", 74, 403, "", -683.949674, -735.366073, 1e-4},
    KnownMinima{"pipes_sweep1.obj", 84, 428, "", -115.933746, -197.557112},
    KnownMinima{"lego_L2.obj", 160, 436, "", -1854.135214, -1854.135214},
    KnownMinima{"beetle_qf_1k.obj", 82, 492, "", -114.885023, -151.154025},
    KnownMinima{"rockerarm_qf_1k.obj", 32, 562, "", -368.948339, -510.008435},
    KnownMinima{"beetle_qf_5k.obj", 93, 813, "", 34.017288, -37.619484},
};

constexpr std::array<const char*, 12> hard{
    "horse_quad.obj",          "inspired_conjugate.off",  "casting.obj",
    "dancing_children.obj",    "pig_octree.obj",          "armadillo_qex.obj",
    "bearing_plate_qf_5k.obj", "gargoyle_quadriflow.obj", "rockerarm_im_5k.obj",
    "bottle_qf_5k.obj",        "rockerarm_qf_5k.obj",     "rockerarm_qf_20k.obj"};

} // namespace

std::span<const KnownMinima> knownMinima() {
    return rows;
}

std::span<const char* const> hardMeshes() {
    return hard;
}

} // namespace qm::bench
