/// \file The section `cut`.
#pragma once

#include "cut/cut.h"
#include "document/json_place.h"
#include "enumerate/enumerate.h"

namespace qm {

[[nodiscard]] Json cutToJson(const Cut& cut);

/// Labels may have been edited, so quasi-complexity and junctions of every sub-mesh are measured anew.
/// \param complex  with the feature seeds
[[nodiscard]] Cut readCut(const QuadMesh& mesh, const BaseComplex& complex, const JsonPlace& section);

/// Whether the figures of the section are those that were measured.
[[nodiscard]] bool figuresAgree(const Cut& cut, const Json& section);
/// Writes the figures that were measured into the section.
void updateFigures(const Cut& cut, Json& section);

/// Where a search works.
[[nodiscard]] SubMeshes subMeshesOf(const std::optional<Cut>& cut);

} // namespace qm
