#include "base/at.h"
#include "base/keep_marked.h"
#include "base/positions.h"
#include "shape/sample_meshes.h"
#include "shape/voxels.h"

#include <algorithm>
#include <random>
#include <vector>

namespace qm {
namespace {

/// The same numbers everywhere, which the distributions of the standard library do not promise.
class Chance {
public:
    explicit Chance(std::uint64_t seed) : engine_(seed) {}
    std::size_t below(std::size_t bound) { return static_cast<std::size_t>(engine_() % bound); }

private:
    std::mt19937_64 engine_;
};

QuadList softSurface(const QuadList& coarse, int n, int maxRounds) {
    QuadList list = refined(coarse, n);
    soften(list, std::min(n * n, maxRounds));
    return list;
}

/// Grows from one voxel; each that is added leaves the surface a manifold.
Voxels randomVoxels(int count, Chance& chance) {
    Voxels voxels{{0, 0, 0}};
    std::vector<Voxel> inside{{0, 0, 0}};
    while (static_cast<int>(voxels.size()) < count) {
        Voxel voxel = inside[chance.below(inside.size())];
        voxel[chance.below(3)] += chance.below(2) == 0 ? -1 : 1;
        if (!voxels.insert(voxel).second) continue;
        if (surfaceIsManifoldAt(voxels, voxel)) {
            inside.push_back(voxel);
        } else {
            voxels.erase(voxel);
        }
    }
    return voxels;
}

/// Whether the remaining ones of a vertex's faces still make a single fan.
bool isOneFan(const QuadList& list, const std::vector<bool>& stays, const std::vector<std::size_t>& around,
              int vertex) {
    // In a fan of k faces, k or k - 1 of the corners go on to another one.
    std::vector<int> leaving, arriving;
    for (const std::size_t face : around) {
        if (!stays[face]) continue;
        const auto& quad = list.quads[face];
        const std::size_t corner = positionIn(quad, std::ranges::find(quad, vertex));
        leaving.push_back(quad[(corner + 1) % 4]);
        arriving.push_back(quad[(corner + 3) % 4]);
    }
    const auto joined = std::ranges::count_if(
        leaving, [&](int other) { return std::ranges::find(arriving, other) != arriving.end(); });
    return !leaving.empty() && joined + 1 >= static_cast<std::ptrdiff_t>(leaving.size());
}

/// Takes about one face in eight out, where the surface stays a manifold and no vertex is left alone.
void removeFaces(QuadList& list, Chance& chance) {
    std::vector<std::vector<std::size_t>> around(list.points.size());
    for (std::size_t face = 0; face < list.quads.size(); ++face)
        for (const int vertex : list.quads[face])
            around[at(vertex)].push_back(face);
    std::vector<bool> stays(list.quads.size(), true);
    for (std::size_t trial = 0; trial < list.quads.size() / 8 + 1; ++trial) {
        const std::size_t face = chance.below(list.quads.size());
        if (!stays[face]) continue;
        stays[face] = false;
        stays[face] = !std::ranges::all_of(
            list.quads[face], [&](int vertex) { return isOneFan(list, stays, around[at(vertex)], vertex); });
    }
    (void)keepMarked(list.quads, stays);
}

} // namespace

QuadList pretzelShape(int n, int holes) {
    Voxels voxels = voxelBox(2 * holes + 1, 3, 1);
    for (int k = 0; k < holes; ++k)
        voxels.erase({2 * k + 1, 1, 0});
    return softSurface(voxelSurface(voxels), n, 400);
}

QuadList randomShape(int n, int voxels, std::uint64_t seed) {
    Chance chance(seed);
    return softSurface(voxelSurface(randomVoxels(voxels, chance)), n, 10);
}

QuadList randomOpenShape(int n, int voxels, std::uint64_t seed) {
    Chance chance(seed);
    QuadList surface = voxelSurface(randomVoxels(voxels, chance));
    removeFaces(surface, chance);
    return softSurface(surface, n, 10);
}

} // namespace qm
