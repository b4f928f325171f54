#include "layout/layout.h"

#include "base/at.h"
#include "base/error.h"
#include "layout/grid.h"
#include "layout/seed_line.h"
#include "layout/tracks.h"
#include "mesh/quad_geometry.h"
#include "mesh/topology.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace qm {
namespace {

class Builder {
public:
    Builder(const QuadMesh& mesh, const std::vector<double>& dihedralAngles,
            const std::vector<double>& edgeCosts)
        : mesh_(mesh), dihedralAngles_(dihedralAngles), edgeCosts_(edgeCosts), borders_(mesh),
          finder_(mesh, borders_) {}

    Layout build(std::span<const Track> tracks) {
        for (const Track& track : tracks)
            add({.track = track});
        requireBorderAtEveryExtraordinaryVertex();
        std::vector<FaceId> faces;
        for (const FaceId face : mesh_.faces())
            faces.push_back(face);
        std::vector<Region> pending = finder_.find(faces);
        std::map<FaceId, Segment> segments; // by their lowest face
        while (!pending.empty()) {
            const Region region = std::move(pending.back());
            pending.pop_back();
            if (!split(region)) {
                segments.emplace(region.faces.front(), makeSegment(mesh_, region));
                continue;
            }
            for (Region& part : finder_.find(region.faces))
                pending.push_back(std::move(part));
        }
        for (auto& [lowestFace, segment] : segments)
            layout_.segments.push_back(std::move(segment));
        return std::move(layout_);
    }

private:
    void add(const LayoutTrack& added) {
        for (const HalfedgeId halfedge : added.track.halfedges) {
            if (borders_.isBorder(halfedge))
                throw Error("edge " + std::to_string(mesh_.from_vertex_handle(halfedge).idx()) + " " +
                                std::to_string(mesh_.to_vertex_handle(halfedge).idx()),
                            "two tracks run over it, or it lies on the mesh boundary",
                            "Take one of them out");
            borders_.add(halfedge);
        }
        layout_.tracks.push_back(added);
        if (!added.transversal) layout_.cost += added.track.cost;
    }

    /// A region without extraordinary vertices inside and without reflex corners is a grid with four corners,
    /// an annulus or a torus, and every line through it is straight.
    void requireBorderAtEveryExtraordinaryVertex() const {
        for (const VertexId vertex : extraordinaryVertices(mesh_))
            if (!borders_.hasBorder(vertex))
                throw Error("vertex " + std::to_string(vertex.idx()),
                            "it is extraordinary and lies inside a segment",
                            "The tracks are no motorcycle graph: search again");
    }

    /// Cuts a region that has no corners: an annulus or a torus.
    /// \return false if it needs no cut
    bool split(const Region& region) {
        const bool ring = region.loops.size() == 2 && isRing(region.loops[0]) && isRing(region.loops[1]);
        if (!ring && !region.loops.empty()) return false;
        if (hasNoTrack(region))
            add({.track = trackOf(mesh_, seedLine(mesh_, region.faces, dihedralAngles_), edgeCosts_)});
        else
            add({.track = trackOf(mesh_, cheapestTransversal(region.loops.front()), edgeCosts_),
                 .transversal = true});
        return true;
    }

    static bool isRing(const BorderLoop& loop) {
        return std::ranges::all_of(loop.quads, [](int quads) { return quads == 2; });
    }

    /// Whether a region is a whole component that no particle entered: a torus, or an annulus between
    /// boundaries.
    bool hasNoTrack(const Region& region) const {
        return std::ranges::all_of(region.loops, [this](const BorderLoop& loop) {
            return std::ranges::all_of(
                loop.halfedges, [this](HalfedgeId h) { return mesh_.is_boundary(mesh_.edge_handle(h)); });
        });
    }

    /// The cheapest straight path across an annulus from one loop; ties go to the lowest vertex.
    std::vector<HalfedgeId> cheapestTransversal(const BorderLoop& loop) const {
        std::vector<HalfedgeId> best;
        const auto key = [&](const std::vector<HalfedgeId>& path) {
            return std::pair(sumAlong(mesh_, path, edgeCosts_), mesh_.from_vertex_handle(path.front()).idx());
        };
        for (const HalfedgeId arriving : loop.halfedges) {
            std::vector<HalfedgeId> path{mesh_.next_halfedge_handle(arriving)};
            while (!borders_.isBorder(mesh_.next_halfedge_handle(path.back())))
                path.push_back(straightOn(mesh_, path.back()));
            if (best.empty() || key(path) < key(best)) best = std::move(path);
        }
        return best;
    }

    const QuadMesh& mesh_;
    const std::vector<double>& dihedralAngles_;
    const std::vector<double>& edgeCosts_;
    Borders borders_;
    RegionFinder finder_;
    Layout layout_;
};

} // namespace

std::vector<Track> properTracks(const Layout& layout) {
    std::vector<Track> tracks;
    for (const LayoutTrack& track : layout.tracks)
        if (!track.transversal) tracks.push_back(track.track);
    return tracks;
}

Layout buildLayout(const QuadMesh& mesh, std::span<const Track> tracks,
                   const std::vector<double>& dihedralAngles, const std::vector<double>& edgeCosts) {
    return Builder(mesh, dihedralAngles, edgeCosts).build(tracks);
}

std::vector<SegmentId> segmentsOfFaces(const QuadMesh& mesh, const Layout& layout) {
    std::vector<SegmentId> result(mesh.n_faces());
    for (std::size_t s = 0; s < layout.segments.size(); ++s)
        for (const FaceId face : layout.segments[s].faces)
            result[at(face)] = SegmentId(s);
    return result;
}

std::vector<bool> cornerMarks(const QuadMesh& mesh, const Layout& layout) {
    std::vector<bool> marks(mesh.n_vertices());
    for (const Segment& segment : layout.segments)
        for (const VertexId corner : segment.corners)
            marks[at(corner)] = true;
    return marks;
}

std::vector<VertexId> vertexGrid(const QuadMesh& mesh, const Segment& segment) {
    const std::size_t columns = at(segment.size[0]), rows = at(segment.size[1]), width = columns + 1;
    std::vector<VertexId> grid(width * (rows + 1));
    grid[0] = segment.corners[0];
    for (std::size_t j = 0; j < rows; ++j)
        for (std::size_t i = 0; i < columns; ++i) {
            const std::size_t first = j * width + i; // known from the faces before
            auto corners = cornersOf(mesh, segment.faces[j * columns + i]);
            std::rotate(corners.begin(), std::ranges::find(corners, grid[first]), corners.end());
            grid[first + 1] = corners[1];
            grid[first + width + 1] = corners[2];
            grid[first + width] = corners[3];
        }
    return grid;
}

} // namespace qm
