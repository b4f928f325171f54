#include "export/boundary/merge.h"
#include "export/simple/conic_curve.h"
#include "export/simple/curve_on_surface.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace qm {
namespace {

class Merging {
public:
    explicit Merging(Boundary& boundary)
        : boundary_(boundary), facesOf_(facesOfEdges(boundary)), faceBeside_(boundary.edges.size()),
          edgesAt_(boundary.vertices.size()), isMerged_(boundary.edges.size()) {
        forEachUse(boundary, [&](std::size_t face, const EdgeUse& use) {
            faceBeside_[use.edge].at(use.side()) = face;
        });
        for (auto& faces : facesOf_)
            std::ranges::sort(faces);
        for (std::size_t e = 0; e < boundary.edges.size(); ++e)
            for (const std::size_t end : boundary.edges[e].ends)
                edgesAt_[end].push_back(e);
    }

    bool run() {
        bool isAny = false;
        for (std::size_t v = 0; v < edgesAt_.size(); ++v)
            isAny = mergeAt(v) || isAny;
        if (!isAny) return false;
        for (BoundaryFace& face : boundary_.faces)
            for (auto& loop : face.loops)
                std::erase_if(loop, [&](const EdgeUse& use) { return isMerged_[use.edge]; });
        dropUnused(boundary_);
        return true;
    }

private:
    /// Merges the two edges that end at a vertex into the first of them.
    bool mergeAt(std::size_t vertex) {
        if (edgesAt_[vertex].size() != 2) return false;
        const auto [kept, dropped] = std::pair(edgesAt_[vertex][0], edgesAt_[vertex][1]);
        const BoundaryEdge& one = boundary_.edges[kept];
        const BoundaryEdge& other = boundary_.edges[dropped];
        if (kept == dropped || facesOf_[kept] != facesOf_[dropped] || one.isSmooth != other.isSmooth)
            return false;
        const std::size_t far = other.ends[other.ends[0] == vertex ? 1 : 0];
        const bool isAtEnd = one.ends[1] == vertex;
        if (far == one.ends[isAtEnd ? 0 : 1]) return false; // nothing would remain of the vertex
        const auto merged = extended(kept, isAtEnd, other);
        if (!merged) return false;
        boundary_.edges[kept] = *merged;
        boundary_.edges[kept].ends.at(isAtEnd ? 1 : 0) = far;
        isMerged_[dropped] = true;
        edgesAt_[vertex].clear();
        std::ranges::replace(edgesAt_[far], dropped, kept);
        return true;
    }

    /// The simple surface on a side of an edge, about where the edge has its curve already.
    [[nodiscard]] SimpleSurface surfaceBeside(std::size_t edge, std::size_t side) const {
        const auto& surface = boundary_.faces[faceBeside_[edge].at(side)].surface;
        const auto& known = boundary_.edges[edge].onFaces.at(side);
        return {Handle(Geom_ElementarySurface)::DownCast(surface), false, known->StartPoint().Y()};
    }

    /// An edge that takes in another one, at its end or at its start.
    [[nodiscard]] std::optional<BoundaryEdge> extended(std::size_t number, bool atEnd,
                                                       const BoundaryEdge& by) const {
        const BoundaryEdge& edge = boundary_.edges[number];
        // Towards its start, an edge is extended as the reverse would be at its end.
        const CurvePiece before = atEnd ? edge.curve : reversed(edge.curve);
        const auto after = continued(before, by.curve, boundary_.resolution);
        if (!after) return std::nullopt;
        BoundaryEdge result = edge;
        result.tolerance = std::max(edge.tolerance, by.tolerance);
        result.newAngle = std::max(edge.newAngle, by.newAngle);
        result.curve = atEnd ? *after : reversed(*after);
        for (std::size_t side = 0; side < 2; ++side) {
            auto& onFace = result.onFaces.at(side);
            if (onFace.IsNull()) continue;
            const CurveOnSurface found =
                curveOnSurface(result.curve, surfaceBeside(number, side), boundary_.resolution);
            if (toleranceOf(found.gap, boundary_.resolution) > result.tolerance) return std::nullopt;
            onFace = found.curve;
        }
        return result;
    }

    Boundary& boundary_;
    std::vector<std::vector<std::size_t>> facesOf_;      ///< by edge, ascending
    std::vector<std::array<std::size_t, 2>> faceBeside_; ///< by edge and side, as its curves on faces
    std::vector<std::vector<std::size_t>> edgesAt_;      ///< by vertex; none where edges were merged
    std::vector<bool> isMerged_;                         ///< by edge: into another one
};

} // namespace

bool mergeEdges(Boundary& boundary) {
    return Merging(boundary).run();
}

} // namespace qm
