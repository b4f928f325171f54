#include "document/files/referenced_file.h"

#include "document/files/files.h"
#include "document/files/sha256.h"

#include <filesystem>
#include <system_error>
#include <vector>

namespace qm {

std::vector<std::string> referencedPaths(const JsonPlace& section, const std::string& documentPath) {
    const std::string& recorded = section["path"].text();
    std::vector<std::string> paths{recorded};
    if (documentPath == "-") return paths;
    const std::string folder = documentPath.substr(0, documentPath.rfind('/') + 1);
    if (!recorded.starts_with('/') && !folder.empty()) paths.push_back(folder + recorded);
    // People who pass on a document put the file beside it.
    paths.push_back(folder + recorded.substr(recorded.rfind('/') + 1));
    return paths;
}

ReferencedFile findReferencedFile(const JsonPlace& section, const std::string& documentPath,
                                  const std::string& givenPath, const ReferenceWords& words) {
    const std::string& recorded = section["path"].text();
    const std::string& fingerprint = section["sha256"].text();
    const std::string remedy = "Name the " + words.noun + " with " + words.option;
    if (givenPath.empty() && recorded == "-")
        section["path"].fail(
            "the " + words.noun + " came from standard input, so it is not known where it is", remedy);
    if (givenPath.empty() && (recorded.empty() || recorded.find('\0') != std::string::npos))
        section["path"].fail("is no name of a file", remedy);

    const std::string subject = "the " + words.noun + " that " + displayName(documentPath) + " refers to";
    std::string changed; // a file with this name and other contents
    const std::vector<std::string> paths =
        givenPath.empty() ? referencedPaths(section, documentPath) : std::vector<std::string>{givenPath};
    for (const std::string& path : paths) {
        if (std::error_code unknown; !std::filesystem::exists(path, unknown)) continue;
        if (!isRegularFile(path))
            throw FileError(path, subject + " is no file but a folder, a pipe or a device", remedy);
        ReferencedFile file{path, readFile(path)};
        if (sha256(file.bytes) == fingerprint) return file;
        if (changed.empty()) changed = path;
    }
    if (!changed.empty())
        throw FileError(changed,
                        "the " + words.noun + " has changed since " + displayName(documentPath) + " was made",
                        words.makingAnew + ", or name the right " + words.noun + " with " + words.option);
    throw FileError(paths.front(), subject + " is not there", remedy);
}

} // namespace qm
