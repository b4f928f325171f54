/// \file Points, derivatives and normals of a patch.
#pragma once

#include "bspline/splines/basis.h"
#include "bspline/splines/surfaces.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace qm {

struct SurfacePoint {
    Point position{0, 0, 0};
    Point du{0, 0, 0}; ///< partial derivatives
    Point dv{0, 0, 0};

    /// See `unitNormal`; zero where the surface is degenerate.
    [[nodiscard]] Point normal() const;
};

/// Smallest and largest u, smallest and largest v.
[[nodiscard]] ParameterBox domain(const Patch& patch);

/// Outside its domain a patch goes on as the polynomial at its end.
[[nodiscard]] SurfacePoint evaluate(const Patch& patch, double u, double v);

/// The same from basis values already at hand, for many points on common parameter lines.
[[nodiscard]] SurfacePoint evaluate(const Patch& patch, const BasisValues& u, const BasisValues& v);

/// The point at a place of the layout.
[[nodiscard]] Point pointAt(const std::vector<Patch>& patches, const LayoutPlace& place);

/// All points of a lattice: (us[i], vs[j]) at j * us.size() + i.
[[nodiscard]] std::vector<SurfacePoint> evaluateLattice(const Patch& patch, std::span<const double> us,
                                                        std::span<const double> vs);

/// Positions alone, at less than half the cost, from the basis at the columns' and the rows' parameters.
[[nodiscard]] std::vector<Point> positionLattice(const Patch& patch, const std::vector<BasisValues>& us,
                                                 const std::vector<BasisValues>& vs);

/// Of length one; zero stays.
[[nodiscard]] Point unit(const Point& vector);

/// Unit length, on the side from which u turns to v counter-clockwise; none where the patch is degenerate.
[[nodiscard]] std::optional<Point> unitNormal(const Point& du, const Point& dv);

} // namespace qm
