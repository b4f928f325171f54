#include "export/boundary/shared_edges.h"

#include "base/at.h"
#include "bspline/measure/border_measures.h"
#include "mesh/topology.h"

#include <algorithm>
#include <optional>
#include <span>

namespace qm {
namespace {

constexpr int samples = 9; ///< of gap and angle along every mesh edge
/// Angle between normals, in degrees, below which two patches are one smooth surface for any program.
constexpr double exactAngle = 0.01;

/// For every side of every patch, the number of the border edge at each position.
using BorderNumbers = std::vector<std::array<std::vector<std::size_t>, 4>>;

BorderNumbers borderNumbers(const Layout& layout, const std::vector<BorderEdge>& borders) {
    BorderNumbers numbers(layout.segments.size());
    for (std::size_t s = 0; s < numbers.size(); ++s)
        for (std::size_t side = 0; side < 4; ++side)
            numbers[s][side].resize(layout.segments[s].sides[side].size() - 1);
    for (std::size_t b = 0; b < borders.size(); ++b)
        for (const auto& [patch, side, position] : borders[b].places)
            numbers[patch][at(side)][at(position)] = b;
    return numbers;
}

/// How far the two patches of a border edge are apart there.
struct Difference {
    double gap = 0;
    double angle = 0; ///< between their normals, in degrees
};

std::vector<Difference> differences(const Layout& layout, const std::vector<Patch>& patches,
                                    const std::vector<BorderEdge>& borders) {
    std::vector<Difference> result(borders.size());
    for (std::size_t b = 0; b < borders.size(); ++b)
        if (borders[b].places.size() > 1) {
            const MeetingMeasures measures = measureBorder(borders[b], layout, patches, samples);
            result[b] = {measures.gap, std::ranges::max(measures.angles)};
        }
    return result;
}

/// Vertices where more than two border edges meet, a patch has a corner, or a crease becomes smooth: other
/// programs fail on an edge that is a crease in part.
std::vector<bool> meetingPoints(const QuadMesh& mesh, const Layout& layout,
                                const std::vector<BorderEdge>& borders,
                                const std::vector<Difference>& differences) {
    std::vector<int> valence(mesh.n_vertices(), 0);
    std::vector<int> smooth(mesh.n_vertices(), 0);
    for (std::size_t b = 0; b < borders.size(); ++b)
        for (const VertexId vertex : endsOf(mesh, borders[b].halfedge)) {
            ++valence[at(vertex)];
            if (differences[b].angle < exactAngle) ++smooth[at(vertex)];
        }
    std::vector<bool> result(mesh.n_vertices());
    for (std::size_t v = 0; v < valence.size(); ++v)
        result[v] = valence[v] > 2 || smooth[v] == 1;
    for (const Segment& segment : layout.segments)
        for (const VertexId corner : segment.corners)
            result[at(corner)] = true;
    return result;
}

/// The edge that some border edges are, without its places.
SharedEdge edgeAlong(std::span<const std::size_t> borders, const std::vector<Difference>& differences,
                     VertexId start, VertexId end) {
    SharedEdge edge{{}, static_cast<int>(borders.size()), start, end};
    for (const std::size_t border : borders) {
        edge.gap = std::max(edge.gap, differences[border].gap);
        edge.angle = std::max(edge.angle, differences[border].angle);
    }
    return edge;
}

/// Cuts every side where borders meet. The first patch that comes along makes the edge.
SharedEdges cutSides(const QuadMesh& mesh, const Layout& layout, const std::vector<Patch>& patches) {
    const auto borders = borderEdges(mesh, layout);
    const auto numbers = borderNumbers(layout, borders);
    const auto difference = differences(layout, patches, borders);
    const auto meets = meetingPoints(mesh, layout, borders, difference);
    std::vector<std::optional<std::size_t>> edgeOf(borders.size());
    SharedEdges result;
    result.ofPatch.resize(layout.segments.size());
    for (std::size_t s = 0; s < layout.segments.size(); ++s)
        for (int side = 0; side < 4; ++side) {
            const auto& line = numbers[s][at(side)];
            const auto& vertices = layout.segments[s].sides[at(side)];
            for (std::size_t begin = 0, end = 1; end < vertices.size(); ++end) {
                if (!meets[at(vertices[end])]) continue;
                const auto run = std::span(line).subspan(begin, end - begin);
                const bool isNew = !edgeOf[run.front()];
                if (isNew) {
                    for (const std::size_t border : run)
                        edgeOf[border] = result.edges.size();
                    result.edges.push_back(edgeAlong(run, difference, vertices[begin], vertices[end]));
                }
                const std::size_t edge = *edgeOf[run.front()];
                result.edges[edge].places.push_back({s, side, static_cast<int>(begin)});
                result.ofPatch[s].push_back({edge, isNew});
                begin = end;
            }
        }
    return result;
}

} // namespace

SharedEdges shareEdges(const QuadMesh& mesh, const Layout& layout, const std::vector<Patch>& patches) {
    SharedEdges result = cutSides(mesh, layout, patches);
    std::vector<double> count(mesh.n_vertices(), 0);
    result.vertexPoint.assign(mesh.n_vertices(), Point(0, 0, 0));
    for (const SharedEdge& edge : result.edges)
        for (std::size_t use = 0; use < edge.places.size(); ++use)
            for (const bool atEnd : {false, true}) {
                const std::size_t vertex = at(atEnd == (use == 0) ? edge.end : edge.start);
                result.vertexPoint[vertex] +=
                    pointAt(layout, patches, edge.places[use], atEnd ? edge.length : 0).position;
                ++count[vertex];
            }
    for (std::size_t v = 0; v < count.size(); ++v)
        if (count[v] > 0) result.vertexPoint[v] /= count[v];
    return result;
}

} // namespace qm
