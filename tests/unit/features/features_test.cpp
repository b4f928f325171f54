#include "base/at.h"
#include "features/features.h"
#include "mesh/topology.h"
#include "support/polycube.h"
#include "support/random_graph.h"
#include "support/track_along.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numbers>
#include <set>

namespace qm::test {
namespace {

constexpr double sharp = 1;

/// Options for curves of at least `tau` edges sharper than 0.5, with ends more than `zeta` edges from
/// sources.
FeatureOptions limits(int tau, int zeta) {
    return {0.5, {0, true}, {0, true}, tau, std::numbers::pi, zeta, 1};
}

std::vector<Path> paths(const QuadMesh& mesh, const Features& features) {
    std::vector<Path> result;
    for (const FeatureCurve& curve : features.curves)
        result.push_back(numbers(verticesAlong(mesh, curve.halfedges)));
    return result;
}

Path reversed(Path path) {
    std::ranges::reverse(path);
    return path;
}

void expectOneCurve(const QuadMesh& mesh, const Features& features, const Path& path, int seed) {
    const std::vector<Path> found = paths(mesh, features);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_TRUE(found[0] == path || found[0] == reversed(path));
    EXPECT_EQ(features.curves[0].seed.idx(), seed);
}

/// A part of a row of vertices in a rectangle with so many columns.
Path row(int columns, int j, int first, int last) {
    Path path;
    for (int i = first; i <= last; ++i)
        path.push_back(j * (columns + 1) + i);
    return path;
}

TEST(Features, AreRunsOfSharpEdgesOnALine) {
    const QuadMesh mesh = rectangle(8, 2);
    const PerEdge angles = PerEdge(mesh, 0.1).along(row(8, 1, 2, 6), sharp);
    expectOneCurve(mesh, findFeatures(mesh, angles, limits(4, 0)), {11, 12, 13, 14, 15}, 13);
    EXPECT_TRUE(findFeatures(mesh, angles, limits(5, 0)).curves.empty());
}

TEST(Features, AreSharperThanRhoNotEquallySharp) {
    const QuadMesh mesh = rectangle(8, 2);
    const PerEdge angles = PerEdge(mesh, 0.1).along(row(8, 1, 2, 6), 0.5);
    EXPECT_TRUE(findFeatures(mesh, angles, limits(1, 0)).curves.empty());
}

TEST(Features, MayBeShortBetweenBoundariesAndOtherSharpEdges) {
    const QuadMesh mesh = rectangle(8, 4);
    FeatureOptions options = limits(6, 0);
    options.shortRho = 0.9;
    const auto count = [&](const PerEdge& angles) {
        return findFeatures(mesh, angles, options).curves.size();
    };
    const Path across{4, 13, 22, 31, 40}; // from boundary to boundary
    EXPECT_EQ(count(PerEdge(mesh, 0.1).along(across, sharp)), 1U);
    EXPECT_EQ(count(PerEdge(mesh, 0.1).along(across, 0.9)), 0U) << "not sharp enough";
    EXPECT_EQ(count(PerEdge(mesh, 0.1).along({4, 13, 22}, sharp)), 0U) << "a loose end";
    // Up from the boundary to a longer line.
    EXPECT_EQ(count(PerEdge(mesh, 0.1).along({4, 13, 22}, sharp).along(row(8, 2, 0, 8), sharp)), 2U);
    EXPECT_EQ(count(PerEdge(mesh, 0.1).along({4, 13, 22}, sharp).along(row(8, 2, 0, 8), 0.8)), 1U)
        << "the line that it ends on is not as sharp";
}

TEST(Features, OfChamferedCornersMayBeShort) {
    const QuadMesh mesh = rectangle(8, 4);
    const PerEdge angles = PerEdge(mesh, 0.1).along({4, 13, 22, 31, 40}, std::numbers::pi / 4);
    EXPECT_EQ(findFeatures(mesh, angles, FeatureOptions{}).curves.size(), 1U);
}

TEST(Features, AreDividedWhereSharpLinesCross) {
    const QuadMesh mesh = rectangle(8, 4);
    FeatureOptions options = limits(6, 0);
    options.shortRho = 0.9;
    const auto lengths = [&](double below, double above, int column) {
        const PerEdge angles = PerEdge(mesh, 0.1)
                                   .along(row(8, 2, 0, 8), sharp)
                                   .along({9 + column, 18 + column}, below)
                                   .along({18 + column, 27 + column}, above);
        std::vector<std::size_t> result;
        for (const FeatureCurve& curve : findFeatures(mesh, angles, options).curves)
            result.push_back(curve.halfedges.size());
        return result;
    };
    using Lengths = std::vector<std::size_t>;
    EXPECT_EQ(lengths(sharp, sharp, 3), (Lengths{3, 5}));
    EXPECT_EQ(lengths(0.6, sharp, 3), (Lengths{3, 5}))
        << "above rho on one side, above short-rho on the other";
    EXPECT_EQ(lengths(0.4, sharp, 3), (Lengths{8})) << "it ends at the curve";
    EXPECT_EQ(lengths(0.6, 0.6, 3), (Lengths{8})) << "not sharp enough";
    EXPECT_EQ(lengths(sharp, sharp, 1), (Lengths{8})) << "a single edge makes no part";
    options.shortRho = std::numbers::pi;
    EXPECT_EQ(lengths(sharp, sharp, 3), (Lengths{8})) << "the paper's curves are whole";
}

TEST(Features, ThatAreClosedAreDividedWhereSharpLinesCross) {
    const QuadMesh mesh = quadMesh(tube(6, 3));
    FeatureOptions options = limits(6, 0);
    options.shortRho = 0.9;
    const PerEdge ring = PerEdge(mesh, 0.1).along({6, 7, 8, 9, 10, 11, 6}, sharp);
    const auto curves = [&](const PerEdge& angles) { return findFeatures(mesh, angles, options).curves; };
    ASSERT_EQ(curves(ring).size(), 1U);
    const PerEdge once = PerEdge(ring).along({2, 8, 14}, sharp);
    ASSERT_EQ(curves(once).size(), 1U);
    EXPECT_EQ(curves(once).front().seed, VertexId(11)) << "opposite the crossing";
    const PerEdge twice = PerEdge(once).along({4, 10, 16}, sharp);
    ASSERT_EQ(curves(twice).size(), 2U);
    EXPECT_EQ(curves(twice)[0].halfedges.size() + curves(twice)[1].halfedges.size(), 6U);
}

TEST(Features, AreDividedByABluntEdge) {
    const QuadMesh mesh = rectangle(8, 2);
    const PerEdge angles = PerEdge(mesh, 0.1).along(row(8, 1, 0, 8), sharp).along(row(8, 1, 4, 5), 0.5);
    const Features features = findFeatures(mesh, angles, limits(1, 0));
    EXPECT_EQ(features.curves.size(), 2U);
    EXPECT_EQ(features.curves[0].halfedges.size() + features.curves[1].halfedges.size(), 7U);
}

TEST(Features, DoNotTurn) {
    const QuadMesh mesh = rectangle(4, 4);
    const PerEdge angles = PerEdge(mesh, 0.1).along({11, 12, 17}, sharp); // along, then up
    for (const FeatureCurve& curve : findFeatures(mesh, angles, limits(1, 0)).curves)
        EXPECT_EQ(curve.halfedges.size(), 1U);
    EXPECT_TRUE(findFeatures(mesh, angles, limits(2, 0)).curves.empty());
}

TEST(Features, AreFarFromExtraordinaryVerticesWhereTheBoundaryComesFirst) {
    const QuadMesh mesh = rectangle(8, 2);
    const PerEdge angles = PerEdge(mesh, 0.1).along(row(8, 1, 0, 8), sharp);
    expectOneCurve(mesh, findFeatures(mesh, angles, limits(8, 1000)), row(8, 1, 0, 8), 13);
}

/// A cube with 10 x 10 quads per side; its edges are lines of ten mesh edges between extraordinary vertices.
struct Cube {
    QuadMesh mesh = quadMesh(polycube(box(1, 1, 1), 10));
    Path edge; ///< vertices

