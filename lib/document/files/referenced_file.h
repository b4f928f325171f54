/// \file Files that documents refer to: finding them, and checking that they have not changed.
#pragma once

#include "document/json/json_place.h"

#include <string>
#include <vector>

namespace qm {

struct ReferencedFile {
    std::string path; ///< the path it was read from
    std::string bytes;
};

/// Words for messages about such a file.
struct ReferenceWords {
    std::string noun;       ///< "mesh"
    std::string option;     ///< the option with which a user can name the file
    std::string makingAnew; ///< what to do if the file has changed; the beginning of a sentence
};

/// The paths to try, the most likely first.
/// \param section       contains the recorded path
/// \param documentPath  "-" for standard input; otherwise the file may lie beside the document
[[nodiscard]] std::vector<std::string> referencedPaths(const JsonPlace& section,
                                                       const std::string& documentPath);

/// \param section       contains the recorded path and SHA-256
/// \param documentPath  "-" for standard input; otherwise the file may lie beside the document
/// \param givenPath     the file to use instead of the recorded one; may be empty
/// \throw FileError  if there is no such file, or its contents differ
[[nodiscard]] ReferencedFile findReferencedFile(const JsonPlace& section, const std::string& documentPath,
                                                const std::string& givenPath, const ReferenceWords& words);

} // namespace qm
