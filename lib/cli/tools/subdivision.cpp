#include "cli/tools/subdivision.h"

#include "base/at.h"
#include "base/error.h"
#include "base/number_text.h"
#include "mesh/bounding_box.h"
#include "mesh/extent.h"
#include "mesh/files/mesh_format.h"
#include "mesh/files/write_soup.h"
#include "mesh/soup/soup.h"
#include "mesh/soup/validate.h"
#include "remesh/polygons/subdivide_polygons.h"

#include <string>

namespace qm {
namespace {

std::size_t facesWithSides(const Soup& soup, std::size_t sides) {
    std::size_t count = 0;
    for (std::size_t face = 0; face < soup.faceCount(); ++face)
        count += soup.face(face).size() == sides ? 1 : 0;
    return count;
}

} // namespace

int subdivideInput(const Tool& tool, double rho) {
    const std::string bytes = tool.readInput();
    tool.protect(tool.inputPath(), "is the mesh that is read");
    const Soup soup = readSoup(bytes, tool.inputPath(), 3);
    validatePolygons(soup);
    verifyExtent(boundingBoxOf(soup.corners, [&](std::int64_t corner) { return soup.points[at(corner)]; }));
    const std::size_t triangles = facesWithSides(soup, 3), quads = facesWithSides(soup, 4);
    if (formatOfName(tool.inputPath()) == MeshFormat::stl || formatOfBytes(bytes) == MeshFormat::stl)
        throw Error("", "STL holds triangles that are not connected, which cannot be subdivided",
                    "Use --quads instead of --subdivide");
    if (2 * triangles > soup.faceCount())
        tool.warnOfInput(
            std::to_string(triangles) + " of " + countText(soup.faceCount(), "face") +
            " are triangles, which make poor quads. For a scan, use --quads instead of --subdivide");
    const Soup result = subdividePolygons(soup, rho);
    tool.count("faces", soup.faceCount());
    tool.count("otherFaces", soup.faceCount() - quads);
    tool.count("quads", result.faceCount());
    tool.write(writeSoup(result, MeshFormat::obj));
    return exitDone;
}

} // namespace qm