    Cube() {
        for (int k = 0; k <= 10; ++k)
            for (const VertexId vertex : mesh.vertices())
                if ((mesh.point(vertex) - Point(k / 10.0, 0, 0)).norm() < 1e-9) edge.push_back(vertex.idx());
    }
};

TEST(Features, KeepMoreThanZetaEdgesFromExtraordinaryVertices) {
    const Cube cube;
    ASSERT_EQ(cube.edge.size(), 11U);
    const Path run(cube.edge.begin() + 3, cube.edge.begin() + 8); // 3 edges before it, 3 after it
    const PerEdge angles = PerEdge(cube.mesh, 0).along(run, sharp);
    expectOneCurve(cube.mesh, findFeatures(cube.mesh, angles, limits(1, 2)), run, run[2]);
    EXPECT_TRUE(findFeatures(cube.mesh, angles, limits(1, 3)).curves.empty());
}

TEST(Features, KeepTheDistanceAtBothEnds) {
    const Cube cube;
    const Path run(cube.edge.begin() + 1, cube.edge.begin() + 6); // 1 edge before it, 5 after it
    const PerEdge angles = PerEdge(cube.mesh, 0).along(run, sharp);
    EXPECT_EQ(findFeatures(cube.mesh, angles, limits(1, 0)).curves.size(), 1U);
    EXPECT_TRUE(findFeatures(cube.mesh, angles, limits(1, 1)).curves.empty());
}

TEST(Features, DoNotEndAtExtraordinaryVertices) {
    const Cube cube;
    EXPECT_TRUE(
        findFeatures(cube.mesh, PerEdge(cube.mesh, 0).along(cube.edge, sharp), limits(1, 0)).curves.empty());
}

TEST(Features, MayBeClosedLoops) {
    const QuadMesh mesh = quadMesh(torus(7, 5));
    {
        // All lines of a torus are closed.
        Path loop{0};
        HalfedgeId halfedge = mesh.halfedge_handle(VertexId(0));
        do {
            loop.push_back(mesh.to_vertex_handle(halfedge).idx());
            halfedge = straightOn(mesh, halfedge);
        } while (loop.back() != 0);
        const int length = static_cast<int>(loop.size()) - 1;
        const Features whole = findFeatures(mesh, PerEdge(mesh, 0).along(loop, sharp), limits(length, 1000));
        ASSERT_EQ(whole.curves.size(), 1U);
        EXPECT_EQ(paths(mesh, whole)[0].front(), paths(mesh, whole)[0].back());
        EXPECT_EQ(whole.curves[0].halfedges.size(), static_cast<std::size_t>(length));

        // A closed line with a single blunt edge, wherever it is, has one run, which passes the line's first
        // vertex.
        for (int gap = 0; gap < length; ++gap) {
            const PerEdge angles =
                PerEdge(mesh, 0).along(loop, sharp).along({loop[at(gap)], loop[at(gap) + 1]}, 0);
            const Features open = findFeatures(mesh, angles, limits(1, 1000));
            ASSERT_EQ(open.curves.size(), 1U) << gap;
            EXPECT_EQ(open.curves[0].halfedges.size(), static_cast<std::size_t>(length - 1)) << gap;
        }
    }
}

TEST(Features, TakeSeedsThatDiffer) {
    const QuadMesh mesh = rectangle(6, 6);
    const PerEdge angles =
        PerEdge(mesh, 0).along(row(6, 3, 0, 6), sharp).along({3, 10, 17, 24, 31, 38, 45}, sharp);
    const Features features = findFeatures(mesh, angles, limits(6, 0));
    ASSERT_EQ(features.curves.size(), 2U);
    EXPECT_EQ(features.curves[0].seed.idx(), 24); // where they cross
    EXPECT_NE(features.curves[1].seed.idx(), 24);
    EXPECT_NO_THROW((void)buildBaseComplex(mesh, seeds(mesh, features)));
}

TEST(Features, WithoutAPlaceForASeedAreLeftOut) {
    const QuadMesh mesh = rectangle(1, 3); // lines across have boundary vertices only
    const PerEdge angles = PerEdge(mesh, 0).along({2, 3}, sharp);
    EXPECT_TRUE(findFeatures(mesh, angles, limits(1, 0)).curves.empty());
}

TEST(Features, OfAMeshWithoutFacesAreNone) {
    EXPECT_TRUE(findFeatures(QuadMesh(), {}, limits(1, 0)).curves.empty());
}

/// The same, following the method literally: from every edge to both sides along its line.
class ByTheLetter {
public:
    struct Run {
        double rho; ///< its edges are sharper
        std::set<int> edges;
        bool closed = false;
    };

