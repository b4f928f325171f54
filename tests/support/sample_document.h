/// \file A document of every kind of a small mesh, made by the modules themselves: what the tests of reading
/// and writing take apart.
#pragma once

#include "base/error.h"
#include "document/document.h"
#include "document/enumeration_section.h"
#include "document/model.h"
#include "support/polycube.h"

#include <string>

namespace qm::testing {

/// The surface of cubes, each of its squares divided into n x n quads.
[[nodiscard]] QuadMesh dividedCubes(const Cells& cells, int n);
/// A slab of cubes with one more on top, its squares divided: 12 extraordinary vertices, some ordinary
/// junctions.
[[nodiscard]] const QuadMesh& sampleMesh();

/// A folder that vanishes with the object.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] std::string path(const std::string& name) const { return path_ + "/" + name; }
    /// Writes a file and returns its path.
    std::string write(const std::string& name, const std::string& bytes) const;

private:
    std::string path_;
};

/// All sections up to the kind; features with one curve, the mesh cut in two halves. The mesh file is
/// `mesh.obj` in the folder, and the document knows it by its whole path.
[[nodiscard]] Document sampleDocument(const TemporaryFolder& folder, Kind kind,
                                      const QuadMesh& mesh = sampleMesh());

/// The message of the qm::Error that f throws; fails the test if it throws none.
template <class Function> [[nodiscard]] std::string messageOf(Function&& f) {
    try {
        f();
    } catch (const Error& error) {
        return error.what();
    }
    return "(nothing was thrown)";
}

} // namespace qm::testing
