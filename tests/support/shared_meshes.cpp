#include "support/shared_meshes.h"

#include "mesh/read_mesh.h"

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace qm::testing {

std::optional<check::CheckedMesh> sharedMesh(const std::string& name) {
    const char* folder = std::getenv("QM_SHARED_MESHES");
    const std::string path = std::string(folder != nullptr ? folder : "../shared/meshes") + "/" + name;
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const QuadMesh mesh = readMesh(bytes, path).mesh;
    check::CheckedMesh result;
    for (const auto vertex : mesh.vertices())
        result.points.push_back({mesh.point(vertex)[0], mesh.point(vertex)[1], mesh.point(vertex)[2]});
    for (const auto face : mesh.faces()) {
        auto corner = result.quads.emplace_back().begin();
        for (const auto vertex : mesh.fv_range(face))
            *corner++ = vertex.idx();
    }
    return result;
}

} // namespace qm::testing
