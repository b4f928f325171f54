/// \file Lists of vertices in a document, read as paths along mesh edges.
#pragma once

#include "check/document/report.h"
#include "check/mesh/neighbourhoods.h"

#include <optional>
#include <string>
#include <vector>

namespace qm::check {

/// True if the vertex exists; reports it otherwise.
bool knownVertex(const Neighbourhoods& around, int vertex, const std::string& pointer, Report& report);

/// The steps along a list of vertices, or nothing, with a report, if it has fewer than two, or two in a row
/// that no edge joins.
/// \param pointer  of the list
[[nodiscard]] std::optional<std::vector<int>> readPath(const Neighbourhoods& around,
                                                       const std::vector<int>& vertices,
                                                       const std::string& pointer, Report& report);

/// The rank of the first step that does not go straight on across a regular interior vertex; the number of
/// steps if all do.
[[nodiscard]] std::size_t firstBend(const Neighbourhoods& around, const std::vector<int>& steps);

} // namespace qm::check
