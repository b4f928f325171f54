/// \file Real meshes, which some tests use if they are available.
#pragma once

#include "check/mesh/neighbourhoods.h"

#include <optional>
#include <string>

namespace qm::test {

/// A mesh in the folder named by QM_SHARED_MESHES, or in ../shared/meshes beside the repository; nothing if
/// there is no such file.
/// \param name  such as "dev/rod.obj"
[[nodiscard]] std::optional<check::CheckedMesh> sharedMesh(const std::string& name);

} // namespace qm::test