    ByTheLetter(const QuadMesh& mesh, const std::vector<double>& angles, const FeatureOptions& options)
        : mesh_(mesh), angles_(angles), options_(options) {}

    /// All long runs, before they are divided, wherever they end.
    std::vector<Run> runs() const {
        std::map<std::set<int>, Run> result;
        for (const EdgeId edge : mesh_.edges()) {
            Run run = runOf(edge, options_.rho);
            if (static_cast<int>(run.edges.size()) < options_.tau) {
                run = runOf(edge, options_.shortRho);
                if (!isHeld(run.edges)) continue;
            }
            double length = 0;
            for (const int part : run.edges)
                length += mesh_.calc_edge_length(EdgeId(part));
            if (length > options_.minLength.value) result.emplace(run.edges, run);
        }
        std::vector<Run> list;
        for (const auto& [edges, run] : result)
            list.push_back(run);
        return list;
    }

    /// Whether a curve is a run, or a part of one with two edges or more, from end to end or crossing; it has
    /// no crossing that divides it, with other vertices on both sides, and its ends are far from sources.
    bool isCurveOf(const Run& run, const std::vector<HalfedgeId>& curve) const {
        for (const HalfedgeId halfedge : curve)
            if (!run.edges.contains(mesh_.edge_handle(halfedge).idx())) return false;
        const auto isFree = [&](HalfedgeId halfedge) { return !isCrossed(halfedge); };
        for (auto i = curve.begin(); i + 1 < curve.end(); ++i)
            if (isCrossed(*i) && std::any_of(curve.begin(), i, isFree) &&
                std::any_of(i + 1, curve.end() - 1, isFree))
                return false;
        const bool isWhole = curve.size() == run.edges.size();
        if (isWhole && run.closed) return true;
        if (!isWhole && curve.size() < 2) return false;
        for (const HalfedgeId end : {curve.back(), mesh_.opposite_halfedge_handle(curve.front())})
            if (!(isCrossed(end) || isLast(end, run.rho)) || !(run.closed || isFar(end))) return false;
        return true;
    }

