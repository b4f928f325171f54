/// \file The real meshes that some tests use where they are at hand.
#pragma once

#include "check/neighbourhoods.h"

#include <optional>
#include <string>

namespace qm::testing {

/// A mesh of the folder that QM_SHARED_MESHES names, else ../shared/meshes beside the repository; nothing if
/// it is not there.
/// \param name  "dev/rod.obj"
[[nodiscard]] std::optional<check::CheckedMesh> sharedMesh(const std::string& name);

} // namespace qm::testing
