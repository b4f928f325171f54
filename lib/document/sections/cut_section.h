/// \file The section `cut`.
#pragma once

#include "cut/cut.h"
#include "document/json/json_place.h"
#include "mesh/sub_meshes.h"

#include <optional>

namespace qm {

[[nodiscard]] Json cutToJson(const Cut& cut);

/// Reads a cut. Labels may have been edited, so the quasi-complexity and the junctions of every sub-mesh are
/// measured anew.
/// \param complex  with the feature seeds
[[nodiscard]] Cut readCut(const QuadMesh& mesh, const BaseComplex& complex, const JsonPlace& section);

/// Whether the figures in the section equal the measured ones.
[[nodiscard]] bool figuresAgree(const Cut& cut, const Json& section);
/// Replaces the figures in the section by the measured ones.
void updateFigures(const Cut& cut, Json& section);

/// The sub-meshes of the cut, or the whole mesh as one if there is no cut.
[[nodiscard]] SubMeshes subMeshesOf(const std::optional<Cut>& cut);

} // namespace qm
