#include "bspline/border_curves.h"

#include "base/parallel.h"
#include "bspline/bounding_box.h"
#include "bspline/patch_fit.h"

#include <algorithm>
#include <utility>

namespace qm {
namespace {

/// What makes a point of a border curve "exactly" at a vertex, as a fraction of the diagonal.
constexpr double exactly = 1e-12;

/// How close curves are fitted, as shares of what their patches are; the second where nothing may slide:
/// there every sample is within the tolerance of its own point of the mesh, and it cannot be missed.
constexpr double curveShare = 0.95;
constexpr double certainCurveShare = 0.5;

/// How near tangents come to planes that no other curve has to share.
constexpr double loose = 0.15;

/// How many border edges meet at each vertex, by vertex index.
std::vector<int> borderValences(const QuadMesh& mesh, const Chains& chains) {
    std::vector<int> valences(mesh.n_vertices(), 0);
    for (const BorderChain& chain : chains.all())
        for (const HalfedgeId halfedge : chain.halfedges) {
            ++valences[static_cast<std::size_t>(mesh.from_vertex_handle(halfedge).idx())];
            ++valences[static_cast<std::size_t>(mesh.to_vertex_handle(halfedge).idx())];
        }
    return valences;
}

} // namespace

BorderCurves::BorderCurves(const QuadMesh& mesh, const Layout& layout,
                           const std::vector<double>& dihedralAngles, double rho, double tolerance,
                           double tangency, unsigned jobs)
    : mesh_(mesh), tolerance_(tolerance), jobs_(jobs), patches_(layout.segments.size()),
      chains_(mesh, layout), lines_(mesh, dihedralAngles, rho), field_(mesh, chains_, lines_),
      corners_(mesh, chains_, lines_), sharing_(chains_, layout), valences_(borderValences(mesh, chains_)),
      exact_(exactly * boundingBoxDiagonal(mesh)), tangency_(chains_.all().size(), tangency),
      curves_(chains_.all().size()) {}

void BorderCurves::fit(const std::vector<bool>& which, const std::vector<Closeness>& closeness) {
    std::vector<CurveFitInput> inputs(curves_.size());
    parallelFor(curves_.size(), jobs_, [&](std::size_t k) {
        if (!which[k]) return;
        inputs[k] = input(k, closeness);
        curves_[k] = fitCurve(inputs[k], tolerance_, exact_);
    });
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round)
        shareKnots(which, inputs);
    lowerDegrees(which, inputs);
    constexpr int agreements = 3;
    for (int round = 0; round < agreements; ++round) {
        parallelFor(curves_.size(), jobs_, [&](std::size_t k) {
            if (which[k]) curves_[k] = inTangentPlanes(input(k, closeness), tolerance_, exact_, curves_[k]);
        });
        field_.setCurves(curves_);
    }
}

bool BorderCurves::isSmooth(HalfedgeId halfedge) const {
    return lines_.isSmoothInside(mesh_.edge_handle(halfedge));
}

void BorderCurves::loosen(std::size_t patch) {
    for (int side = 0; side < 4; ++side)
        for (const SidePiece& piece : chains_.pieces(patch, side))
            tangency_[piece.place.chain] = loose;
}

bool BorderCurves::touches(std::size_t patch, const std::vector<bool>& chains) const {
    for (int side = 0; side < 4; ++side)
        for (const SidePiece& piece : chains_.pieces(patch, side))
            if (chains[piece.place.chain]) return true;
    return false;
}

