#include "export/quads.h"

#include "base/at.h"
#include "base/bytes.h"
#include "base/number_text.h"
#include "mesh/files/write_soup.h"

#include <cstdint>

namespace qm {

std::string quadsAsObj(const QuadMesh& mesh, const Layout& layout) {
    const Soup soup = soupOf(mesh);
    std::string text = objPoints(soup);
    for (std::size_t s = 0; s < layout.segments.size(); ++s) {
        appendNumber(text += "g segment_", s);
        text += '\n';
        for (const FaceId face : layout.segments[s].faces)
            appendObjFace(text, soup.face(at(face)));
    }
    return text;
}

std::string quadsAsPly(const QuadMesh& mesh, const Layout& layout, const std::vector<Colour>& colours) {
    std::vector<std::size_t> segmentOf(mesh.n_faces(), 0);
    for (std::size_t s = 0; s < layout.segments.size(); ++s)
        for (const FaceId face : layout.segments[s].faces)
            segmentOf[at(face)] = s;
    const Soup soup = soupOf(mesh);
    std::string bytes = plyPoints(soup, "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                                        "property int segment\n");
    for (std::size_t face = 0; face < soup.faceCount(); ++face) {
        const std::size_t segment = segmentOf[face];
        appendPlyFace(bytes, soup.face(face));
        for (const std::uint8_t part : colours[segment])
            appendBytes(bytes, part);
        appendBytes(bytes, static_cast<std::int32_t>(segment));
    }
    return bytes;
}

} // namespace qm
