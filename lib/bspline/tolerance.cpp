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

/// How close curves and patches are fitted, as shares of the tolerance, and whether they may slide along the
/// mesh.
struct Closeness {
    double ofCurves;
    double ofPatches;
    bool slides;
};
/// In the last one every sample is within the tolerance of its own point of the mesh: it cannot be missed.
constexpr std::array<Closeness, 2> levels = {{{0.65, 1, true}, {0.5, 1, false}}};

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
    input.endSlope = -lines.tangent(mesh.opposite_halfedge_handle(chain.halfedges.back()));
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

/// The halfedges of a side, in its direction.
std::vector<HalfedgeId> sideHalfedges(const Chains& chains, std::size_t patch, int side) {
    std::vector<HalfedgeId> halfedges;
    for (const SidePiece& piece : chains.pieces(patch, side))
        for (int k = 0; k < piece.length; ++k)
            halfedges.push_back(
                chains.halfedge({piece.place.chain, piece.place.way, piece.place.position + k}));
    return halfedges;
}

/// Derivatives into the patch at the vertices of a side; none if the side has no smooth edge with a
/// neighbour.
std::vector<Point> inwards(const QuadMesh& mesh, const LineDerivatives& lines,
                           const std::vector<HalfedgeId>& side) {
    bool smooth = false;
    for (const HalfedgeId halfedge : side) {
        const EdgeId edge = mesh.edge_handle(halfedge);
        smooth = smooth || (!mesh.is_boundary(edge) && lines.isSmooth(edge));
    }
    std::vector<Point> result;
    if (!smooth) return result;
    for (const HalfedgeId halfedge : side)
        result.push_back(lines.tangent(mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(halfedge))));
    result.push_back(lines.tangent(mesh.next_halfedge_handle(side.back())));
    return result;
}

/// From the derivatives into the patch along its sides to partial derivatives along its parameters.
void setAcross(PatchFitInput& input, std::array<std::vector<Point>, 4> sides) {
    for (const std::size_t turned : {2U, 3U})
        std::reverse(sides[turned].begin(), sides[turned].end());
    for (const std::size_t farther : {1U, 2U})
        for (Point& point : sides[farther])
            point = -point;
    input.across = {{{sides[0], sides[2]}, {sides[3], sides[1]}}};
}

} // namespace

ToleranceFit::ToleranceFit(const QuadMesh& mesh, const Layout& layout,
                           const std::vector<double>& dihedralAngles, double rho, double tolerance,
                           unsigned jobs)
    : mesh_(mesh), layout_(layout), tolerance_(tolerance), jobs_(jobs), chains_(mesh, layout),
      lines_(mesh, dihedralAngles, rho), valences_(borderValences(mesh, chains_)),
      exact_(exactly * boundingBoxDiagonal(mesh)), levels_(layout.segments.size(), 0),
      curves_(chains_.all().size()), patches_(layout.segments.size()) {
    fitCurves(std::vector<bool>(curves_.size(), true));
    fitPatches(std::vector<bool>(patches_.size(), true));
}

void ToleranceFit::tighten(const std::vector<bool>& missed) {
    constexpr int fewCalls = 3;
    const auto before = chainLevels();
    ++calls_;
    for (std::size_t k = 0; k < levels_.size(); ++k)
        if (calls_ > fewCalls)
            levels_[k] = levels.size() - 1; // neighbours may go on passing it back and forth: no longer
        else if (missed[k])
            levels_[k] = std::min(levels_[k] + 1, levels.size() - 1);
    const auto after = chainLevels();
    std::vector<bool> chains(curves_.size());
    for (std::size_t k = 0; k < chains.size(); ++k)
        chains[k] = after[k] != before[k];
    fitCurves(chains);
    std::vector<bool> patches(patches_.size());
    for (std::size_t k = 0; k < patches.size(); ++k)
        patches[k] = missed[k] || calls_ > fewCalls || touches(k, chains);
    fitPatches(patches);
}

/// A curve is fitted as closely as the closest patch beside it.
std::vector<std::size_t> ToleranceFit::chainLevels() const {
    std::vector<std::size_t> result(curves_.size(), 0);
    for (std::size_t k = 0; k < levels_.size(); ++k)
        for (int side = 0; side < 4; ++side)
            for (const SidePiece& piece : chains_.pieces(k, side))
                result[piece.place.chain] = std::max(result[piece.place.chain], levels_[k]);
    return result;
}

bool ToleranceFit::touches(std::size_t patch, const std::vector<bool>& chains) const {
    for (int side = 0; side < 4; ++side)
        for (const SidePiece& piece : chains_.pieces(patch, side))
            if (chains[piece.place.chain]) return true;
    return false;
}

void ToleranceFit::fitCurves(const std::vector<bool>& which) {
    const auto chainLevel = chainLevels();
    parallelFor(curves_.size(), jobs_, [&](std::size_t k) {
        if (!which[k]) return;
        const Closeness& closeness = levels.at(chainLevel[k]);
        curves_[k] = fitCurve(curveInput(mesh_, chains_.all()[k], lines_, valences_),
                              closeness.ofCurves * tolerance_, exact_, closeness.slides);
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
    std::array<SplineCurve, 4> border;
    std::array<std::vector<Point>, 4> across;
    std::array<Point, 4> twists;
    for (std::size_t side = 0; side < 4; ++side) {
        border[side] = sideCurve(chains_, curves_, patch, static_cast<int>(side));
        const auto halfedges = sideHalfedges(chains_, patch, static_cast<int>(side));
        across[side] = inwards(mesh_, lines_, halfedges);
        twists[side] = lines_.twist(halfedges.front());
    }
    input.border = {{{border[0], reversed(border[2])}, {reversed(border[3]), border[1]}}};
    setAcross(input, std::move(across));
    // The edges that leave corners 1 and 3 run against one of the parameters: the sign turns.
    input.twists = {twists[0], -twists[1], -twists[3], twists[2]};
    const Closeness& closeness = levels.at(levels_[patch]);
    patches_[patch] = fitPatch(input, closeness.ofPatches * tolerance_, closeness.slides);
    patches_[patch].segment = SegmentId(patch);
}

} // namespace qm
