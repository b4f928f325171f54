/// \file One motorcycle graph as one line of JSON, written without a JSON value, because lists may hold
/// billions of graphs.
#pragma once

#include "document/sections/enumeration_section.h"

#include <string>

namespace qm {

/// Appends {"subMesh", "cost", "tracks"}, exactly as `printJsonLine` would write the members of
/// `graphToJson`.
void appendGraphLine(const QuadMesh& mesh, const SeparatrixIndex& baseComplex, SubMeshId subMesh,
                     const MotorcycleGraph& graph, std::string& text);

} // namespace qm
