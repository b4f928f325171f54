/// \file Any bytes, read in each format, are either refused with an Error or give triangles that can be
/// written and read again. The first byte chooses the format.
#include "base/error.h"
#include "bspline/reference/scan/triangle_surface.h"
#include "mesh/files/read_triangles.h"
#include "mesh/files/write_soup.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace {

void require(bool condition) {
    if (!condition) std::abort();
}

void exercise(const qm::Triangles& triangles) {
    const qm::Triangles again =
        qm::readTriangles(qm::writeSoup(qm::soupOf(triangles), qm::MeshFormat::ply), "again.ply");
    require(again.points == triangles.points && again.faces == triangles.faces);
    const qm::TriangleSurface surface(triangles);
    require(surface.nearest(triangles.points.front()).has_value());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    constexpr std::array names{"a.obj", "a.off", "a.ply", "a.stl"};
    const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        exercise(qm::readTriangles(bytes, names[data[0] & 3U]));
    } catch (const qm::Error&) {
        // Refused, as most inputs should be.
    }
    return 0;
}
