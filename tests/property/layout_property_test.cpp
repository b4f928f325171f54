// Layouts and their pruning on random meshes with random motorcycle graphs.
#include "base/error.h"
#include "base/infinity.h"
#include "enumerate/paper/plain_graph.h"
#include "layout/layout.h"
#include "prune/prune.h"
#include "prune/removal.h"
#include "support/layout_fault.h"
#include "support/random_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace qm::test {
namespace {

struct Case {
    QuadMesh mesh;
    std::vector<double> angles, costs;
    std::vector<Track> tracks;
};

/// A random case; nothing if the random mesh is none, as in about one case of four.
std::optional<Case> randomCase(unsigned number) {
    std::mt19937 random(number);
    std::optional<QuadMesh> mesh = randomMesh(random);
    if (!mesh) return std::nullopt;
    Case drawn{std::move(*mesh), {}, {}, {}};
    std::uniform_real_distribution<double> angle(0, 1), cost(-1, 1);
    for (std::size_t edge = 0; edge < drawn.mesh.n_edges(); ++edge) {
        drawn.angles.push_back(angle(random));
        drawn.costs.push_back(cost(random));
    }
    const BaseComplex complex = buildBaseComplex(drawn.mesh, randomSeeds(drawn.mesh, 3, random));
    drawn.tracks = number % 4 == 0 ? plainMotorcycleGraph(drawn.mesh, complex, drawn.costs).tracks
                                   : randomGraph(drawn.mesh, complex, drawn.costs, random);
    return drawn;
}

Layout layoutOf(const Case& drawn, const std::vector<Track>& tracks) {
    return buildLayout(drawn.mesh, tracks, drawn.angles, drawn.costs);
}

std::size_t addedTo(const Layout& layout, std::size_t given) {
    return layout.tracks.size() - given;
}

/// The tracks of a layout, without transversals and without one of the tracks.
std::vector<Track> tracksWithout(const Layout& layout, std::size_t left) {
    Layout smaller = layout;
    smaller.tracks.erase(smaller.tracks.begin() + static_cast<std::ptrdiff_t>(left));
    return properTracks(smaller);
}

/// Removes a track and checks the whole mesh: every segment must be a grid, and the annuli must stay the
/// same.
bool removable(const Case& drawn, const Layout& layout, std::size_t t) {
    const std::vector<Track> rest = tracksWithout(layout, t);
    try {
        const Layout smaller = layoutOf(drawn, rest);
        return addedTo(smaller, rest.size()) == addedTo(layout, rest.size() + 1);
    } catch (const Error&) {
        return false;
    }
}

class RandomLayout : public ::testing::TestWithParam<unsigned> {
protected:
    static constexpr unsigned casesPerTest = 250;

    void forEachCase(const std::function<void(const Case&)>& body) {
        std::size_t met = 0;
        for (unsigned k = 0; k < casesPerTest; ++k) {
            const unsigned number = GetParam() * casesPerTest + k;
            const std::optional<Case> drawn = randomCase(number);
            if (!drawn) continue;
            ++met;
            SCOPED_TRACE("case " + std::to_string(number));
            ASSERT_NO_FATAL_FAILURE(body(*drawn));
            if (HasFailure()) return;
        }
        EXPECT_GT(met, casesPerTest / 3);
    }
};

TEST_P(RandomLayout, IsMadeOfGridsThatTileTheMesh) {
    forEachCase(
        [](const Case& drawn) { EXPECT_EQ(layoutFault(drawn.mesh, layoutOf(drawn, drawn.tracks)), ""); });
}

TEST_P(RandomLayout, LocalTestOfARemovalAgreesWithTheWholeMesh) {
    forEachCase([](const Case& drawn) {
        const Layout layout = layoutOf(drawn, drawn.tracks);
        Removal removal(drawn.mesh, layout);
        for (std::size_t t = 0; t < layout.tracks.size(); ++t) {
            if (layout.tracks[t].transversal) continue;
            EXPECT_EQ(removal.keepsGrids(layout.tracks[t].track), removable(drawn, layout, t))
                << "track " << t;
        }
    });
}

/// The same greedy choice, building the whole layout anew for every test.
std::vector<Track> pruneSlowly(const Case& drawn, Layout layout) {
    for (bool changed = true; changed;) {
        changed = false;
        std::vector<Track> order = properTracks(layout);
        std::ranges::stable_sort(order, std::greater{}, &Track::cost);
        for (const Track& track : order) {
            const auto t = std::ranges::find_if(layout.tracks,
                                                [&](const LayoutTrack& other) {
                                                    return other.track.halfedges == track.halfedges;
                                                }) -
                           layout.tracks.begin();
            if (!removable(drawn, layout, static_cast<std::size_t>(t))) continue;
            layout = layoutOf(drawn, tracksWithout(layout, static_cast<std::size_t>(t)));
            changed = true;
        }
    }
    return properTracks(layout);
}

TEST_P(RandomLayout, IsPrunedAsIfEveryQuestionWereAskedOfTheWholeMesh) {
    PruneOptions options;
    options.eta = -infinity;
    options.smooth = false;
    forEachCase([&](const Case& drawn) {
        const Layout layout = layoutOf(drawn, drawn.tracks);
        const PruneResult pruned = pruneLayout({drawn.mesh, {}, drawn.angles, drawn.costs}, layout, options);
        EXPECT_EQ(layoutFault(drawn.mesh, pruned.layout), "");
        const std::vector<Track> expected = pruneSlowly(drawn, layout);
        const std::vector<Track> kept = properTracks(pruned.layout);
        ASSERT_EQ(kept.size(), expected.size());
        for (std::size_t t = 0; t < kept.size(); ++t)
            EXPECT_EQ(kept[t].halfedges, expected[t].halfedges);
        EXPECT_EQ(pruned.removedTracks + pruned.keptNotQuadrilateral, properTracks(layout).size());
        EXPECT_EQ(pruned.keptNotSmooth, 0U);
    });
}

TEST_P(RandomLayout, SmoothPruningLeavesGridsToo) {
    PruneOptions options;
    options.eta = 0;
    options.maxTurn = 60;
    forEachCase([&](const Case& drawn) {
        const Layout layout = layoutOf(drawn, drawn.tracks);
        const PruneResult pruned = pruneLayout({drawn.mesh, {}, drawn.angles, drawn.costs}, layout, options);
        EXPECT_EQ(layoutFault(drawn.mesh, pruned.layout), "");
        EXPECT_LE(pruned.layout.segments.size(), layout.segments.size());
    });
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomLayout, ::testing::Range(0U, 8U));

} // namespace
} // namespace qm::test
