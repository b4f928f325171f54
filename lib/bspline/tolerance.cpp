#include "bspline/tolerance.h"

#include "base/parallel.h"
#include "bspline/curve_fit.h"
#include "bspline/deviation.h"
#include "bspline/interpolate.h"
#include "bspline/patch_fit.h"

#include <algorithm>
#include <array>

namespace qm {
namespace {

/// What makes a point of a border curve "exactly" at a vertex, as a fraction of the diagonal.
constexpr double exactly = 1e-12;

/// How close curves are fitted, as shares of what their patches are; the second where nothing may slide:
/// then every sample is within the tolerance of its own point of the mesh, and it cannot be missed.
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

CurveFitInput curveInput(const QuadMesh& mesh, const BorderChain& chain, const LineDerivatives& lines,
                         const NormalField& field, const CornerDirections& corners,
                         const std::vector<int>& valences) {
    CurveFitInput input;
    input.points.push_back(mesh.point(mesh.from_vertex_handle(chain.halfedges.front())));
    for (const HalfedgeId halfedge : chain.halfedges) {
        const VertexId vertex = mesh.to_vertex_handle(halfedge);
        if (valences[static_cast<std::size_t>(vertex.idx())] > 2)
            input.fixed.push_back(static_cast<int>(input.points.size()));
        input.points.push_back(mesh.point(vertex));
    }
    if (!input.fixed.empty() && input.fixed.back() == chain.length())
        input.fixed.pop_back(); // ends are met anyway
    input.startSlope = lines.tangent(chain.halfedges.front());
    const HalfedgeId back = mesh.opposite_halfedge_handle(chain.halfedges.back());
    input.endSlope = -lines.tangent(back);
    const auto add = [&](int point, HalfedgeId halfedge) {
        if (field.isTJoint(mesh.from_vertex_handle(halfedge))) return;
        for (const Point& normal : field.tangentPlanes(halfedge))
            input.planes.push_back({point, normal});
        const Point direction = corners[halfedge];
        if (direction.sqrnorm() == 0) return;
        const Point normal = lines.normalOnLeft(halfedge);
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
      exact_(exactly * boundingBoxDiagonal(mesh)), closeness_(layout.segments.size()),
      curves_(chains_.all().size()), patches_(layout.segments.size()) {
    fitCurves(std::vector<bool>(curves_.size(), true));
    fitPatches(std::vector<bool>(patches_.size(), true));
}

void ToleranceFit::tighten(const std::vector<double>& deviations) {
    constexpr int fewCalls = 5;
    constexpr double least = 0.5;
    const auto before = chainCloseness();
    ++calls_;
    std::vector<bool> patches(patches_.size());
    for (std::size_t k = 0; k < patches.size(); ++k) {
        Closeness& closeness = closeness_[k];
        const double excess = deviations[k] / tolerance_;
        patches[k] = excess > 1;
        if (patches[k]) closeness.share *= std::max(0.96 / excess, 0.7);
        const bool impatient = calls_ > fewCalls + 3 || (patches[k] && calls_ > fewCalls);
        if (impatient || closeness.share < least) closeness = {1, false};
    }
    const auto after = chainCloseness();
    std::vector<bool> chains(curves_.size());
    for (std::size_t k = 0; k < chains.size(); ++k)
        chains[k] = after[k] != before[k];
    fitCurves(chains);
    for (std::size_t k = 0; k < patches.size(); ++k)
        patches[k] = patches[k] || calls_ > fewCalls + 3 || touches(k, chains);
    fitPatches(patches);
}

/// A curve is fitted as closely as the closest patch beside it.
std::vector<ToleranceFit::Closeness> ToleranceFit::chainCloseness() const {
    std::vector<Closeness> result(curves_.size(), {curveShare, true});
    for (std::size_t k = 0; k < closeness_.size(); ++k) {
        const Closeness& patch = closeness_[k];
        for (int side = 0; side < 4; ++side)
            for (const SidePiece& piece : chains_.pieces(k, side)) {
                Closeness& chain = result[piece.place.chain];
                chain.share =
                    std::min(chain.share, patch.slides ? curveShare * patch.share : certainCurveShare);
                chain.slides = chain.slides && patch.slides;
            }
    }
    return result;
}

bool ToleranceFit::touches(std::size_t patch, const std::vector<bool>& chains) const {
    for (int side = 0; side < 4; ++side)
        for (const SidePiece& piece : chains_.pieces(patch, side))
            if (chains[piece.place.chain]) return true;
    return false;
}

void ToleranceFit::fitCurves(const std::vector<bool>& which) {
    const auto closeness = chainCloseness();
    parallelFor(curves_.size(), jobs_, [&](std::size_t k) {
        if (!which[k]) return;
        curves_[k] = fitCurve(curveInput(mesh_, chains_.all()[k], lines_, field_, corners_, valences_),
                              closeness[k].share * tolerance_, exact_, closeness[k].slides);
    });
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round)
        shareKnots(which);
    field_.setCurves(curves_);
}

/// One curve after another: each may take over knots that its patches have anyway, in exchange for others.
void ToleranceFit::shareKnots(const std::vector<bool>& which) {
    const auto closeness = chainCloseness();
    for (std::size_t k = 0; k < curves_.size(); ++k) {
        if (!which[k]) continue;
        std::vector<double> places;
        for (const KnotPlace& place : sharing_.places(k, curves_))
            places.push_back(place.parameter);
        if (places.empty()) continue;
        if (auto curve = fitCurveOver(
                curveInput(mesh_, chains_.all()[k], lines_, field_, corners_, valences_),
                closeness[k].share * tolerance_, exact_, closeness[k].slides, curves_[k], places))
            curves_[k] = std::move(*curve);
    }
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
    const Closeness& closeness = closeness_[patch];
    patches_[patch] = fitPatch(input, closeness.share * tolerance_, closeness.slides);
    patches_[patch].segment = SegmentId(patch);
}

} // namespace qm
