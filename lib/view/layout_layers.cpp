#include "base/at.h"
#include "mesh/topology.h"
#include "view/layers.h"
#include "view/palette.h"

namespace qm {
namespace {

/// Pairs of segments on both sides of an edge.
std::vector<std::pair<std::uint32_t, std::uint32_t>>
neighbouringSegments(const QuadMesh& mesh, const std::vector<std::uint32_t>& of) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const EdgeId edge : mesh.edges()) {
        if (mesh.is_boundary(edge)) continue;
        const auto [left, right] = facesBeside(mesh, edge);
        if (of[at(left)] != of[at(right)]) pairs.emplace_back(of[at(left)], of[at(right)]);
    }
    return pairs;
}

void addSegments(Scene& scene, const QuadMesh& mesh, const Layout& layout) {
    auto faces = newLayer<FaceLayer>("segments", "segments", "segment", "/layout/segments/");
    faces.paint = Paint::items;
    for (const SegmentId segment : segmentsOfFaces(mesh, layout))
        faces.groups.push_back(static_cast<std::uint32_t>(segment.value()));
    faces.items.count = layout.segments.size();
    LineLayer borders =
        newLines("borders", "borders of segments", "side", "/layout/segments/{of segment}/sides/{side}");
    for (std::size_t k = 0; k < layout.segments.size(); ++k) {
        const Segment& segment = layout.segments[k];
        addFigure(faces.items, "quads along side 0", segment.size[0]);
        addFigure(faces.items, "quads along side 1", segment.size[1]);
        for (std::size_t side = 0; side < 4; ++side) {
            addFigure(faces.items, "corner " + std::to_string(side), segment.corners[side].idx());
            addPath(borders, segment.sides[side]);
            addFigure(borders.items, "of segment", k);
            addFigure(borders.items, "side", side);
        }
    }
    faces.colours = colourNumbers(layout.segments.size(), neighbouringSegments(mesh, faces.groups));
    scene.faces.push_back(std::move(faces));
    scene.lines.push_back(std::move(borders));
}

} // namespace

void addLayout(Scene& scene, const QuadMesh& mesh, const Layout& layout) {
    addSegments(scene, mesh, layout);
    LineLayer tracks = newLines("tracks", "tracks", "track", "/layout/tracks/");
    for (const LayoutTrack& track : layout.tracks) {
        addPath(tracks, verticesAlong(mesh, track.track.halfedges));
        addFigure(tracks.items, "cost", track.track.cost);
        addFigure(tracks.items, "transversal", track.transversal ? 1 : nothing);
    }
    scene.lines.push_back(std::move(tracks));
}

} // namespace qm
