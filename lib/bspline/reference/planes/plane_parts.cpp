#include "bspline/reference/planes/plane_parts.h"

#include "base/at.h"
#include "bspline/reference/planes/plane_growth.h"
#include "mesh/parallel_elements.h"
#include "mesh/quad_geometry.h"

#include <algorithm>
#include <cstddef>

namespace qm {
namespace {

constexpr int none = PlaneParts::none;
/// Flats are so many times as wide as the strips of a rounding beside them, or more.
constexpr double muchWider = 3;

/// Tells parts that are meant to be plane from facets of something round.
class Flats {
public:
    Flats(const QuadMesh& mesh, const std::vector<bool>& isCrease, const std::vector<FlatQuad>& quads,
          PlaneParts& parts)
        : mesh_(mesh), isCrease_(isCrease), quads_(quads), parts_(parts) {}

    /// Few quads lie in one plane by chance, as those of a cylinder in rows, or those on a large triangle
    /// that a mesh was made from: without many vertices inside, only parts that are much wider than all quads
    /// that continue them are flats.
    void dropSmallParts() {
        constexpr int many = 4;
        const std::vector<int> inside = verticesInside();
        std::vector<bool> continues(parts_.planes.size());
        std::vector<bool> isNarrow(parts_.planes.size());
        forOutlines([&](int part, HalfedgeId side) {
            if (isCrease_[at(mesh_.edge_handle(side))]) return;
            continues[at(part)] = true;
            if (width(side) < muchWider * width(mesh_.opposite_halfedge_handle(side)))
                isNarrow[at(part)] = true;
        });
        keep([&](int part) {
            return inside[at(part)] >= many || (continues[at(part)] && !isNarrow[at(part)]);
        });
    }

    /// Quads of facets may have been divided: parts that along most of their outlines continue in others not
    /// much narrower are facets.
    void dropFacets() {
        std::vector<double> areas(parts_.planes.size());
        std::vector<double> outlines(parts_.planes.size());
        for (const FaceId face : mesh_.faces())
            if (const int part = parts_.ofFace[at(face)]; part != none)
                areas[at(part)] += quads_[at(face)].area;
        forOutlines([&](int part, HalfedgeId side) { outlines[at(part)] += mesh_.calc_edge_length(side); });
        const auto widthOf = [&](int part) { return areas[at(part)] / outlines[at(part)]; };
        std::vector<double> shared(parts_.planes.size());
        forOutlines([&](int part, HalfedgeId side) {
            const int beyond = partBeyond(side);
            if (isCrease_[at(mesh_.edge_handle(side))] || beyond == none) return;
            if (widthOf(part) < muchWider * widthOf(beyond)) shared[at(part)] += mesh_.calc_edge_length(side);
        });
        keep([&](int part) { return 2 * shared[at(part)] <= outlines[at(part)]; });
    }

private:
    /// By part: the number of vertices that its quads surround.
    [[nodiscard]] std::vector<int> verticesInside() const {
        std::vector<int> result(parts_.planes.size());
        for (const VertexId vertex : mesh_.vertices())
            if (const int part = partAround(mesh_, parts_, isCrease_, vertex); part != none)
                ++result[at(part)];
        return result;
    }

    /// Calls a function for every side of a part that is a crease or has another part, or none, beyond.
    template <class Function> void forOutlines(const Function& function) const {
        for (const HalfedgeId side : mesh_.halfedges()) {
            const int part = partBeside(side);
            if (part == none) continue;
            if (isCrease_[at(mesh_.edge_handle(side))] || partBeyond(side) != part) function(part, side);
        }
    }

    template <class Predicate> void keep(const Predicate& isKept) {
        for (int& part : parts_.ofFace)
            if (part != none && !isKept(part)) part = none;
    }

    [[nodiscard]] int partBeside(HalfedgeId side) const { return parts_.beside(mesh_, side); }
    [[nodiscard]] int partBeyond(HalfedgeId side) const {
        return partBeside(mesh_.opposite_halfedge_handle(side));
    }

    /// Of the quad beside a halfedge, at right angles to it.
    [[nodiscard]] double width(HalfedgeId side) const {
        return quads_[at(mesh_.face_handle(side))].area / mesh_.calc_edge_length(side);
    }

    const QuadMesh& mesh_;
    const std::vector<bool>& isCrease_;
    const std::vector<FlatQuad>& quads_;
    PlaneParts& parts_;
};

} // namespace

int partAround(const QuadMesh& mesh, const PlaneParts& parts, const std::vector<bool>& isCrease,
               VertexId vertex) {
    if (mesh.is_isolated(vertex) || mesh.is_boundary(vertex)) return none;
    const int part = parts.ofFace[at(*mesh.cvf_iter(vertex))];
    const bool isAround =
        std::ranges::all_of(mesh.vf_range(vertex),
                            [&](FaceId face) { return parts.ofFace[at(face)] == part; }) &&
        std::ranges::none_of(mesh.ve_range(vertex), [&](EdgeId edge) { return isCrease[at(edge)]; });
    return isAround ? part : none;
}

PlaneParts planeParts(const QuadMesh& mesh, const std::vector<bool>& isCrease, double flatness,
                      unsigned jobs) {
    std::vector<FlatQuad> quads(mesh.n_faces());
    parallelForFaces(mesh, jobs, [&](FaceId face) {
        const auto [a, b, c, d] = cornerPoints(mesh, face);
        quads[at(face)] = {middleNormal(mesh, face).value_or(Point(0, 0, 0)), ((c - a) % (d - b)).norm() / 2};
    });
    PlaneParts parts = grownPlaneParts(mesh, isCrease, quads, flatness, jobs);
    Flats flats(mesh, isCrease, quads, parts);
    flats.dropSmallParts();
    flats.dropFacets();
    const bool areNone = std::ranges::all_of(parts.ofFace, [](int part) { return part == none; });
    if (areNone) parts.planes.clear(); // so that it is seen at once
    return parts;
}

} // namespace qm
