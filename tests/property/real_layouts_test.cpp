// Layouts of real meshes, before and after pruning.
#include "enumerate/paper/plain_graph.h"
#include "mesh/dihedral.h"
#include "mesh/files/read_mesh.h"
#include "prune/prune.h"
#include "support/layout_fault.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace qm::test {
namespace {

std::vector<std::filesystem::path> realMeshes() {
    const char* folder = std::getenv("QM_SHARED_MESHES");
    const std::filesystem::path meshes = std::filesystem::path(folder ? folder : "../shared/meshes") / "dev";
    std::vector<std::filesystem::path> files;
    if (std::filesystem::is_directory(meshes))
        for (const auto& entry : std::filesystem::directory_iterator(meshes))
            files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

void expectGridsHoweverPruned(const QuadMesh& mesh) {
    const std::vector<double> angles = dihedralAngles(mesh), costs = edgeCosts(angles, {});
    const MotorcycleGraph graph = plainMotorcycleGraph(mesh, buildBaseComplex(mesh), costs);
    const Layout layout = buildLayout(mesh, graph.tracks, angles, costs);
    ASSERT_EQ(layoutFault(mesh, layout), "");
    for (const double eta : {1.0, -3.0, -1e9})
        for (const bool smooth : {false, true}) {
            PruneOptions options;
            options.eta = eta;
            options.smooth = smooth;
            const PruneResult pruned = pruneLayout({mesh, {}, angles, costs}, layout, options);
            EXPECT_EQ(layoutFault(mesh, pruned.layout), "") << "eta " << eta << ", smooth " << smooth;
            EXPECT_EQ(pruned.layout.tracks.size() + pruned.removedTracks, layout.tracks.size());
            EXPECT_LE(pruned.layout.segments.size(), layout.segments.size());
        }
}

TEST(RealMeshes, StayInGridsHoweverTheyArePruned) {
    const std::vector<std::filesystem::path> files = realMeshes();
    if (files.empty()) GTEST_SKIP() << "the meshes are not here";
    for (const std::filesystem::path& path : files) {
        SCOPED_TRACE(path.filename().string());
        std::ifstream file(path, std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(file), {}};
        expectGridsHoweverPruned(readMesh(bytes, path.filename().string()).mesh);
    }
}

} // namespace
} // namespace qm::test