    /// Whether all parts of a run are far from sources.
    bool isFarAsAWhole(const Run& run) const {
        if (run.closed) return true;
        for (const int edge : run.edges)
            for (const unsigned side : {0U, 1U}) {
                const HalfedgeId halfedge = mesh_.halfedge_handle(EdgeId(edge), side);
                if (isLast(halfedge, run.rho) && !isFar(halfedge)) return false;
            }
        return true;
    }

private:
    bool isSharp(EdgeId edge, double rho) const {
        return !mesh_.is_boundary(edge) && angles_[at(edge)] > rho;
    }

    /// The edges sharper than rho on both sides of an edge; none if it is not.
    Run runOf(EdgeId edge, double rho) const {
        Run run{rho, {}};
        if (!isSharp(edge, rho)) return run;
        run.edges.insert(edge.idx());
        for (const unsigned side : {0U, 1U}) {
            HalfedgeId halfedge = mesh_.halfedge_handle(edge, side);
            while (!isLast(halfedge, rho) && !run.closed) {
                halfedge = straightOn(mesh_, halfedge);
                run.closed = !run.edges.insert(mesh_.edge_handle(halfedge).idx()).second;
            }
        }
        return run;
    }

    /// Whether there are edges, and their ends are at the boundary or at others sharper than `shortRho`.
    bool isHeld(const std::set<int>& run) const {
        if (run.empty()) return false;
        for (const VertexId vertex : mesh_.vertices()) {
            std::size_t own = 0;
            std::size_t others = 0;
            for (const EdgeId edge : mesh_.ve_range(vertex)) {
                if (run.contains(edge.idx()))
                    ++own;
                else if (angles_[at(edge)] > options_.shortRho)
                    ++others;
            }
            if (own == 1 && others == 0 && !mesh_.is_boundary(vertex)) return false;
        }
        return true;
    }

    /// Whether both edges across the end of a halfedge are sharp, and one sharper than `shortRho`.
    bool isCrossed(HalfedgeId halfedge) const {
        const VertexId vertex = mesh_.to_vertex_handle(halfedge);
        if (!continuesStraight(mesh_, vertex)) return false;
        const EdgeId own = mesh_.edge_handle(halfedge);
        const EdgeId ahead = mesh_.edge_handle(straightOn(mesh_, halfedge));
        double sharpest = 0;
        for (const EdgeId edge : mesh_.ve_range(vertex)) {
            if (edge == own || edge == ahead) continue;
            if (!isSharp(edge, options_.rho)) return false;
            sharpest = std::max(sharpest, angles_[at(edge)]);
        }
        return sharpest > options_.shortRho;
    }