CurveFitInput BorderCurves::input(std::size_t number, const std::vector<Closeness>& closeness) const {
    const BorderChain& chain = chains_.all()[number];
    CurveFitInput input;
    const auto addPoint = [&](VertexId vertex) {
        input.points.push_back(mesh_.point(vertex));
        Closeness here = closeness[static_cast<std::size_t>(vertex.idx())];
        here.share *= here.slides ? curveShare : certainCurveShare;
        input.closeness.push_back(here);
    };
    addPoint(mesh_.from_vertex_handle(chain.halfedges.front()));
    for (const HalfedgeId halfedge : chain.halfedges) {
        const VertexId vertex = mesh_.to_vertex_handle(halfedge);
        if (valences_[static_cast<std::size_t>(vertex.idx())] > 2)
            input.fixed.push_back(static_cast<int>(input.points.size()));
        addPoint(vertex);
    }
    if (!input.fixed.empty() && input.fixed.back() == chain.length())
        input.fixed.pop_back(); // ends are met anyway
    input.startSlope = lines_.tangent(chain.halfedges.front());
    const HalfedgeId back = mesh_.opposite_halfedge_handle(chain.halfedges.back());
    input.endSlope = -lines_.tangent(back);
    const auto add = [&](int point, HalfedgeId halfedge) {
        if (field_.isTJoint(mesh_.from_vertex_handle(halfedge))) return;
        for (const Point& normal : field_.tangentPlanes(halfedge))
            input.planes.push_back(
                {point, normal, field_.corners().isShared(halfedge) ? tangency_[number] : loose});
        const Point direction = corners_[halfedge];
        if (direction.sqrnorm() == 0) return;
        const Point normal = lines_.normalOnLeft(halfedge);
        input.planes.push_back({point, normal % direction, loose});
        if (point == 0)
            input.startSlope = input.startSlope.norm() * direction;
        else
            input.endSlope = -input.endSlope.norm() * direction;
    };
    add(0, chain.halfedges.front());
    for (const int fixed : input.fixed)
        add(fixed, chain.halfedges[static_cast<std::size_t>(fixed)]);
    add(chain.length(), back);
    return input;
}

/// One curve after another: each may take over knots that its patches have anyway, in exchange for others.
void BorderCurves::shareKnots(const std::vector<bool>& which, const std::vector<CurveFitInput>& inputs) {
    for (std::size_t k = 0; k < curves_.size(); ++k) {
        if (!which[k]) continue;
        std::vector<double> places;
        for (const KnotPlace& place : sharing_.places(k, curves_))
            places.push_back(place.parameter);
        if (places.empty()) continue;
        if (auto curve = fitCurveOver(inputs[k], tolerance_, exact_, curves_[k], places))
            curves_[k] = std::move(*curve);
    }
}

/// As far as patches gain by it: they need the degree of the side with the higher one.
void BorderCurves::lowerDegrees(const std::vector<bool>& which, const std::vector<CurveFitInput>& inputs) {
    std::vector<SplineCurve> lower = curves_;
    parallelFor(curves_.size(), jobs_, [&](std::size_t k) {
        if (which[k]) lower[k] = withLeastDegree(inputs[k], tolerance_, exact_, curves_[k], 1);
    });
    std::vector<int> useful(curves_.size(), 3);
    for (std::size_t patch = 0; patch < patches_; ++patch)
        for (const int side : {0, 1}) {
            const auto& one = chains_.pieces(patch, side);
            const auto& other = chains_.pieces(patch, side + 2);
            if (one.size() > 1 || other.size() > 1) continue;
            const std::size_t a = one.front().place.chain;
            const std::size_t b = other.front().place.chain;
            const int degree = std::max(lower[a].degree, lower[b].degree);
            useful[a] = std::min(useful[a], degree);
            useful[b] = std::min(useful[b], degree);
        }
    parallelFor(curves_.size(), jobs_, [&](std::size_t k) {
        if (!which[k] || useful[k] == 3) return;
        curves_[k] = useful[k] == lower[k].degree
                         ? lower[k]
                         : withLeastDegree(inputs[k], tolerance_, exact_, curves_[k], useful[k]);
    });
}

SplineCurve BorderCurves::side(std::size_t patch, int side) const {
    std::vector<SplineCurve> parts;
    for (const SidePiece& piece : chains_.pieces(patch, side)) {
        const SplineCurve& forwards = curves_[piece.place.chain];
        const double begin = piece.place.position;
        const double end = begin + piece.length;
        const double length = forwards.length();
        parts.push_back(piece.place.way == 0 ? restricted(forwards, begin, end)
                                             : reversed(restricted(forwards, length - end, length - begin)));
    }
    return joined(parts);
}

std::vector<Point> BorderCurves::normals(std::size_t patch, int side) const {
    std::vector<Point> normals;
    for (const SidePiece& piece : chains_.pieces(patch, side))
        for (int k = 0; k < piece.length; ++k)
            for (const double share : normalShares)
                normals.push_back(
                    field_.at({piece.place.chain, piece.place.way, piece.place.position + k}, share));
    return normals;
}

} // namespace qm
