#include "base/at.h"
#include "check/mesh/neighbourhoods.h"
#include "check/tracks/lines.h"
#include "cut/cut.h"
#include "mesh/dihedral.h"
#include "mesh/topology.h"
#include "support/polycube.h"
#include "support/random_graph.h"
#include "support/shared_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace qm::test {
namespace {

constexpr std::array everyKind{Terminals::irregular, Terminals::farthest, Terminals::box};

CutOptions cutOptions(double chi, Terminals kind = Terminals::irregular) {
    CutOptions options;
    options.chi = chi;
    options.terminals = kind;
    return options;
}

Cut cutAt(const QuadMesh& mesh, const CutOptions& options, std::span<const Seed> seeds = {},
          const Control& control = {}) {
    return cutMesh(mesh, buildBaseComplex(mesh, seeds), dihedralAngles(mesh), options, control);
}

/// U and n_j must equal what the checker, which traces its own lines, computes from the labels.
void expectTrueFigures(const QuadMesh& mesh, std::span<const Seed> seeds,
                       const std::vector<SubMeshId>& labels, const IdVector<SubMeshId, SubMesh>& subMeshes) {
    const check::Neighbourhoods around(check::checkedMesh(mesh));
    check::TraceInput input;
    for (const Seed seed : seeds)
        input.seedSteps.push_back(around.stepBetween(mesh.from_vertex_handle(seed.direction).idx(),
                                                     mesh.to_vertex_handle(seed.direction).idx()));
    for (const SubMeshId label : labels)
        input.labels.push_back(label.value());
    input.subMeshes = static_cast<int>(subMeshes.size());
    const std::vector<check::LineNetwork> networks = check::traceLines(around, input);
    for (const SubMeshId id : subMeshes.ids()) {
        const check::LineNetwork& network = networks[id.idx()];
        EXPECT_EQ(subMeshes[id].ordinaryJunctions, network.ordinaryJunctions) << id.value();
        EXPECT_NEAR(subMeshes[id].quasiComplexity, check::quasiComplexity(network), 1e-9) << id.value();
    }
}

/// Every vertex must have a label and every label a vertex, and sub-meshes are ordered by their lowest
/// vertices.
void expectProperLabels(const QuadMesh& mesh, const Cut& cut) {
    ASSERT_EQ(cut.labels.size(), mesh.n_vertices());
    SubMeshId next(0);
    for (const VertexId vertex : mesh.vertices()) {
        if (mesh.is_isolated(vertex)) {
            EXPECT_EQ(cut.labels[at(vertex)], SubMeshId(0));
            continue;
        }
        ASSERT_TRUE(cut.labels[at(vertex)].valid());
        ASSERT_LE(cut.labels[at(vertex)], next);
        if (cut.labels[at(vertex)] == next) next = next + 1;
    }
    EXPECT_EQ(cut.subMeshes.size(), std::max<std::size_t>(next.idx(), 1));
}

double maxComplexity(const Cut& cut) {
    double max = 0;
    for (const SubMesh& subMesh : cut.subMeshes)
        max = std::max(max, subMesh.quasiComplexity);
    return max;
}

std::size_t junctions(const Cut& cut) {
    std::size_t sum = 0;
    for (const SubMesh& subMesh : cut.subMeshes)
        sum += subMesh.ordinaryJunctions;
    return sum;
}

/// A slab with two bumps at each end: 32 extraordinary vertices and many junctions.
check::CheckedMesh twoBumps(int n) {
    Cells cells = box(8, 3, 1);
    cells.push_back({1, 1, 1});
    cells.push_back({6, 1, 1});
    cells.push_back({4, 1, -1});
    return polycube(cells, n);
}

TEST(Measure, OfTheWholeMeshIsThatOfTheBaseComplex) {
    const QuadMesh mesh = quadMesh(polycube(bump(), 3));
    const BaseComplex complex = buildBaseComplex(mesh);
    const IdVector<SubMeshId, SubMesh> subMeshes =
        measureSubMeshes(mesh, complex, std::vector(mesh.n_vertices(), SubMeshId(0)), 1);
    ASSERT_EQ(subMeshes.size(), 1U);
    const SubMesh& whole = subMeshes.front();
    EXPECT_EQ(whole.ordinaryJunctions, 20U);
    EXPECT_EQ(whole.ordinaryJunctions, complex.ordinaryJunctions);
    EXPECT_FALSE(whole.source || whole.sink);
}

TEST(Measure, CountsNeighbouringVerticesAsStopsAndNothingBeyond) {
    // An L-shaped plane. The vertex where three squares meet is extraordinary; its two lines cross the plane.
    const QuadMesh mesh = quadMesh(plane({"xxxx", "xxxx", "xx..", "xx.."}));
    const BaseComplex complex = buildBaseComplex(mesh);
    ASSERT_EQ(complex.extraordinaryVertices.size(), 1U);
    // One particle runs each way and nothing crosses, so U = 0 for every division of the mesh.
    for (const int wall : {0, 1, 2}) {
        std::vector<SubMeshId> labels;
        for (const VertexId vertex : mesh.vertices())
            labels.emplace_back(mesh.point(vertex)[0] > wall ? 1 : 0);
        for (const SubMesh& subMesh : measureSubMeshes(mesh, complex, labels, 2)) {
            EXPECT_EQ(subMesh.quasiComplexity, 0);
            EXPECT_EQ(subMesh.ordinaryJunctions, 0U);
        }
    }
}

TEST(Measure, AgreesWithTheCheckerOnAnyLabels) {
    std::mt19937 random(21);
    std::size_t junctionsSeen = 0, divided = 0;
    for (int round = 0; round < 400; ++round) {
        const std::optional<QuadMesh> mesh = randomMesh(random);
        if (!mesh) continue;
        const std::vector<Seed> seeds = randomSeeds(*mesh, 3, random);
        const BaseComplex complex = buildBaseComplex(*mesh, seeds);
        const int count = 1 + round % 4;
        // Every vertex gets the label of a random centre with a similar number, which makes random patches.
        std::vector<SubMeshId> labels(mesh->n_vertices());
        std::uniform_int_distribution<int> any(0, count - 1), run(1, 12);
        for (std::size_t k = 0; k < labels.size();)
            for (int left = run(random), label = any(random); left > 0 && k < labels.size(); --left)
                labels[k++] = SubMeshId(label);
        const auto measured = measureSubMeshes(*mesh, complex, labels, count);
        expectTrueFigures(*mesh, seeds, labels, measured);
        divided += count > 1 ? 1 : 0;
        for (const SubMesh& subMesh : measured)
            junctionsSeen += subMesh.ordinaryJunctions;
        if (HasFailure()) return;
    }
    EXPECT_GT(junctionsSeen, 300U);
    EXPECT_GT(divided, 100U);
}

TEST(Cut, LeavesWhatIsSimpleInOnePiece) {
    const QuadMesh mesh = quadMesh(polycube(bump(), 3));
    for (const Terminals kind : everyKind) {
        const Cut cut = cutAt(mesh, cutOptions(1000, kind));
        EXPECT_EQ(cut.subMeshes.size(), 1U);
        EXPECT_FALSE(cut.subMeshes.front().source || cut.subMeshes.front().sink);
        EXPECT_EQ(cut.labels, std::vector(mesh.n_vertices(), SubMeshId(0)));
    }
}

TEST(Cut, MakesEverySubMeshSimpleEnough) {
    const QuadMesh mesh = quadMesh(twoBumps(4));
    const double whole = maxComplexity(cutAt(mesh, cutOptions(1e9)));
    ASSERT_GT(whole, 30);
    for (const Terminals kind : everyKind)
        for (const double share : {0.9, 0.5, 0.25}) {
            const Cut cut = cutAt(mesh, cutOptions(share * whole, kind));
            expectProperLabels(mesh, cut);
            expectTrueFigures(mesh, {}, cut.labels, cut.subMeshes);
            EXPECT_GT(cut.subMeshes.size(), 1U);
            EXPECT_LT(maxComplexity(cut), share * whole);
            for (const SubMesh& subMesh : cut.subMeshes) {
                ASSERT_TRUE(subMesh.source && subMesh.sink);
                EXPECT_NE(*subMesh.source, *subMesh.sink);
            }
        }
}

TEST(Cut, DividesADumbbellInTheMiddle) {
    // A long bar with bumps at both ends: the terminals are at the ends, so the cut crosses the middle.
    Cells cells = box(3, 3, 1);
    for (const auto& cell : box(3, 3, 1))
        cells.push_back({cell[0] + 12, cell[1], 0});
    for (int x = 3; x < 12; ++x)
        cells.push_back({x, 1, 0});
    cells.push_back({1, 1, 1});
    cells.push_back({13, 1, 1});
    const QuadMesh mesh = quadMesh(polycube(cells, 2));
    VertexId leftmost(0), rightmost(0);
    for (const VertexId vertex : mesh.vertices()) {
        if (mesh.point(vertex)[0] < mesh.point(leftmost)[0]) leftmost = vertex;
        if (mesh.point(vertex)[0] > mesh.point(rightmost)[0]) rightmost = vertex;
    }
    const double whole = maxComplexity(cutAt(mesh, cutOptions(1e9)));
    for (const Terminals kind : {Terminals::irregular, Terminals::farthest}) {
        const Cut cut = cutAt(mesh, cutOptions(whole, kind)); // U >= chi holds for the whole mesh only
        ASSERT_EQ(cut.subMeshes.size(), 2U);
        for (const VertexId vertex : mesh.vertices()) {
            const double x = mesh.point(vertex)[0];
            const VertexId like(x < 6 ? leftmost : rightmost);
            if (x < 6 || x > 9) {
                EXPECT_EQ(cut.labels[at(vertex)], cut.labels[at(like)]) << x;
            }
        }
        EXPECT_NE(cut.labels[at(leftmost)], cut.labels[at(rightmost)]);
    }
}

TEST(Cut, EndsWhateverChiIs) {
    for (const Terminals kind : everyKind)
        for (const double chi : {0.0, 1e-9, 1.0}) {
            const QuadMesh mesh = quadMesh(twoBumps(2));
            const Cut cut = cutAt(mesh, cutOptions(chi, kind));
            expectProperLabels(mesh, cut);
            expectTrueFigures(mesh, {}, cut.labels, cut.subMeshes);
        }
}

TEST(Cut, KeepsWhatGetsNoSimplerAndReportsIt) {
    // On this smallest mesh no cut helps, because particles can stop beyond it as well.
    const QuadMesh mesh = quadMesh(polycube(bump(), 1));
    const Cut whole = cutAt(mesh, cutOptions(1e9));
    const Cut cut = cutAt(mesh, cutOptions(0));
    expectProperLabels(mesh, cut);
    for (const SubMesh& subMesh : cut.subMeshes)
        EXPECT_LE(subMesh.quasiComplexity, maxComplexity(whole));
}

TEST(Cut, IsTheSameEveryTimeAndWithAnyNumberOfThreads) {
    const QuadMesh mesh = quadMesh(twoBumps(3));
    for (const Terminals kind : everyKind) {
        const Cut first = cutAt(mesh, cutOptions(8, kind));
        for (const unsigned jobs : {1U, 4U}) {
            Control control;
            control.jobs = jobs;
            const Cut again = cutAt(mesh, cutOptions(8, kind), {}, control);
            EXPECT_EQ(first.labels, again.labels);
            EXPECT_EQ(first.subMeshes.size(), again.subMeshes.size());
        }
    }
}

TEST(Cut, GivesComponentsWithParticlesSubMeshesOfTheirOwn) {
    // Three components with particles, and two without.
    const QuadMesh mesh = quadMesh(
        together({torus(4, 4), twoBumps(2), polycube(bump(), 2), torus(5, 3), polycube(box(1, 1, 1), 2)}));
    const Components parts = components(mesh);
    ASSERT_EQ(parts.count, 5);
    const double whole = maxComplexity(cutAt(mesh, cutOptions(1e9)));
    const Cut cut = cutAt(mesh, cutOptions(whole));
    expectProperLabels(mesh, cut);
    expectTrueFigures(mesh, {}, cut.labels, cut.subMeshes);
    EXPECT_EQ(cut.subMeshes.size(), 4U);
    std::map<SubMeshId, std::set<int>> componentsOf;
    for (const VertexId vertex : mesh.vertices())
        componentsOf[cut.labels[at(vertex)]].insert(parts.ofVertex[at(vertex)]);
    EXPECT_EQ(componentsOf[SubMeshId(0)], (std::set<int>{0, 3}));
    EXPECT_EQ(componentsOf[SubMeshId(1)], (std::set<int>{1}));
    EXPECT_FALSE(cut.subMeshes.front().source || cut.subMeshes.front().sink);
}

TEST(Cut, PassesOverIsolatedVertices) {
    check::CheckedMesh list = twoBumps(3);
    for (const double place : {-5.0, 0.3, 50.0})
        list.points.push_back({place, place, place});
    for (auto& quad : list.quads) // the first is one of them
        for (int& corner : quad)
            ++corner;
    list.points.insert(list.points.begin(), {9, 9, 9});
    const QuadMesh mesh = quadMesh(list);
    const QuadMesh without = quadMesh(twoBumps(3));
    for (const Terminals kind : everyKind) {
        const Cut cut = cutAt(mesh, cutOptions(8, kind));
        expectProperLabels(mesh, cut);
        const std::vector<SubMeshId> inner(cut.labels.begin() + 1, cut.labels.end() - 3);
        EXPECT_EQ(inner, cutAt(without, cutOptions(8, kind)).labels);
    }
}

TEST(Cut, OfMeshesWithoutParticlesIsOneSubMesh) {
    QuadMesh points;
    points.add_vertex({0, 0, 0});
    points.add_vertex({1, 0, 0});
    for (const QuadMesh& mesh : {quadMesh(torus(5, 4)), points}) {
        const Cut cut = cutAt(mesh, cutOptions(0));
        ASSERT_EQ(cut.subMeshes.size(), 1U);
        EXPECT_EQ(cut.labels, std::vector(mesh.n_vertices(), SubMeshId(0)));
    }
    EXPECT_TRUE(cutAt(QuadMesh(), cutOptions(0)).subMeshes.empty());
}

TEST(Cut, TakesSeedsAsTerminalsOnlyWhereThereIsNothingElse) {
    // A torus has no extraordinary vertex; its particles start at seeds.
    const QuadMesh mesh = quadMesh(torus(40, 12));
    std::vector<Seed> seeds;
    for (const int vertex : {0, 65, 133, 210, 290, 377}) {
        const HalfedgeId along = mesh.halfedge_handle(VertexId(vertex));
        seeds.push_back({vertex % 2 == 0 ? along : mesh.ccw_rotated_halfedge_handle(along)});
    }
    const double whole = maxComplexity(cutAt(mesh, cutOptions(1e9), seeds));
    ASSERT_GT(whole, 4);
    for (const Terminals kind : everyKind) {
        const Cut cut = cutAt(mesh, cutOptions(whole / 2, kind), seeds);
        expectProperLabels(mesh, cut);
        expectTrueFigures(mesh, seeds, cut.labels, cut.subMeshes);
        EXPECT_LT(maxComplexity(cut), whole / 2);
    }
}

TEST(Cut, HoldsOnRandomMeshes) {
    std::mt19937 random(31);
    std::size_t several = 0;
    for (int round = 0; round < 300; ++round) {
        const std::optional<QuadMesh> mesh = randomMesh(random);
        if (!mesh) continue;
        const std::vector<Seed> seeds = randomSeeds(*mesh, 3, random);
        const double whole = maxComplexity(cutAt(*mesh, cutOptions(1e9), seeds));
        CutOptions options = cutOptions(whole * (round % 5) / 5, everyKind[at(round) % 3]);
        options.avoidFeatures = round % 2 == 0;
        const Cut cut = cutAt(*mesh, options, seeds);
        expectProperLabels(*mesh, cut);
        expectTrueFigures(*mesh, seeds, cut.labels, cut.subMeshes);
        EXPECT_LE(maxComplexity(cut), whole);
        several += cut.subMeshes.size() > 1 ? 1 : 0;
        if (HasFailure()) return;
    }
    EXPECT_GT(several, 50U);
}

TEST(Cut, StopsWhenAskedTo) {
    const QuadMesh mesh = quadMesh(twoBumps(3));
    for (const int allowed : {0, 1, 3}) {
        Control control;
        int asked = 0;
        control.stopRequested = [&] { return asked++ >= allowed; };
        const Cut cut = cutAt(mesh, cutOptions(0), {}, control);
        expectProperLabels(mesh, cut);
        expectTrueFigures(mesh, {}, cut.labels, cut.subMeshes);
        EXPECT_LE(cut.subMeshes.size(), static_cast<std::size_t>(allowed) + 1);
    }
}

TEST(Cut, ReportsProgressUpToTheEnd) {
    const QuadMesh mesh = quadMesh(twoBumps(3));
    std::vector<double> reported;
    Control control;
    control.progress = [&](double fraction) { reported.push_back(fraction); };
    const Cut cut = cutAt(mesh, cutOptions(5), {}, control);
    ASSERT_FALSE(reported.empty());
    EXPECT_EQ(reported.back(), 1);
    for (const double fraction : reported)
        EXPECT_TRUE(fraction >= 0 && fraction <= 1);
}

/// The number of quads with a sharp edge on one side of the cut and the opposite edge on the other.
std::size_t stepsAlongFeatures(const QuadMesh& mesh, const std::vector<double>& angles,
                               const std::vector<SubMeshId>& labels) {
    std::size_t steps = 0;
    for (const HalfedgeId halfedge : mesh.halfedges()) {
        if (mesh.is_boundary(halfedge) || angles[at(mesh.edge_handle(halfedge))] < 0.5) continue;
        const HalfedgeId next = mesh.next_halfedge_handle(halfedge);
        const SubMeshId a = labels[at(mesh.from_vertex_handle(halfedge))],
                        b = labels[at(mesh.to_vertex_handle(halfedge))];
        const SubMeshId c = labels[at(mesh.to_vertex_handle(next))],
                        d = labels[at(mesh.to_vertex_handle(mesh.next_halfedge_handle(next)))];
        if (a == b && c != a && d != a) ++steps;
    }
    return steps;
}

TEST(Cut, KeepsOffFeaturesIfAsked) {
    const QuadMesh mesh = quadMesh(twoBumps(6));
    const std::vector<double> angles = dihedralAngles(mesh);
    CutOptions options = cutOptions(15);
    const Cut plain = cutAt(mesh, options);
    options.avoidFeatures = true;
    const Cut avoiding = cutAt(mesh, options);
    const std::size_t before = stepsAlongFeatures(mesh, angles, plain.labels);
    ASSERT_GT(before, 0U);
    EXPECT_LT(stepsAlongFeatures(mesh, angles, avoiding.labels), before);
    EXPECT_LT(maxComplexity(avoiding), 15);
}

TEST(Cut, SimplifiesRealMeshes) {
    for (const char* name : {"dev/fandisk_qex.obj", "dev/rockerarm_qf_1k.obj", "dev/botijo_miq.obj"}) {
        const std::optional<check::CheckedMesh> list = sharedMesh(name);
        if (!list) GTEST_SKIP() << "there are no real meshes here";
        const QuadMesh mesh = quadMesh(*list);
        const std::size_t before = buildBaseComplex(mesh).ordinaryJunctions;
        std::size_t last = before;
        for (const double chi : {60.0, 20.0}) {
            const Cut cut = cutAt(mesh, cutOptions(chi));
            expectProperLabels(mesh, cut);
            expectTrueFigures(mesh, {}, cut.labels, cut.subMeshes);
            EXPECT_LT(maxComplexity(cut), chi);
            EXPECT_LT(junctions(cut), last) << name;
            last = junctions(cut);
        }
        EXPECT_LT(last, before / 4) << name;
    }
}

} // namespace
} // namespace qm::test
