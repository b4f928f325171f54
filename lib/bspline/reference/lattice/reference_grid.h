/// \file The surface that one segment's patch is fitted to, as points on a lattice over the segment's quads.
#pragma once

#include "base/at.h"
#include "bspline/reference/lattice/lagrange.h"
#include "bspline/splines/evaluate.h"
#include "layout/layout.h"
#include "mesh/quad_mesh.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// The reference above one segment. Point (i, j), at j * columns() + i, belongs to u = i / steps
/// and v = j / steps of the segment's patch. Within every quad the surface is the polynomial of degree
/// `steps` in each direction through the quad's points; between quads it is continuous.
struct ReferenceGrid {
    std::array<int, 2> size{};   ///< quads along u and v
    int steps = 2;               ///< lattice steps per quad: 1, or even and at most maxSteps
    std::vector<Point> points{}; ///< columns() * rows() of them

    [[nodiscard]] std::size_t columns() const { return at(size[0]) * at(steps) + 1; }
    [[nodiscard]] std::size_t rows() const { return at(size[1]) * at(steps) + 1; }
    /// Corner (i, j) of the segment's quads.
    [[nodiscard]] const Point& vertex(int i, int j) const {
        return points[at(j) * at(steps) * columns() + at(i) * at(steps)];
    }

    /// At a grid line the derivatives are those of the quad after it, at the last one those of the quad
    /// before it. Outside the grid the polynomials of the outermost quads are continued.
    [[nodiscard]] SurfacePoint evaluate(double u, double v) const;
    /// All points of a lattice: (us[i], vs[j]) at j * us.size() + i.
    [[nodiscard]] std::vector<SurfacePoint> evaluateLattice(const std::vector<double>& us,
                                                            const std::vector<double>& vs) const;
};

/// By segment: the quads of a mesh, bilinear.
[[nodiscard]] std::vector<ReferenceGrid> facetGrids(const QuadMesh& mesh, const Layout& layout);

} // namespace qm
