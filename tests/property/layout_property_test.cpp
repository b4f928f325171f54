// Layouts and their pruning on random meshes with random motorcycle graphs.
#include "base/error.h"
#include "enumerate/plain.h"
#include "merge/layout.h"
#include "mesh/topology.h"
#include "prune/prune.h"
#include "prune/removal.h"
#include "support/random_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <set>

namespace qm::testing {
namespace {

struct Case {
    QuadMesh mesh;
    std::vector<double> angles, costs;
    std::vector<Track> tracks;
};

/// A random case; about one in four drawn meshes is none.
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

std::set<int> borderEdges(const QuadMesh& mesh, const Layout& layout) {
    std::set<int> edges;
    for (const EdgeId edge : mesh.edges())
        if (mesh.is_boundary(edge)) edges.insert(edge.idx());
    for (const LayoutTrack& track : layout.tracks)
        for (const HalfedgeId halfedge : track.track.halfedges)
            EXPECT_TRUE(edges.insert(mesh.edge_handle(halfedge).idx()).second) << "an edge on two tracks";
    return edges;
}

void expectFace(const QuadMesh& mesh, FaceId face, std::vector<VertexId> corners) {
    std::vector<VertexId> vertices;
    for (const VertexId vertex : mesh.fv_ccw_range(face))
        vertices.push_back(vertex);
    const auto first = std::find(vertices.begin(), vertices.end(), corners.front());
    ASSERT_NE(first, vertices.end());
    std::rotate(vertices.begin(), first, vertices.end());
    EXPECT_EQ(vertices, corners);
}

/// Faces, vertices and sides fit together, and no track runs inside.
void expectGrid(const QuadMesh& mesh, const Segment& segment, const std::set<int>& borders) {
    const auto a = static_cast<std::size_t>(segment.size[0]), b = static_cast<std::size_t>(segment.size[1]);
    ASSERT_EQ(segment.faces.size(), a * b);
    const std::vector<VertexId> grid = vertexGrid(mesh, segment);
    const auto at = [&](std::size_t i, std::size_t j) { return grid[j * (a + 1) + i]; };
    for (std::size_t j = 0; j < b; ++j)
        for (std::size_t i = 0; i < a; ++i)
            expectFace(mesh, segment.faces[j * a + i],
                       {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    std::array<std::vector<VertexId>, 4> sides;
    for (std::size_t i = 0; i <= a; ++i) {
        sides[0].push_back(at(i, 0));
        sides[2].push_back(at(a - i, b));
    }
    for (std::size_t j = 0; j <= b; ++j) {
        sides[1].push_back(at(a, j));
        sides[3].push_back(at(0, b - j));
    }
    EXPECT_EQ(segment.sides, sides);
    const std::set<FaceId> inside(segment.faces.begin(), segment.faces.end());
    std::size_t onBorder = 0;
    for (const FaceId face : segment.faces)
        for (const EdgeId edge : mesh.fe_range(face))
            onBorder += borders.contains(edge.idx());
    EXPECT_EQ(onBorder, 2 * (a + b));
}

void expectLayout(const QuadMesh& mesh, const Layout& layout) {
    const std::set<int> borders = borderEdges(mesh, layout);
    std::vector<int> lowest;
    std::vector<int> times(mesh.n_faces(), 0);
    for (const Segment& segment : layout.segments) {
        expectGrid(mesh, segment, borders);
        for (const FaceId face : segment.faces)
            ++times[static_cast<std::size_t>(face.idx())];
        lowest.push_back(std::min_element(segment.faces.begin(), segment.faces.end())->idx());
    }
    EXPECT_EQ(std::ranges::count(times, 1), static_cast<std::ptrdiff_t>(mesh.n_faces()));
    EXPECT_TRUE(std::ranges::is_sorted(lowest));
}

std::size_t addedTo(const Layout& layout, std::size_t given) {
    return layout.tracks.size() - given;
}

/// The tracks of a layout that are no transversals, without one of them.
std::vector<Track> tracksWithout(const Layout& layout, std::size_t left) {
    std::vector<Track> tracks;
    for (std::size_t t = 0; t < layout.tracks.size(); ++t)
        if (!layout.tracks[t].transversal && t != left) tracks.push_back(layout.tracks[t].track);
    return tracks;
}

/// Takes the track out and looks at the whole mesh: every segment is a grid, and no annulus came or went.
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
    forEachCase([](const Case& drawn) { expectLayout(drawn.mesh, layoutOf(drawn, drawn.tracks)); });
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

/// The same greedy choice by building the whole layout anew for every question.
std::vector<Track> pruneSlowly(const Case& drawn, Layout layout) {
    for (bool changed = true; changed;) {
        changed = false;
        std::vector<Track> order = tracksWithout(layout, layout.tracks.size());
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
    return tracksWithout(layout, layout.tracks.size());
}

TEST_P(RandomLayout, IsPrunedAsIfEveryQuestionWereAskedOfTheWholeMesh) {
    PruneOptions options;
    options.eta = -std::numeric_limits<double>::infinity();
    options.smooth = false;
    forEachCase([&](const Case& drawn) {
        const Layout layout = layoutOf(drawn, drawn.tracks);
        const PruneResult pruned = pruneLayout(drawn.mesh, layout, drawn.angles, drawn.costs, options);
        expectLayout(drawn.mesh, pruned.layout);
        const std::vector<Track> expected = pruneSlowly(drawn, layout);
        const std::vector<Track> kept = tracksWithout(pruned.layout, pruned.layout.tracks.size());
        ASSERT_EQ(kept.size(), expected.size());
        for (std::size_t t = 0; t < kept.size(); ++t)
            EXPECT_EQ(kept[t].halfedges, expected[t].halfedges);
        EXPECT_EQ(pruned.removedTracks + pruned.keptNotQuadrilateral,
                  tracksWithout(layout, layout.tracks.size()).size());
        EXPECT_EQ(pruned.keptNotSmooth, 0U);
    });
}

TEST_P(RandomLayout, SmoothPruningLeavesGridsToo) {
    PruneOptions options;
    options.eta = 0;
    options.maxTurn = 60;
    forEachCase([&](const Case& drawn) {
        const Layout layout = layoutOf(drawn, drawn.tracks);
        const PruneResult pruned = pruneLayout(drawn.mesh, layout, drawn.angles, drawn.costs, options);
        expectLayout(drawn.mesh, pruned.layout);
        EXPECT_LE(pruned.layout.segments.size(), layout.segments.size());
    });
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomLayout, ::testing::Range(0U, 8U));

} // namespace
} // namespace qm::testing
