#include "bspline/network/border_strip.h"

#include "bspline/splines/blossom.h"
#include "layout/sides.h"

#include <algorithm>

namespace qm {
namespace {

constexpr int degree = 3;

} // namespace

BorderStrip::BorderStrip(const PatchSpace& space, const std::array<int, 2>& size, const StretchSide& place)
    : space_(space), side_(place.side) {
    const std::size_t along = directionAlong(side_);
    origin_ = patchParameter(size, place, 0);
    direction_ = patchParameter(size, place, 1) - origin_;

    const auto& across = space.knots[directionAcross(side_)];
    firstInterval_ =
        isFarSide(side_) ? across[across.size() - 4] - across[across.size() - 5] : across[4] - across[3];

    const auto& knots = space.knots[along];
    for (std::size_t k = 4; k + 4 < knots.size(); ++k)
        inner_.push_back((knots[k] - origin_) * direction_);
    if (direction_ < 0) std::ranges::reverse(inner_);
}

std::size_t BorderStrip::unknown(std::size_t along, std::size_t layer) const {
    return space_.firstUnknown + pointOnSide({space_.count(0), space_.count(1)}, side_, along, layer);
}

void BorderStrip::addBlossom(Across what, const std::array<double, 3>& at, double within, double factor,
                             LinearForm& form) const {
    const auto& knots = space_.knots[directionAlong(side_)];
    const std::size_t span = knotSpan(knots, degree, parameter(within));
    const std::array arguments{parameter(at[0]), parameter(at[1]), parameter(at[2])};
    const double slope = degree / firstInterval_;
    std::size_t point = span - degree;
    for (const double weight : blossomWeights(knots, span, arguments)) {
        if (what == Across::position) {
            form.add(unknown(point, 0), factor * weight);
        } else {
            form.add(unknown(point, 1), factor * slope * weight);
            form.add(unknown(point, 0), -factor * slope * weight);
        }
        ++point;
    }
}

void BorderStrip::addDerivativeAlong(double at, double within, double factor, LinearForm& form) const {
    // The polar form is affine in each argument: its slope in one of them is a third of the derivative.
    addBlossom(Across::position, {at, at, at + 1}, within, degree * factor, form);
    addBlossom(Across::position, {at, at, at}, within, -degree * factor, form);
}

} // namespace qm
