/// \file Files that documents refer to: where they are, and proof that they are still the same.
#pragma once

#include "document/json_place.h"

#include <string>

namespace qm {

struct ReferencedFile {
    std::string path; ///< that it was read from
    std::string bytes;
};

/// How messages speak of it.
struct ReferenceWords {
    std::string noun;       ///< "mesh"
    std::string option;     ///< with which a user names the file
    std::string makingAnew; ///< what there is to do if the file has changed, a beginning of a sentence
};

/// \param section  with the path and the SHA-256 that are recorded
/// \param documentPath  "-" if the document came from standard input; else the file may lie beside it
/// \param givenPath  the file to use instead of the one that is recorded; empty: none
/// \throw FileError  if there is no such file, or it is another one
[[nodiscard]] ReferencedFile findReferencedFile(const JsonPlace& section, const std::string& documentPath,
                                                const std::string& givenPath, const ReferenceWords& words);

} // namespace qm
