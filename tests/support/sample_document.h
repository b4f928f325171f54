/// \file Documents of every kind for a small mesh, made by the library, for tests of reading and writing.
#pragma once

#include "cli/system/child_process.h"
#include "document/document.h"
#include "document/model.h"
#include "document/sections/enumeration_section.h"
#include "support/polycube.h"

#include <string>

namespace qm::test {

/// The surface of cubes, with every square divided into n x n quads.
[[nodiscard]] QuadMesh dividedCubes(const Cells& cells, int n);
/// A slab of cubes with another one on top, all squares divided: it has 12 extraordinary vertices and some
/// ordinary junctions.
[[nodiscard]] const QuadMesh& sampleMesh();

/// A folder that is removed together with the object.
class TemporaryFolder : public qm::TemporaryFolder {
public:
    TemporaryFolder() : qm::TemporaryFolder("quadmesh") {}
    /// Writes a file and returns its path.
    std::string write(const std::string& name, const std::string& bytes) const;
};

/// A document with all sections up to the kind; its features have one curve, and the mesh is cut into two
/// halves. The mesh file is `mesh.obj` in the folder, to which the document refers by its full path.
[[nodiscard]] Document sampleDocument(const TemporaryFolder& folder, Kind kind,
                                      const QuadMesh& mesh = sampleMesh());

} // namespace qm::test
