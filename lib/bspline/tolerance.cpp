#include "bspline/tolerance.h"

#include "base/parallel.h"
#include "bspline/interpolate.h"
#include "bspline/patch_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace qm {
namespace {

/// What makes a point of a border curve "exactly" at a vertex, as a fraction of the diagonal.
constexpr double exactly = 1e-12;

/// How close curves are fitted, as shares of what their patches are; the second where nothing may slide:
/// there every sample is within the tolerance of its own point of the mesh, and it cannot be missed.
constexpr double curveShare = 0.95;
constexpr double certainCurveShare = 0.5;

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

SplineCurve sideCurve(const Chains& chains, const std::vector<SplineCurve>& curves, std::size_t patch,
                      int side) {
    std::vector<SplineCurve> parts;
    for (const SidePiece& piece : chains.pieces(patch, side)) {
        const SplineCurve& forwards = curves[piece.place.chain];
        const double begin = piece.place.position;
        const double end = begin + piece.length;
        const double length = forwards.length();
        parts.push_back(piece.place.way == 0 ? restricted(forwards, begin, end)
                                             : reversed(restricted(forwards, length - end, length - begin)));
    }
    return joined(parts);
}

/// Normals along a side, in its direction, at `normalParameters`.
std::vector<Point> sideNormals(const Chains& chains, const NormalField& field, std::size_t patch, int side) {
    const std::vector<double> shares = normalParameters(1);
    std::vector<Point> normals;
    for (const SidePiece& piece : chains.pieces(patch, side))
        for (int k = 0; k < piece.length; ++k)
            for (const double share : shares)
                normals.push_back(
                    field.at({piece.place.chain, piece.place.way, piece.place.position + k}, share));
    return normals;
}

} // namespace

ToleranceFit::ToleranceFit(const QuadMesh& mesh, const Layout& layout,
                           const std::vector<double>& dihedralAngles, double rho, double tolerance,
                           unsigned jobs)
    : mesh_(mesh), layout_(layout), tolerance_(tolerance), jobs_(jobs), chains_(mesh, layout),
      lines_(mesh, dihedralAngles, rho), field_(mesh, chains_, lines_), corners_(mesh, chains_, lines_),
      sharing_(chains_, layout), valences_(borderValences(mesh, chains_)),
      exact_(exactly * boundingBoxDiagonal(mesh)), closeness_(mesh.n_vertices()),
      curves_(chains_.all().size()), patches_(layout.segments.size()) {
    fitCurves(std::vector<bool>(curves_.size(), true));
    fitPatches(std::vector<bool>(patches_.size(), true));
}

std::vector<bool> ToleranceFit::tighten(const std::vector<std::vector<DeviatingPlace>>& places) {
    constexpr int fewCalls = 5;
    ++calls_;
    const auto before = closeness_;
    comeCloser(mesh_, layout_, places, tolerance_, closeness_);
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (calls_ <= fewCalls || (calls_ <= fewCalls + 3 && places[k].empty())) continue;
        for (const VertexId vertex : vertexGrid(mesh_, layout_.segments[k]))
            closeness_[static_cast<std::size_t>(vertex.idx())] = {1, false};
    }
    const auto changed = [&](VertexId vertex) {
        const auto k = static_cast<std::size_t>(vertex.idx());
        return closeness_[k] != before[k];
    };
    std::vector<bool> chains(curves_.size());
    for (std::size_t k = 0; k < chains.size(); ++k)
        chains[k] = std::ranges::any_of(chains_.all()[k].halfedges, [&](HalfedgeId halfedge) {
            return changed(mesh_.from_vertex_handle(halfedge)) || changed(mesh_.to_vertex_handle(halfedge));
        });
    fitCurves(chains);
    std::vector<bool> patches(patches_.size());
    for (std::size_t k = 0; k < patches.size(); ++k)
        patches[k] =
            touches(k, chains) || std::ranges::any_of(vertexGrid(mesh_, layout_.segments[k]), changed);
    fitPatches(patches);
    return patches;
}

