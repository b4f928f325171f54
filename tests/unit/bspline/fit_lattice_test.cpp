#include "bspline/fitting/lattice/fit_lattice.h"
#include "bspline/reference/fit_reference.h"
#include "mesh/dihedral.h"
#include "support/grid_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace qm {
namespace {

/// What the lattice point at a place is free to do, in every patch that has one there.
std::vector<Freedom> freedomsAt(const Point& place, const QuadMesh& mesh, const Layout& layout) {
    const FitReference reference =
        fitReference(mesh, layout, dihedralAngles(mesh), {.rho = defaultRho}, nullptr, 1);
    std::vector<Freedom> found;
    for (const LatticeSource& source : latticeSources(mesh, layout, reference.network, reference.target, 1)) {
        const auto& size = source.grid->size;
        const FitLattice lattice =
            makeLattice(source, {latticeParameters(size[0], 1, {}), latticeParameters(size[1], 1, {})});
        for (std::size_t k = 0; k < lattice.reference.size(); ++k)
            if ((lattice.reference[k] - place).norm() < 1e-9) found.push_back(lattice.freedom[k]);
    }
    return found;
}

TEST(FitLattice, WhereACreaseEndsOnAnotherItsEndDoesNotSlide) {
    // Across the middle row a sheet bends, and above it a valley ends on the bend.
    const test::Grid sheet{4, 4, [](double i, double j) {
                               return Point(i, j, j < 2 ? 0.8 * (2 - j) : 0.8 * (j - 2) * std::abs(i - 2));
                           }};
    const QuadMesh mesh = test::makeMesh(sheet);
    const std::vector<test::Rectangle> upper{{0, 2, 2, 4, 0}, {2, 2, 4, 4, 3}};
    const Layout passed = test::makeLayout(sheet, {{0, 0, 4, 2, 1}, upper[0], upper[1]});
    const Point end(2, 2, 0);
    std::vector<Freedom> freedoms = freedomsAt(end, mesh, passed);
    std::ranges::sort(freedoms);
    EXPECT_EQ(freedoms, (std::vector{Freedom::crease, Freedom::corner, Freedom::corner}))
        << "along the side that passes there is only one tangent";
    EXPECT_EQ(freedomsAt(Point(1, 2, 0), mesh, passed), (std::vector{Freedom::crease, Freedom::crease}));
}

} // namespace
} // namespace qm
