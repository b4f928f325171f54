/// \file The files of real meshes that some tests use where they are at hand.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace qm::testing {

/// All bytes of a file of the folder that QM_SHARED_MESHES names, else ../shared/meshes; nothing if it is not
/// there.
/// \param name  "dev/rod.obj"
[[nodiscard]] std::optional<std::string> sharedFile(const std::string& name);

/// Names of the files of a subfolder, in alphabetical order; none if it is not there.
/// \param folder  "dev"
[[nodiscard]] std::vector<std::string> sharedFiles(const std::string& folder);

} // namespace qm::testing
