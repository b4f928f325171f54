/// \file Vertices around which smooth borders cannot rise and fall in turn (docs/METHOD.md#smooth-fit).
#pragma once

#include "bspline/fitting/knots/knot_plan.h"
#include "bspline/network/smooth_network.h"
#include "bspline/reference/lattice/reference_grid.h"
#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// A border at an even vertex, and the reference along it.
struct EvenBorder {
    struct Place {
        double distance = 0; ///< from the vertex, in mesh edges
        double height = 0;   ///< over the vertex's tangent plane
        double cosine = 1;   ///< of the angle between the normals there and at the vertex
    };
    RunEnd end;
    double ratio = 0;          ///< its tangent ratio at the vertex, with a sign that alternates around it
    std::vector<Place> places; ///< by distance
};

/// An interior vertex with an even number of edges and no crease.
struct EvenVertex {
    std::vector<EvenBorder> borders; ///< those with a tangent ratio
};

/// All even vertices at which tangent ratios begin or end.
/// \param grids  the reference, by patch
[[nodiscard]] std::vector<EvenVertex> evenVertices(const QuadMesh& mesh, const SmoothNetwork& network,
                                                   const std::vector<ReferenceGrid>& grids);

/// How far from the vertex the ratio of every border reaches. One that is linear leaves its border a cubic,
/// which can do as much as with half of its length as the reach.
[[nodiscard]] std::vector<double> reachesAt(const EvenVertex& vertex, const KnotPlan& plan);

/// How far the borders of an even vertex are from the reference at least, where the tangent ratios end, if
/// they are quadratics up to there: the tangent ratios times the heights' second derivatives, with
/// alternating signs, sum up to 0.
/// \param reaches  by border
[[nodiscard]] double minError(const EvenVertex& vertex, const std::vector<double>& reaches);

/// Where the borders of an even vertex cannot be as near to the reference as allowed, shortens the reaches of
/// all of them to the longest one, in common to all, with which they can.
/// \param allowed  the error of borders
void shortenAtEvenVertices(const std::vector<EvenVertex>& vertices, double allowed, KnotPlan& plan);

} // namespace qm
