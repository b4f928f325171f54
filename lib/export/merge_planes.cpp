#include "export/merge_planes.h"

#include "export/drop_unused.h"

#include <Geom_Plane.hxx>
#include <algorithm>
#include <gp_Pln.hxx>
#include <optional>
#include <utility>

namespace qm {
namespace {

/// What checks an outline compares all of its edges with one another.
constexpr std::size_t maxEdges = 256;
/// Between the normals of two planes that are one, in radians; how far edges are apart counts besides.
constexpr double maxAngle = 1e-3;

std::size_t startOf(const Boundary& boundary, const EdgeUse& use) {
    return boundary.edges[use.edge].ends.at(use.forwards ? 0 : 1);
}

std::size_t endOf(const Boundary& boundary, const EdgeUse& use) {
    return boundary.edges[use.edge].ends.at(use.forwards ? 1 : 0);
}

std::optional<gp_Pln> planeOf(const BoundaryFace& face) {
    const auto plane = Handle(Geom_Plane)::DownCast(face.surface);
    if (plane.IsNull()) return std::nullopt;
    return plane->Pln();
}

/// The largest distance of an edge's control points from a plane: no point of it is farther away.
double distance(const BoundaryEdge& edge, const gp_Pln& plane) {
    double largest = 0;
    for (const gp_Pnt& point : controlPoints(edge.curve))
        largest = std::max(largest, plane.Distance(point));
    return largest;
}

/// Faces of one plane that hang together, and their outline.
class Region {
public:
    Region(const Boundary& boundary, std::size_t face)
        : boundary_(boundary), plane_(*planeOf(boundary.faces[face])), faces_{face},
          outline_(boundary.faces[face].loops.front()) {}

    /// Whether the face was added: it is plane and beside the region, and no vertex gets on the outline
    /// twice.
    bool add(std::size_t face) {
        if (!fits(face)) return false;
        std::vector<EdgeUse> outline;
        const auto& uses = boundary_.faces[face].loops.front();
        const auto addOpen = [&](const std::vector<EdgeUse>& from, const std::vector<EdgeUse>& against) {
            for (const EdgeUse& use : from)
                if (std::ranges::find(against, use.edge, &EdgeUse::edge) == against.end())
                    outline.push_back(use);
        };
        addOpen(outline_, uses);
        addOpen(uses, outline_);
        std::vector<std::size_t> starts;
        starts.reserve(outline.size());
        for (const EdgeUse& use : outline)
            starts.push_back(startOf(boundary_, use));
        std::ranges::sort(starts);
        if (outline.size() > maxEdges || std::ranges::adjacent_find(starts) != starts.end()) return false;
        outline_ = std::move(outline);
        faces_.push_back(face);
        return true;
    }

    [[nodiscard]] const std::vector<std::size_t>& faces() const { return faces_; }
    [[nodiscard]] const std::vector<EdgeUse>& outline() const { return outline_; }
    [[nodiscard]] const gp_Pln& plane() const { return plane_; }

    /// The outline as loops, that around all others first.
    [[nodiscard]] std::vector<std::vector<EdgeUse>> loops() const {
        std::vector<std::vector<EdgeUse>> result;
        std::vector<EdgeUse> left = outline_;
        while (!left.empty()) {
            std::vector<EdgeUse>& loop = result.emplace_back();
            auto next = left.begin();
            do {
                loop.push_back(*next);
                left.erase(next);
                next = std::ranges::find(left, endOf(boundary_, loop.back()),
                                         [&](const EdgeUse& use) { return startOf(boundary_, use); });
            } while (next != left.end());
        }
        std::ranges::iter_swap(result.begin(), std::ranges::max_element(
                                                   result, {}, [&](const auto& loop) { return area(loop); }));
        return result;
    }

private:
    [[nodiscard]] bool fits(std::size_t face) const {
        const auto plane = planeOf(boundary_.faces[face]);
        if (!plane || plane->Axis().Direction().Angle(plane_.Axis().Direction()) > maxAngle) return false;
        return std::ranges::all_of(boundary_.faces[face].loops.front(), [&](const EdgeUse& use) {
            return distance(boundary_.edges[use.edge], plane_) <= boundary_.flatness;
        });
    }

    /// Twice the area inside; negative for a hole. Control points stand in for curves.
    [[nodiscard]] double area(const std::vector<EdgeUse>& loop) const {
        gp_XYZ sum(0, 0, 0);
        const gp_XYZ origin = plane_.Location().XYZ();
        for (const EdgeUse& use : loop) {
            const std::vector<gp_Pnt> points = controlPoints(boundary_.edges[use.edge].curve);
            for (std::size_t k = 1; k < points.size(); ++k) {
                const gp_XYZ cross = (points[k - 1].XYZ() - origin).Crossed(points[k].XYZ() - origin);
                sum += use.forwards ? cross : cross.Reversed();
            }
        }
        return sum.Dot(plane_.Axis().Direction().XYZ());
    }

    const Boundary& boundary_;
    gp_Pln plane_;
    std::vector<std::size_t> faces_;
    std::vector<EdgeUse> outline_;
};

/// All that can be added to a face, one by one; what cannot yet is tried again when the region has grown.
Region regionFrom(const Boundary& boundary, std::size_t face,
                  const std::vector<std::vector<std::size_t>>& facesOf, std::vector<bool>& taken) {
    Region region(boundary, face);
    taken[face] = true;
    for (bool grown = true; grown;) {
        grown = false;
        for (const EdgeUse& use : std::vector(region.outline()))
            for (const std::size_t beside : facesOf[use.edge])
                if (!taken[beside] && region.add(beside)) grown = taken[beside] = true;
    }
    return region;
}

} // namespace

bool mergePlanes(Boundary& boundary, std::vector<std::vector<std::size_t>>& origins) {
    const auto facesOf = facesOfEdges(boundary);
    std::vector<bool> taken(boundary.faces.size());
    std::vector<bool> isKept(boundary.faces.size(), true);
    std::vector<std::pair<std::size_t, std::vector<std::vector<EdgeUse>>>> merged;
    for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
        if (taken[f] || !planeOf(boundary.faces[f])) continue;
        const Region region = regionFrom(boundary, f, facesOf, taken);
        if (region.faces().size() == 1) continue;
        for (const std::size_t face : region.faces()) {
            isKept[face] = face == f;
            if (face != f) origins[f].insert(origins[f].end(), origins[face].begin(), origins[face].end());
        }
        std::ranges::sort(origins[f]);
        origins[f].erase(std::unique(origins[f].begin(), origins[f].end()), origins[f].end());
        for (const EdgeUse& use : region.outline()) {
            double& reach = boundary.edges[use.edge].tolerance;
            reach = std::max(reach, distance(boundary.edges[use.edge], region.plane()));
            for (const std::size_t end : boundary.edges[use.edge].ends)
                boundary.vertices[end].tolerance = std::max(boundary.vertices[end].tolerance, reach);
        }
        merged.emplace_back(f, region.loops());
    }
    if (merged.empty()) return false;
    for (auto& [face, loops] : merged)
        boundary.faces[face].loops = std::move(loops);
    const auto numbers = keepMarked(boundary.faces, isKept);
    (void)keepMarked(origins, isKept);
    for (BoundaryPart& part : boundary.parts) {
        std::erase_if(part.faces, [&](std::size_t face) { return !isKept[face]; });
        for (std::size_t& face : part.faces)
            face = numbers[face];
    }
    dropUnused(boundary);
    return true;
}

} // namespace qm
