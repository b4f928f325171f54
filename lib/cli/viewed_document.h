/// \file From documents to the scenes that qm-view shows.
#pragma once

#include "cli/export_choices.h"
#include "cli/stage.h"
#include "view/scene.h"

#include <string>
#include <vector>

namespace qm {

/// The scene of the tool's document and, to the left of it, that of another one.
/// \param other  its file; empty: there is none
/// \param reference  the scan of the tool's document, if not where that says; may be empty
/// \param unit  of the meshes
[[nodiscard]] std::vector<Scene> viewedScenes(const Tool& tool, Stage& stage, const std::string& other,
                                              const std::string& reference, LengthUnit unit);

} // namespace qm
