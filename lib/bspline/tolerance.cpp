#include "bspline/tolerance.h"

#include "base/parallel.h"
#include "bspline/chains.h"
#include "bspline/curve_fit.h"
#include "bspline/deviation.h"
#include "bspline/interpolate.h"
#include "bspline/line_derivatives.h"
#include "bspline/patch_fit.h"

#include <algorithm>

namespace qm {
namespace {

/// What makes a point of a border curve "exactly" at a vertex, as a fraction of the diagonal.
constexpr double exactly = 1e-12;

/// How many border edges meet at each vertex, by vertex index.
std::vector<int> borderValences(const QuadMesh& mesh, const Chains& chains) {
    std::vector<int> valences(mesh.n_vertices(), 0);
    for (const Chain& chain : chains.all())
        for (const HalfedgeId halfedge : chain.halfedges) {
            ++valences[static_cast<std::size_t>(mesh.from_vertex_handle(halfedge).idx())];
            ++valences[static_cast<std::size_t>(mesh.to_vertex_handle(halfedge).idx())];
        }
    return valences;
}

CurveFitInput curveInput(const QuadMesh& mesh, const Chain& chain, const LineDerivatives& lines,
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

std::vector<Patch> fitWithinTolerance(const QuadMesh& mesh, const Layout& layout,
                                      const std::vector<double>& dihedralAngles, double rho, double tolerance,
                                      unsigned jobs) {
    const Chains chains(mesh, layout);
    const LineDerivatives lines(mesh, dihedralAngles, rho);
    const auto valences = borderValences(mesh, chains);
    const double exact = exactly * boundingBoxDiagonal(mesh);
    std::vector<SplineCurve> curves(chains.all().size());
    parallelFor(curves.size(), jobs, [&](std::size_t k) {
        curves[k] = fitCurve(curveInput(mesh, chains.all()[k], lines, valences), tolerance / 2, exact);
    });

    std::vector<Patch> patches(layout.segments.size());
    parallelFor(patches.size(), jobs, [&](std::size_t k) {
        const Segment& segment = layout.segments[k];
        const auto grid = pointGrid(mesh, segment);
        PatchFitInput input;
        input.size = segment.size;
        input.grid = grid;
        std::array<SplineCurve, 4> border;
        std::array<std::vector<Point>, 4> across;
        std::array<Point, 4> twists;
        for (std::size_t side = 0; side < 4; ++side) {
            border[side] = sideCurve(chains, curves, k, static_cast<int>(side));
            const auto halfedges = sideHalfedges(chains, k, static_cast<int>(side));
            across[side] = inwards(mesh, lines, halfedges);
            twists[side] = lines.twist(halfedges.front());
        }
        input.border = {{{border[0], reversed(border[2])}, {reversed(border[3]), border[1]}}};
        setAcross(input, std::move(across));
        // The edges that leave corners 1 and 3 run against one of the parameters: the sign turns.
        input.twists = {twists[0], -twists[1], -twists[3], twists[2]};
        patches[k] = fitPatch(input, tolerance);
        patches[k].segment = SegmentId(k);
    });
    return patches;
}

} // namespace qm