    /// Whether a run of edges sharper than rho ends with a halfedge.
    bool isLast(HalfedgeId halfedge, double rho) const {
        return !continuesStraight(mesh_, mesh_.to_vertex_handle(halfedge)) ||
               !isSharp(mesh_.edge_handle(straightOn(mesh_, halfedge)), rho);
    }

    /// Whether the line beyond a halfedge is free of extraordinary vertices, or crossed at once.
    bool isFar(HalfedgeId halfedge) const {
        if (isCrossed(halfedge)) return true;
        double length = 0;
        for (int distance = 0; distance <= options_.zeta || length < options_.minDistance.value; ++distance) {
            const VertexId vertex = mesh_.to_vertex_handle(halfedge);
            if (!isRegular(mesh_, vertex)) return false;
            if (mesh_.is_boundary(vertex)) return true;
            halfedge = straightOn(mesh_, halfedge);
            length += mesh_.calc_edge_length(halfedge);
            if (distance > static_cast<int>(mesh_.n_edges())) return true; // a closed line
        }
        return true;
    }

    const QuadMesh& mesh_;
    const std::vector<double>& angles_;
    const FeatureOptions& options_;
};

TEST(Features, AgreeWithTheLetterOfTheMethod) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> angle(0, 1);
    std::size_t found = 0;
    std::size_t divided = 0;
    for (int round = 0; round < 400; ++round) {
        const std::optional<QuadMesh> mesh = randomMesh(random);
        if (!mesh) continue;
        const double share = angle(random);
        std::vector<double> angles(mesh->n_edges());
        for (const EdgeId edge : mesh->edges())
            angles[at(edge)] = mesh->is_boundary(edge) || angle(random) > share ? 0
                               : angle(random) < 0.3                            ? 0.8
                                                                                : sharp;
        FeatureOptions options = limits(1 + round % 4, round % 3);
        // These lengths are far from all sums of edge lengths, so rounding cannot decide.
        if (round % 2 == 0) options.minLength = {1.2345 * (round % 5), false};
        if (round % 7 < 3) options.minDistance = {0.98765 * (round % 7), false};
        if (round % 5 < 2) options.shortRho = 0.9;
        const Features features = findFeatures(*mesh, angles, options);
        const ByTheLetter letter(*mesh, angles, options);
        const std::vector<ByTheLetter::Run> runs = letter.runs();

        std::set<VertexId> seeded;
        std::set<int> onCurves;
        int lowestBefore = -1;
        for (const FeatureCurve& curve : features.curves) {
            std::set<int> edges;
            for (const HalfedgeId halfedge : curve.halfedges)
                edges.insert(mesh->edge_handle(halfedge).idx());
            ASSERT_EQ(edges.size(), curve.halfedges.size());
            ASSERT_GT(*edges.begin(), lowestBefore);
            lowestBefore = *edges.begin();
            const auto run = std::ranges::find_if(
                runs, [&](const ByTheLetter::Run& one) { return letter.isCurveOf(one, curve.halfedges); });
            ASSERT_NE(run, runs.end());
            if (edges.size() < run->edges.size()) ++divided;
            for (const int edge : edges)
                ASSERT_TRUE(onCurves.insert(edge).second);
            ASSERT_TRUE(continuesStraight(*mesh, curve.seed));
            ASSERT_TRUE(seeded.insert(curve.seed).second);
        }
        // Missing curves have no vertex for a seed.
        for (const ByTheLetter::Run& run : runs) {
            if (!letter.isFarAsAWhole(run)) continue;
            for (const int edge : run.edges) {
                if (onCurves.contains(edge)) continue;
                for (const unsigned side : {0U, 1U}) {
                    const VertexId vertex = mesh->to_vertex_handle(mesh->halfedge_handle(EdgeId(edge), side));
                    EXPECT_TRUE(seeded.contains(vertex) || !continuesStraight(*mesh, vertex));
                }
            }
        }
        found += features.curves.size();
        EXPECT_NO_THROW((void)buildBaseComplex(*mesh, seeds(*mesh, features)));
    }
    EXPECT_GT(found, 200U);
    EXPECT_GT(divided, 20U);
}

} // namespace
} // namespace qm::test
