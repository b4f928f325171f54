/// \file Does a graph do what a person demanded?
#pragma once

#include "check/document/checked_document.h"
#include "check/document/report.h"
#include "check/mesh/neighbourhoods.h"

#include <span>
#include <string>

namespace qm::check {

/// Reports constraints that are no paths along edges.
/// \return whether all are paths
[[nodiscard]] bool checkConstraintPaths(const Neighbourhoods& around, const ConstraintsPart& constraints,
                                        Report& report);

/// What a graph belongs to: in one of the whole mesh everything must be that is required.
enum class GraphOf { mesh, subMesh };

/// Reports constraints that a graph does not keep.
/// \param constraints  whose paths are sound
/// \param present      by edge: whether it belongs to the graph
/// \param pointer      of the graph's tracks
void checkConstraints(const Neighbourhoods& around, const ConstraintsPart& constraints,
                      std::span<const char> present, GraphOf what, const std::string& pointer,
                      Report& report);

} // namespace qm::check
