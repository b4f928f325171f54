/// \file The cost of a graph: a weighted sum of terms (docs/METHOD.md#cost).
#pragma once

#include "layout/constraints.h"
#include "mesh/dihedral.h"

#include <vector>

namespace qm {

/// Weights of the terms. The default weights give the paper's G_T.
struct CostTerms {
    double dihedral = 1; ///< the paper's: -theta of every edge, plus alpha if the edge is flat
    double length = 0;   ///< of every edge, in the mesh's unit
    double segments = 0; ///< of every segment: a quarter for each of its corners
    double custom = 1;   ///< the weights of edges in the constraints

    bool operator==(const CostTerms&) const = default;
};

struct GraphCost : CostOptions {
    CostTerms terms = {};
};

/// The cost of every edge: all terms except that of segments. Edges of the mesh boundary have no length.
/// \throw Error  if costs are too large for exact sums, or lengths too small to count
[[nodiscard]] std::vector<double> edgeCosts(const QuadMesh& mesh, const std::vector<double>& dihedralAngles,
                                            const GraphCost& cost, const Constraints& constraints);

/// The cost of each corner.
[[nodiscard]] inline double cornerCost(const CostTerms& terms) {
    constexpr double cornersOfSegment = 4;
    return terms.segments / cornersOfSegment;
}

} // namespace qm
