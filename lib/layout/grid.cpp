#include "layout/grid.h"

#include "base/at.h"
#include "base/error.h"
#include "mesh/topology.h"

#include <algorithm>
#include <string>
#include <utility>

namespace qm {
namespace {

[[noreturn]] void refuse(VertexId vertex, const std::string& what) {
    throw Error("vertex " + std::to_string(vertex.idx()), what,
                "The tracks are no motorcycle graph: search again");
}

/// The index of the halfedge in the loop with which side 0 begins.
std::size_t firstSide(const QuadMesh& mesh, const BorderLoop& loop) {
    const std::size_t length = loop.halfedges.size();
    std::size_t best = length;
    const auto key = [&](std::size_t k) {
        return std::pair(mesh.from_vertex_handle(loop.halfedges[k]).idx(),
                         mesh.face_handle(loop.halfedges[k]).idx());
    };
    for (std::size_t k = 0; k < length; ++k)
        if (loop.quads[(k + length - 1) % length] == 1 && (best == length || key(k) < key(best))) best = k;
    return best;
}

void readSides(const QuadMesh& mesh, const BorderLoop& loop, Segment& segment) {
    const std::size_t length = loop.halfedges.size(), first = firstSide(mesh, loop);
    std::size_t side = 0;
    for (std::size_t step = 0; step < length; ++step) {
        const std::size_t k = (first + step) % length;
        auto& vertices = segment.sides[side];
        if (vertices.empty()) vertices.push_back(mesh.from_vertex_handle(loop.halfedges[k]));
        vertices.push_back(mesh.to_vertex_handle(loop.halfedges[k]));
        if (loop.quads[k] == 1) ++side;
    }
    for (std::size_t k = 0; k < 4; ++k)
        segment.corners[k] = segment.sides[k].front();
    segment.size = {static_cast<int>(segment.sides[0].size()) - 1,
                    static_cast<int>(segment.sides[1].size()) - 1};
}

void layFaces(const QuadMesh& mesh, HalfedgeId start, Segment& segment) {
    HalfedgeId row = start;
    for (int j = 0; j < segment.size[1]; ++j) {
        HalfedgeId bottom = row;
        for (int i = 0; i < segment.size[0]; ++i) {
            const FaceId face = mesh.face_handle(bottom);
            if (!face.is_valid()) refuse(mesh.from_vertex_handle(bottom), "the segment there is no grid");
            segment.faces.push_back(face);
            if (i + 1 < segment.size[0]) bottom = straightOn(mesh, bottom);
        }
        if (j + 1 < segment.size[1]) row = acrossQuad(mesh, row);
    }
}

} // namespace

Segment makeSegment(const QuadMesh& mesh, const Region& region) {
    const VertexId some = mesh.to_vertex_handle(mesh.halfedge_handle(region.faces.front()));
    if (region.loops.size() != 1)
        refuse(some, "the segment there has " + std::to_string(region.loops.size()) + " borders");
    const BorderLoop& loop = region.loops.front();
    for (std::size_t k = 0; k < loop.quads.size(); ++k)
        if (loop.quads[k] > 2)
            refuse(mesh.to_vertex_handle(loop.halfedges[k]), "a segment has a reflex corner there");
    if (loop.corners() != 4)
        refuse(some, "the segment there has " + std::to_string(loop.corners()) + " corners");
    Segment segment;
    readSides(mesh, loop, segment);
    const std::size_t grid = at(segment.size[0]) * at(segment.size[1]);
    if (segment.sides[2].size() != segment.sides[0].size() ||
        segment.sides[3].size() != segment.sides[1].size() || grid != region.faces.size())
        refuse(segment.corners[0], "the segment with this corner is no grid");
    layFaces(mesh, loop.halfedges[firstSide(mesh, loop)], segment);
    std::vector<FaceId> laid = segment.faces;
    std::sort(laid.begin(), laid.end());
    if (laid != region.faces) refuse(segment.corners[0], "the segment with this corner is no grid");
    return segment;
}

} // namespace qm
