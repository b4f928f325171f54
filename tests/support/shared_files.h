/// \file Files of real meshes, which some tests use if they are available.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace qm::test {

/// The contents of a file in the folder named by QM_SHARED_MESHES, or in ../shared/meshes; nothing if there
/// is no such file.
/// \param name  such as "dev/rod.obj"
[[nodiscard]] std::optional<std::string> sharedFile(const std::string& name);

/// The names of the files in a subfolder, in alphabetical order; none if there is no such folder.
/// \param folder  such as "dev"
[[nodiscard]] std::vector<std::string> sharedFiles(const std::string& folder);

} // namespace qm::test
