/// \file A patch along a part of one of its sides: its border curve and its derivative across the border, as
/// linear functions of its control points.
#pragma once

#include "bspline/network/stretches.h"
#include "bspline/solver/linear_form.h"
#include "bspline/splines/patch_space.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// What a strip is asked for at a place.
enum class Across {
    position,  ///< of the border curve
    derivative ///< into the patch, across the border, for the parameter of the mesh's grid
};

class BorderStrip {
public:
    /// \param size  of the patch, in quads
    BorderStrip(const PatchSpace& space, const std::array<int, 2>& size, const StretchSide& place);

    /// Inner knots along the border as parameters of the stretch, ascending, repeated as often as they are.
    [[nodiscard]] const std::vector<double>& knots() const { return inner_; }

    /// Adds a polar form (a blossom), times a factor, at three parameters of the stretch: that of the cubic
    /// which the strip is in the knot interval around `within`. At three successive knots of a refinement it
    /// is a control point of the refined curve.
    void addBlossom(Across what, const std::array<double, 3>& at, double within, double factor,
                    LinearForm& form) const;
    /// Adds the value at a parameter of the stretch, of the cubic around `within`.
    void addValue(Across what, double at, double within, double factor, LinearForm& form) const {
        addBlossom(what, {at, at, at}, within, factor, form);
    }
    /// Adds the border curve's derivative by the parameter of the stretch.
    void addDerivativeAlong(double at, double within, double factor, LinearForm& form) const;

private:
    [[nodiscard]] std::size_t unknown(std::size_t along, std::size_t layer) const;
    [[nodiscard]] double parameter(double x) const { return origin_ + direction_ * x; }

    const PatchSpace& space_;
    int side_;
    double origin_;        ///< parameter of the patch along the border where the stretch begins
    double direction_;     ///< and whether it grows with that of the stretch: 1 or -1
    double firstInterval_; ///< the knot interval at the border, across it
    std::vector<double> inner_;
};

} // namespace qm
