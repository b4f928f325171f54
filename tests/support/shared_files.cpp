#include "support/shared_files.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace qm::test {
namespace {

std::filesystem::path sharedFolder() {
    const char* folder = std::getenv("QM_SHARED_MESHES");
    return folder != nullptr ? folder : "../shared/meshes";
}

} // namespace

std::optional<std::string> sharedFile(const std::string& name) {
    std::ifstream file(sharedFolder() / name, std::ios::binary);
    if (!file) return std::nullopt;
    return std::string{std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> sharedFiles(const std::string& folder) {
    std::vector<std::string> names;
    std::error_code missing;
    for (const auto& entry : std::filesystem::directory_iterator(sharedFolder() / folder, missing))
        names.push_back(folder + "/" + entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

} // namespace qm::test
