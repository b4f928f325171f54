/// \file The lines, circles and ellipses in which planes, cylinders, cones, spheres and tori meet.
#pragma once

#include "export/geometry/curve_piece.h"
#include "export/simple/simple_surface.h"

#include <array>
#include <optional>

namespace qm {

/// The line, circle or ellipse in which two surfaces meet, from one point of it to another; or a line on a
/// cylinder or cone that both are.
/// \param ends        lie on both surfaces
/// \param through     near the middle of the result
/// \param resolution  closer points are taken for one
/// \return nothing if they meet in no such curve, or it does not pass the ends, or these are one
[[nodiscard]] std::optional<CurvePiece> conicCurve(const std::array<SimpleSurface, 2>& surfaces,
                                                   const std::array<gp_Pnt, 2>& ends, const gp_Pnt& through,
                                                   double resolution);

/// Two pieces, one after the other, as one, if they belong to one line, circle or ellipse and do not close
/// it.
/// \param after  begins, or ends, where `piece` ends
/// \return nothing otherwise
[[nodiscard]] std::optional<CurvePiece> continued(const CurvePiece& piece, const CurvePiece& after,
                                                  double resolution);

/// The piece in the opposite direction.
[[nodiscard]] CurvePiece reversed(const CurvePiece& piece);

} // namespace qm
