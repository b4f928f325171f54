#include "bspline/reference/planes/plane_corners.h"

#include "base/at.h"
#include "bspline/reference/lattice/sound_faces.h"
#include "bspline/reference/planes/orthogonal_normals.h"
#include "bspline/splines/eigen_point.h"
#include "mesh/parallel_elements.h"
#include "mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace qm {
namespace {

/// Least length of what is left of a derivative in the planes, as a share of it: it turns by 60 degrees.
constexpr double minLeft = 0.5;
/// A halfedge that leaves a vertex, with a face: a crease, if there is one; on the boundary the first.
HalfedgeId firstLeaving(const QuadMesh& mesh, VertexId vertex, const std::vector<bool>& isCrease) {
    const HalfedgeId any = mesh.halfedge_handle(vertex);
    if (mesh.is_boundary(any)) return mesh.ccw_rotated_halfedge_handle(any);
    for (const HalfedgeId leaving : mesh.voh_range(vertex))
        if (isCrease[at(mesh.edge_handle(leaving))]) return leaving;
    return any;
}

} // namespace

PlaneCorners::PlaneCorners(const MeshLattice& lattice, const Sharpness& sharpness, double flatness,
                           unsigned jobs)
    : mesh_(lattice.numbers().mesh()), rules_(sharpness.rules),
      parts_(planeParts(mesh_, sharpness.edges, flatness, jobs)),
      ofCorner_(mesh_.n_halfedges(), PlaneParts::none) {
    if (parts_.planes.empty()) return;
    const std::vector<bool> isUnfolded = soundVertices(mesh_, jobs, notFolded);
    const auto forVertices = [&](const auto& work) {
        parallelForVertices(mesh_, jobs, [&](VertexId vertex) {
            if (isUnfolded[at(vertex)] && !mesh_.is_isolated(vertex)) work(vertex);
        });
    };
    forVertices([&](VertexId vertex) { findSectors(vertex, sharpness.edges); });
    forVertices([&](VertexId vertex) {
        if (isBound(vertex) && turnsMuch(lattice, vertex)) release(vertex);
    });
    parallelForFaces(mesh_, jobs, [&](FaceId face) { keepIfWhole(face); });
    forVertices([&](VertexId vertex) { findSectors(vertex, sharpness.edges); });
}

bool PlaneCorners::isBound(VertexId vertex) const {
    return std::ranges::any_of(mesh_.voh_range(vertex), [&](HalfedgeId leaving) {
        return ofCorner_[at(leaving)] != PlaneParts::none;
    });
}

/// Gives every corner around a vertex the part that its sector has.
void PlaneCorners::findSectors(VertexId vertex, const std::vector<bool>& isCrease) {
    const std::vector<HalfedgeId> leaving = leavingFrom(mesh_, firstLeaving(mesh_, vertex, isCrease));
    for (std::size_t begin = 0, end = 0; begin < leaving.size(); begin = end) {
        int part = PlaneParts::none;
        bool isOne = true;
        for (end = begin; end < leaving.size(); ++end) {
            if (end > begin && isCrease[at(mesh_.edge_handle(leaving[end]))]) break;
            const int ofQuad = partBeside(leaving[end]);
            if (ofQuad == PlaneParts::none) continue;
            isOne = isOne && (part == PlaneParts::none || part == ofQuad);
            part = ofQuad;
        }
        for (std::size_t k = begin; k < end; ++k)
            ofCorner_[at(leaving[k])] = isOne ? part : PlaneParts::none;
    }
}

/// A quad of a part is whole if the part has all its corners.
void PlaneCorners::keepIfWhole(FaceId face) {
    int& part = parts_.ofFace[at(face)];
    if (std::ranges::any_of(mesh_.fh_range(face),
                            [&](HalfedgeId side) { return ofCorner_[at(side)] != part; }))
        part = PlaneParts::none;
}

void PlaneCorners::release(VertexId vertex) {
    for (const HalfedgeId leaving : mesh_.voh_range(vertex))
        ofCorner_[at(leaving)] = PlaneParts::none;
}

/// Whether a line at a vertex would turn much to lie in its planes, or cannot.
bool PlaneCorners::turnsMuch(const MeshLattice& lattice, VertexId vertex) const {
    return std::ranges::any_of(mesh_.voh_range(vertex), [&](HalfedgeId leaving) {
        constexpr double maxOff = 1e-6;
        const Point derivative = lattice.derivative(leaving);
        const Point left = within(leaving, derivative);
        if (!(left.norm() >= minLeft * derivative.norm())) return true;
        return std::ranges::any_of(partsOf(leaving), [&](int part) {
            return std::abs(plane(part).normal | left) > maxOff * derivative.norm();
        });
    });
}

std::vector<int> PlaneCorners::partsOf(HalfedgeId leaving) const {
    std::vector<int> parts;
    const auto addBeside = [&](HalfedgeId line) {
        const HalfedgeId back = mesh_.opposite_halfedge_handle(line);
        for (const HalfedgeId corner :
             {line, mesh_.is_boundary(back) ? line : mesh_.next_halfedge_handle(back)})
            if (ofCorner_[at(corner)] != PlaneParts::none) parts.push_back(ofCorner_[at(corner)]);
    };
    addBeside(leaving);
    const HalfedgeId onward = rules_[at(mesh_.from_vertex_handle(leaving))].onward(leaving);
    if (onward.is_valid()) addBeside(onward);
    return parts;
}

Point PlaneCorners::within(HalfedgeId leaving, const Point& derivative) const {
    OrthogonalNormals normals;
    Eigen::Vector3d left = vector(derivative);
    for (const int part : partsOf(leaving))
        if (const auto direction = normals.add(vector(plane(part).normal)))
            left -= left.dot(*direction) * *direction;
    return point(left);
}

} // namespace qm
