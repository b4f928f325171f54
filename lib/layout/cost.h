/// \file What a graph costs: a sum of terms, each with a weight (docs/METHOD.md#cost).
#pragma once

#include "layout/constraints.h"
#include "mesh/dihedral.h"

#include <vector>

namespace qm {

/// Weights of the terms. With the weights as they are the cost is the paper's G_T.
struct CostTerms {
    double dihedral = 1; ///< the paper's: -theta of every edge, and alpha where it is flat
    double length = 0;   ///< of every edge, in the mesh's unit
    double segments = 0; ///< of every segment: a quarter for each of its corners
    double custom = 1;   ///< what a person has given edges beyond that

    bool operator==(const CostTerms&) const = default;
};

struct GraphCost : CostOptions {
    CostTerms terms = {};
};

/// What every edge costs by all terms but that of the segments. Edges of the mesh boundary have no length.
/// \throw Error  if costs are so large that their sums are not exact, or lengths count too little
[[nodiscard]] std::vector<double> edgeCosts(const QuadMesh& mesh, const std::vector<double>& dihedralAngles,
                                            const GraphCost& cost, const Constraints& constraints);

/// What each corner costs.
[[nodiscard]] inline double cornerCost(const CostTerms& terms) {
    constexpr double cornersOfSegment = 4;
    return terms.segments / cornersOfSegment;
}

} // namespace qm
