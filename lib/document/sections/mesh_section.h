/// \file The section `mesh`: which file the document speaks of, and proof that it is still the same.
#pragma once

#include "document/json/json_place.h"
#include "mesh/quad_mesh.h"

#include <string>
#include <string_view>

namespace qm {

/// \param path  as it is to be recorded; "-" if the mesh came from standard input
/// \throw Error  if the path is not UTF-8
[[nodiscard]] Json meshToJson(const std::string& path, std::string_view bytes, const QuadMesh& mesh);

struct FoundMesh {
    QuadMesh mesh;
    std::string path; ///< the file it was read from
};

/// Finds the mesh of a document, makes sure that it has not changed, and reads it.
/// \param documentPath  "-" if it came from standard input
/// \param meshPath  the file to use instead of the one that is recorded; empty: none
/// \throw FileError  if there is no such file, or it is another mesh
[[nodiscard]] FoundMesh readMeshOf(const JsonPlace& section, const std::string& documentPath,
                                   const std::string& meshPath);

} // namespace qm
