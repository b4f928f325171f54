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
    const std::vector<SegmentId> segmentOf = segmentsOfFaces(mesh, layout);
    const Soup soup = soupOf(mesh);
    std::string bytes = plyPoints(soup, "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                                        "property int segment\n");
    for (std::size_t face = 0; face < soup.faceCount(); ++face) {
        const SegmentId segment = segmentOf[face];
        appendPlyFace(bytes, soup.face(face));
        for (const std::uint8_t part : colours[segment.idx()])
            appendBytes(bytes, part);
        appendBytes(bytes, static_cast<std::int32_t>(segment.value()));
    }
    return bytes;
}

} // namespace qm
