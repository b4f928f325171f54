/// \file What the checks of tracks have in common.
#pragma once

#include "check/document/checked_document.h"
#include "check/mesh/angles.h"
#include "check/mesh/neighbourhoods.h"

namespace qm::check {

struct Context {
    const CheckedMesh& mesh;
    const Neighbourhoods& around;
    Angles angles;
    EdgeCosts costs;
    ConstraintsPart constraints; ///< with sound paths
    double segmentCost = 0;      ///< of every segment
    std::vector<int> labels;     ///< sub-mesh of every vertex; empty if the mesh is not cut
};

} // namespace qm::check
