// The work of every stage must not grow much faster than the mesh. Allocated bytes are counted, because
// anything that copies or collects parts of the mesh for every element shows in them, on every machine alike.
#include "bspline/reference/planes/plane_growth.h"
#include "cut/cut.h"
#include "enumerate/enumerate.h"
#include "enumerate/relaxation/column_state.h"
#include "enumerate/state/independent_parts.h"
#include "features/features.h"
#include "layout/layout.h"
#include "merge/merge.h"
#include "mesh/dihedral.h"
#include "prune/prune.h"
#include "shape/shape.h"
#include "support/grid_layout.h"
#include "support/polycube.h"
#include "support/random_graph.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <map>
#include <new>
#include <string>

namespace {
std::atomic<std::size_t> bytesTaken = 0;
}

// With sanitizers GCC takes blocks allocated by these functions for those of the library.
#ifdef __GNUC__
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
#endif
// NOLINTBEGIN(cppcoreguidelines-no-malloc,cppcoreguidelines-owning-memory,misc-new-delete-overloads)
void* operator new(std::size_t size) {
    bytesTaken += size;
    if (void* place = std::malloc(size == 0 ? 1 : size)) return place;
    throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t& /*tag*/) noexcept {
    bytesTaken += size;
    return std::malloc(size == 0 ? 1 : size);
}
void operator delete(void* place) noexcept {
    std::free(place);
}
void operator delete(void* place, std::size_t) noexcept {
    std::free(place);
}
// NOLINTEND(cppcoreguidelines-no-malloc,cppcoreguidelines-owning-memory,misc-new-delete-overloads)

namespace qm::test {
namespace {

/// The bytes that every stage allocates for a solid of so many cubes, whose extraordinary vertices grow with
/// it.
std::map<std::string, double> bytesOfStages(int voxels) {
    std::map<std::string, double> bytes;
    std::size_t before = 0;
    const auto done = [&](const std::string& stage) {
        bytes[stage] = static_cast<double>(bytesTaken - before);
        before = bytesTaken;
    };
    const QuadMesh mesh = makeShape("random", {1, 0, 5, voxels});
    const std::vector<double> angles = dihedralAngles(mesh);
    bytes["quads"] = static_cast<double>(mesh.n_faces());
    before = bytesTaken;
    const BaseComplex complex = buildBaseComplex(mesh);
    done("base complex");
    (void)findFeatures(mesh, angles, {});
    done("features");
    CutOptions cutting;
    cutting.chi = 20;
    const Cut cut = cutMesh(mesh, complex, angles, cutting);
    done("cut");
    const SubMeshes parts{cut.labels, static_cast<int>(cut.subMeshes.size())};
    Control control;
    control.jobs = 1;
    const Enumeration found = enumerateGraphs({mesh, complex, angles, parts, {}}, {}, control);
    done("enumeration");
    const MergeResult merged =
        mergeGraphs({mesh, complex, angles, parts, {}}, found, cutting.chi, {}, control);
    done("merge");
    const std::vector<double> costs = edgeCosts(angles, {});
    const Layout layout = buildLayout(mesh, merged.graph.tracks, angles, costs);
    done("layout");
    (void)pruneLayout({mesh, complex, angles, costs}, layout, {}, control);
    done("prune");
    return bytes;
}

/// The bytes that the formulations of all parts of a search problem allocate, for solids that nothing
/// connects.
double bytesOfFormulations(std::size_t solids) {
    const QuadMesh mesh = quadMesh(together(std::vector(solids, polycube(bump()))));
    const ArcGraph graph = buildArcGraph(mesh, buildBaseComplex(mesh));
    const IdVector<ArcId, double> costs(graph.arcs.size(), 1);
    const Problem problem = makeProblem({graph, costs, {}, {}, {}, {}});
    SearchState state(problem);
    const auto parts = independentParts(state);
    EXPECT_GE(parts.size(), solids);
    const std::size_t before = bytesTaken;
    for (const std::vector<VariableId>& part : parts)
        EXPECT_TRUE(ColumnState(state, formulate(state, part)).consistent());
    return static_cast<double>(bytesTaken - before);
}

TEST(Growth, AFormulationTakesNoMoreThanItsPart) {
    constexpr double maxGrowth = 1.01;
    EXPECT_LE(bytesOfFormulations(400), 4 * maxGrowth * bytesOfFormulations(100));
}

/// The bytes that the search for planes allocates on a sheet of so many quads along and across, which bends
/// everywhere, but slowly.
double bytesOfPlanes(int quads) {
    const QuadMesh mesh = makeMesh({quads, quads, [&](double i, double j) {
                                        const double x = i / quads, y = j / quads;
                                        return Point(x, y, 0.1 * (x * x + y * y));
                                    }});
    std::vector<bool> isCrease(mesh.n_edges());
    for (const EdgeId edge : mesh.edges())
        isCrease[at(edge)] = mesh.is_boundary(edge);
    std::vector<FlatQuad> flat;
    for (const FaceId face : mesh.faces())
        flat.push_back({mesh.calc_face_normal(face), 1});
    constexpr double flatness = 2e-3;
    const std::size_t before = bytesTaken;
    (void)grownPlaneParts(mesh, isCrease, flat, flatness, 1);
    return static_cast<double>(bytesTaken - before);
}

TEST(Growth, PlanesAreLookedForInProportion) {
    constexpr double maxGrowth = 1.3;
    EXPECT_LE(bytesOfPlanes(400), 4 * maxGrowth * bytesOfPlanes(200));
}

TEST(Growth, NoStageTakesMuchMoreThanInProportion) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "counts the memory of optimised programs";
#endif
    constexpr double maxExponent = 1.15;
    // Both are too large for a search of the whole, whose effort is limited in another way.
    auto small = bytesOfStages(12800), large = bytesOfStages(51200);
    const double size = std::log(large["quads"] / small["quads"]);
    ASSERT_GT(size, std::log(2));
    for (const auto& [stage, bytes] : large)
        EXPECT_LE(std::log(bytes / small[stage]) / size, maxExponent)
            << stage << " takes " << small[stage] << " bytes, then " << bytes;
}

} // namespace
} // namespace qm::test
