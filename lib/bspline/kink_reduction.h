/// \file Smoother borders for patches that are finished but for that.
#pragma once

#include "base/control.h"
#include "bspline/deviation.h"
#include "bspline/tolerance.h"

#include <cstddef>

namespace qm {

struct KinkLimits {
    double angle = 1;           ///< between neighbours' normals, degrees: larger ones are to go
    std::size_t mostPoints = 0; ///< as long as there are no more control points in all than this
};

/// Patches turn, round by round, to the normals on which they and their neighbours agree. Where that is not
/// enough, they get a knot each in every round, those first that gain most by every control point it takes.
/// What goes beyond the limits of deviation is taken back. \param fit  is within them, as far as possible
void reduceKinks(const QuadMesh& mesh, const Layout& layout, ToleranceFit& fit, const KinkLimits& kinks,
                 const DeviationMeter& meter, const DeviationLimits& limits, const Control& control);

} // namespace qm
