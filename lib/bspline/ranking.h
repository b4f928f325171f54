/// \file Layouts of one mesh, ranked by the surfaces that they take.
#pragma once

#include "bspline/splines/surfaces.h"
#include "layout/layout.h"

#include <cstddef>

namespace qm {

/// What a layout's surfaces cost and how near they come.
struct RankedLayout {
    std::size_t segments = 0;
    double cost = 0; ///< G_T
    std::size_t controlPoints = 0;
    double maxRelative = 0; ///< distance from the reference, as a share of the diagonal
    bool keeps = false;     ///< the tolerance
};

/// \param keeps  the surfaces keep the tolerance
[[nodiscard]] RankedLayout rankedLayout(const Layout& layout, const Surfaces& surfaces, bool keeps);

/// What keeps the tolerance comes first, with fewer control points before more; then what misses it, the
/// nearest first. Segments, and G_T after them, decide between equals.
[[nodiscard]] bool ranksBefore(const RankedLayout& a, const RankedLayout& b);

} // namespace qm
