/// \file A quad of the mesh as a bilinear surface.
#pragma once

#include "check/mesh/neighbourhoods.h"
#include "check/mesh/vectors.h"

#include <array>

namespace qm::check {

struct BilinearQuad {
    std::array<Place, 4> corners; ///< around the quad

    /// \param s  from 0 to 1 along the side from corner 0 to corner 1
    /// \param t  from 0 to 1 along the side from corner 0 to corner 3
    [[nodiscard]] Place at(double s, double t) const;
    /// Of no particular length: the product of the diagonals.
    [[nodiscard]] Vector normal() const;
    /// Whether it looks the same way as its normal at every corner, so that it is not folded itself, and no
    /// corner is flat.
    /// \param minSine  of the angle of a corner, seen along the normal, above which it is not
    [[nodiscard]] bool isConvex(double minSine = 0) const;
};

/// A face, from its first corner.
[[nodiscard]] BilinearQuad quadOf(const CheckedMesh& mesh, int face);

} // namespace qm::check
