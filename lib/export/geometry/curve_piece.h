/// \file Curves between two parameters.
#pragma once

#include "mesh/quad_mesh.h" // before OpenCASCADE, whose macro `Handle` is a name in OpenMesh

#include <Geom_Curve.hxx>
#include <gp_Pnt.hxx>
#include <vector>

namespace qm {

/// The part of a curve that an edge is: of a spline all of it, of a line, circle or ellipse the part between
/// two parameters.
struct CurvePiece {
    Handle(Geom_Curve) curve;
    double first = 0;
    double last = 0; ///< greater than `first`

    [[nodiscard]] gp_Pnt at(double parameter) const { return curve->Value(parameter); }
    [[nodiscard]] gp_Pnt start() const { return at(first); }
    [[nodiscard]] gp_Pnt end() const { return at(last); }
    [[nodiscard]] gp_Pnt middle() const { return at((first + last) / 2); }
};

/// \param spline  clamped
[[nodiscard]] CurvePiece wholeCurve(const Handle(Geom_Curve) & spline);

/// The control points of the piece as a spline with positive weights: it lies in their convex hull, and is
/// no longer than the polygon through them.
[[nodiscard]] std::vector<gp_Pnt> controlPoints(const CurvePiece& piece);

/// Parameters along the piece, from its first to its last, at the same distance in every interval of a
/// spline, in a line, or in every eighth of a turn.
/// \param perInterval  number of steps
[[nodiscard]] std::vector<double> parametersOf(const CurvePiece& piece, int perInterval);

/// Parameters from the first knot to the last, in so many equal steps in every interval.
/// \param knots  ascending; where one is repeated, there is no interval
[[nodiscard]] std::vector<double> steppedKnots(const std::vector<double>& knots, int perInterval);

} // namespace qm
