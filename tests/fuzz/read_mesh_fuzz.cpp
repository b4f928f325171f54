/// \file Any bytes, read in each format, are either refused with an Error or give a mesh that can be written
/// and read again. The first byte chooses the format and whether to repair.
#include "base/error.h"
#include "mesh/dihedral.h"
#include "mesh/files/read_mesh.h"
#include "mesh/files/write_soup.h"
#include "mesh/mesh_lines.h"
#include "mesh/topology.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace {

void require(bool condition) {
    if (!condition) std::abort();
}

void exercise(const qm::QuadMesh& mesh) {
    std::size_t steps = 0;
    qm::forEachMeshLine(mesh, [&](const qm::MeshLine& line) { steps += line.halfedges.size(); });
    require(steps <= mesh.n_edges());
    for (const double angle : qm::dihedralAngles(mesh))
        require(angle >= 0 && angle < 3.2);
    require(qm::components(mesh).count > 0);
    const qm::ReadResult again = qm::readMesh(qm::writeObj(mesh), "again.obj");
    require(again.mesh.n_vertices() == mesh.n_vertices());
    require(again.mesh.n_faces() == mesh.n_faces());
    require(again.mesh.n_edges() == mesh.n_edges());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    constexpr std::array names{"a.obj", "a.off", "a.ply", ""};
    const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        exercise(qm::readMesh(bytes, names[data[0] & 3U], {.repair = (data[0] & 4U) != 0}).mesh);
    } catch (const qm::Error&) {
        // Refused, as most inputs should be.
    }
    return 0;
}
