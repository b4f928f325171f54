#include "bspline/corner_normals.h"

#include "bspline/eigen_point.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace qm {

CornerNormals::CornerNormals(const QuadMesh& mesh, const Chains& chains, const LineDerivatives& lines)
    : mesh_(mesh), chains_(chains), lines_(lines), shared_(mesh.n_halfedges(), false),
      normals_(mesh.n_halfedges(), Point(0, 0, 0)) {
    std::vector<bool> done(mesh.n_vertices(), false);
    const auto visit = [&](HalfedgeId leaving) {
        const auto vertex = static_cast<std::size_t>(mesh.from_vertex_handle(leaving).idx());
        if (done[vertex]) return;
        done[vertex] = true;
        findSectors(leaving);
    };
    for (const BorderChain& chain : chains.all()) {
        visit(chain.halfedges.front());
        visit(mesh.opposite_halfedge_handle(chain.halfedges.back()));
    }
    for (const Sector& sector : sectors_)
        for (const HalfedgeId halfedge : sector.within)
            shared_[static_cast<std::size_t>(halfedge.idx())] = true;
}

void CornerNormals::findSectors(HalfedgeId first) {
    const auto endsSector = [&](HalfedgeId halfedge) {
        return !lines_.isSmoothInside(mesh_.edge_handle(halfedge));
    };
    std::vector<HalfedgeId> around;
    HalfedgeId halfedge = first;
    do {
        around.push_back(halfedge);
        halfedge = mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(halfedge));
    } while (halfedge != first);
    // Begin at the end of a sector, if there is one.
    const auto begin = std::ranges::find_if(around, endsSector);
    if (begin != around.end()) std::rotate(around.begin(), begin, around.end());
    Sector sector;
    const auto close = [&] {
        constexpr std::size_t inAnyPlane = 2;
        if (sector.borders.size() > inAnyPlane && !sector.within.empty()) sectors_.push_back(sector);
        sector = {};
    };
    const auto add = [&](HalfedgeId h) {
        if (chains_.isBorder(mesh_.edge_handle(h))) sector.borders.push_back(h);
    };
    for (const HalfedgeId h : around) {
        add(h);
        if (endsSector(h)) {
            close();
            add(h);
        }
        if (!mesh_.is_boundary(h)) sector.within.push_back(h);
    }
    if (endsSector(around.front())) add(around.front());
    close();
}

/// The derivative, where the halfedge begins, of the curve over it.
Point CornerNormals::tangent(HalfedgeId halfedge, const std::vector<SplineCurve>& curves) const {
    const ChainPlace place = chains_.place(halfedge);
    const SplineCurve& curve = curves[place.chain];
    const double at = place.way == 0 ? place.position : curve.length() - place.position;
    const Point slope = derivative(curve, at);
    return place.way == 0 ? slope : Point(-slope);
}

void CornerNormals::setCurves(const std::vector<SplineCurve>& curves) {
    constexpr double leastSpread = 0.3;  // of the tangents, within the plane
    constexpr double leastCosine = 0.95; // of the angle to the mesh's normal
    for (const Sector& sector : sectors_) {
        Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
        for (const HalfedgeId border : sector.borders) {
            const Eigen::Vector3d direction = vector(tangent(border, curves)).normalized();
            sum += direction * direction.transpose();
        }
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(sum);
        const Eigen::Vector3d normal = axes.eigenvectors().col(0);
        const double cosine = normal.dot(vector(lines_.normalOnLeft(sector.within.front())));
        const bool good = axes.eigenvalues()[1] > leastSpread && std::abs(cosine) > leastCosine;
        for (const HalfedgeId h : sector.within)
            normals_[static_cast<std::size_t>(h.idx())] =
                good ? point(cosine > 0 ? normal : Eigen::Vector3d(-normal)) : Point(0, 0, 0);
    }
}

bool CornerNormals::isShared(HalfedgeId halfedge) const {
    const HalfedgeId right = mesh_.next_halfedge_handle(mesh_.opposite_halfedge_handle(halfedge));
    return shared_[static_cast<std::size_t>(halfedge.idx())] ||
           shared_[static_cast<std::size_t>(right.idx())];
}

Point CornerNormals::onLeft(HalfedgeId halfedge) const {
    const Point& normal = normals_[static_cast<std::size_t>(halfedge.idx())];
    return normal.sqrnorm() > 0 ? normal : lines_.normalOnLeft(halfedge);
}

} // namespace qm