bool ToleranceFit::touches(std::size_t patch, const std::vector<bool>& chains) const {
    for (int side = 0; side < 4; ++side)
        for (const SidePiece& piece : chains_.pieces(patch, side))
            if (chains[piece.place.chain]) return true;
    return false;
}

CurveFitInput ToleranceFit::curveInput(std::size_t number) const {
    const BorderChain& chain = chains_.all()[number];
    CurveFitInput input;
    const auto addPoint = [&](VertexId vertex) {
        input.points.push_back(mesh_.point(vertex));
        Closeness closeness = closeness_[static_cast<std::size_t>(vertex.idx())];
        closeness.share *= closeness.slides ? curveShare : certainCurveShare;
        input.closeness.push_back(closeness);
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
            input.planes.push_back({point, normal});
        const Point direction = corners_[halfedge];
        if (direction.sqrnorm() == 0) return;
        const Point normal = lines_.normalOnLeft(halfedge);
        input.planes.push_back({point, normal % direction});
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

void ToleranceFit::fitCurves(const std::vector<bool>& which) {
    parallelFor(curves_.size(), jobs_, [&](std::size_t k) {
        if (which[k]) curves_[k] = fitCurve(curveInput(k), tolerance_, exact_);
    });
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round)
        shareKnots(which);
    lowerDegrees(which);
    parallelFor(curves_.size(), jobs_, [&](std::size_t k) {
        if (which[k]) curves_[k] = inTangentPlanes(curveInput(k), tolerance_, exact_, curves_[k]);
    });
    field_.setCurves(curves_);
}

/// One curve after another: each may take over knots that its patches have anyway, in exchange for others.
void ToleranceFit::shareKnots(const std::vector<bool>& which) {
    for (std::size_t k = 0; k < curves_.size(); ++k) {
        if (!which[k]) continue;
        std::vector<double> places;
        for (const KnotPlace& place : sharing_.places(k, curves_))
            places.push_back(place.parameter);
        if (places.empty()) continue;
        if (auto curve = fitCurveOver(curveInput(k), tolerance_, exact_, curves_[k], places))
            curves_[k] = std::move(*curve);
    }
}

/// As far as patches gain by it: they need the degree of the side with the higher one.
void ToleranceFit::lowerDegrees(const std::vector<bool>& which) {
    std::vector<SplineCurve> lower = curves_;
    parallelFor(curves_.size(), jobs_, [&](std::size_t k) {
        if (which[k]) lower[k] = withLeastDegree(curveInput(k), tolerance_, exact_, curves_[k], 1);
    });
    std::vector<int> useful(curves_.size(), 3);
    for (std::size_t patch = 0; patch < patches_.size(); ++patch)
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
                         : withLeastDegree(curveInput(k), tolerance_, exact_, curves_[k], useful[k]);
    });
}

void ToleranceFit::fitPatches(const std::vector<bool>& which) {
    parallelFor(patches_.size(), jobs_, [&](std::size_t k) {
        if (which[k]) fitOne(k);
    });
}

void ToleranceFit::fitOne(std::size_t patch) {
    const Segment& segment = layout_.segments[patch];
    const auto grid = pointGrid(mesh_, segment);
    PatchFitInput input;
    input.size = segment.size;
    input.grid = grid;
    std::vector<Closeness> closeness;
    for (const VertexId vertex : vertexGrid(mesh_, segment))
        closeness.push_back(closeness_[static_cast<std::size_t>(vertex.idx())]);
    input.closeness = closeness;
    std::array<SplineCurve, 4> border;
    std::array<std::vector<Point>, 4> normals;
    for (std::size_t side = 0; side < 4; ++side) {
        border[side] = sideCurve(chains_, curves_, patch, static_cast<int>(side));
        normals[side] = sideNormals(chains_, field_, patch, static_cast<int>(side));
    }
    for (const std::size_t turned : {2U, 3U})
        std::reverse(normals[turned].begin(), normals[turned].end());
    input.border = {{{border[0], reversed(border[2])}, {reversed(border[3]), border[1]}}};
    input.normals = {{{normals[0], normals[2]}, {normals[3], normals[1]}}};
    patches_[patch] = fitPatch(input, tolerance_);
    patches_[patch].segment = SegmentId(patch);
}

} // namespace qm
