#include "export/boundary/divided_edges.h"

#include <Geom_BSplineCurve.hxx>
#include <algorithm>
#include <utility>

namespace qm {
namespace {

/// The part of a spline between two of its parameters.
template <class Curve>
opencascade::handle<Curve> partOf(const opencascade::handle<Curve>& spline, double first, double last) {
    auto part = opencascade::handle<Curve>::DownCast(spline->Copy());
    part->Segment(first, last);
    return part;
}

/// The part of an edge between two parameters; its ends are those of the whole.
BoundaryEdge partOf(const BoundaryEdge& edge, double first, double last) {
    BoundaryEdge part = edge;
    if (const auto spline = Handle(Geom_BSplineCurve)::DownCast(edge.curve.curve); !spline.IsNull())
        part.curve = wholeCurve(partOf(spline, first, last));
    part.curve.first = first;
    part.curve.last = last;
    for (auto& curve : part.onFaces)
        if (!curve.IsNull()) curve = partOf(curve, first, last);
    return part;
}

/// The first part takes the edge's place, the second one becomes the last edge.
void divide(Boundary& boundary, std::size_t edge, double at) {
    const BoundaryEdge whole = boundary.edges[edge];
    BoundaryEdge second = partOf(whole, at, whole.curve.last);
    boundary.edges[edge] = partOf(whole, whole.curve.first, at);
    boundary.edges[edge].ends[1] = second.ends[0] = boundary.vertices.size();
    boundary.vertices.push_back({second.curve.start(), second.tolerance});
    boundary.edges.push_back(std::move(second));
}

/// A loop with both parts where one edge was.
/// \param second  by edge that there was: its second part, if it was divided
std::vector<EdgeUse> withParts(const std::vector<EdgeUse>& loop,
                               const std::vector<std::optional<std::size_t>>& second) {
    std::vector<EdgeUse> result;
    for (const EdgeUse& use : loop) {
        result.push_back(use);
        if (!second[use.edge]) continue;
        result.push_back({*second[use.edge], use.forwards});
        if (!use.forwards) std::iter_swap(result.end() - 1, result.end() - 2);
    }
    return result;
}

} // namespace

bool divideEdges(Boundary& boundary, const std::vector<std::optional<double>>& at) {
    std::vector<std::optional<std::size_t>> second(at.size());
    for (std::size_t e = 0; e < at.size(); ++e) {
        if (!at[e]) continue;
        second[e] = boundary.edges.size();
        divide(boundary, e, *at[e]);
    }
    for (BoundaryFace& face : boundary.faces)
        for (auto& loop : face.loops)
            loop = withParts(loop, second);
    return boundary.edges.size() > at.size();
}

} // namespace qm
