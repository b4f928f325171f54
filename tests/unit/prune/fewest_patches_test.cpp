// The search for the fewest segments, when there is no time for it.
#include "prune/pruning_search.h"
#include "support/polycube.h"
#include "support/random_graph.h"
#include "support/track_along.h"

#include <gtest/gtest.h>

namespace qm::test {
namespace {

/// \param lines  every one begins at its first vertex, and goes all the way round
PruningSearch::Found fewestWithoutTime(const QuadMesh& mesh, const std::vector<Path>& lines) {
    std::vector<Seed> seeds;
    std::vector<Track> tracks;
    for (const Path& line : lines) {
        tracks.push_back(trackAlong(mesh, line));
        seeds.push_back({tracks.back().halfedges.front()});
    }
    const BaseComplex complex = buildBaseComplex(mesh, seeds);
    const PerEdge angles(mesh, 0), costs(mesh, 1);
    const Layout layout = buildLayout(mesh, tracks, angles, costs);
    PruneOptions options;
    options.smooth = false;
    return PruningSearch({mesh, complex, angles, costs}, layout, options, {}).findFewest(0);
}

TEST(FewestPatches, EveryPieceOfAMeshHasOne) {
    const QuadMesh mesh = quadMesh(together({torus(4, 4), torus(4, 4)}));
    const PruningSearch::Found found = fewestWithoutTime(
        mesh, {{1, 2, 3, 0, 1}, {4, 8, 12, 0, 4}, {17, 18, 19, 16, 17}, {20, 24, 28, 16, 20}});
    EXPECT_EQ(found.lowerBound, 2);
    EXPECT_TRUE(found.proven);
}

} // namespace
} // namespace qm::test
