/// \file One motorcycle graph as one line of JSON, written straight away: lists may hold billions of them.
#pragma once

#include "document/enumeration_section.h"

#include <string>

namespace qm {

/// Appends {"subMesh", "cost", "tracks"}, as `printJsonLine` writes it with the members of `graphToJson`.
void appendGraphLine(const QuadMesh& mesh, const SeparatrixIndex& baseComplex, SubMeshId subMesh,
                     const MotorcycleGraph& graph, std::string& text);

} // namespace qm
