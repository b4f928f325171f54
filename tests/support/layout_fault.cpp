#include "support/layout_fault.h"

#include "base/at.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace qm::test {

namespace {

/// For every edge, the number of tracks on it; the mesh boundary counts as one.
std::vector<int> timesOnBorder(const QuadMesh& mesh, const Layout& layout) {
    std::vector<int> times(mesh.n_edges(), 0);
    for (const EdgeId edge : mesh.edges())
        times[at(edge)] = mesh.is_boundary(edge);
    for (const LayoutTrack& track : layout.tracks)
        for (const HalfedgeId halfedge : track.track.halfedges)
            ++times[at(mesh.edge_handle(halfedge))];
    return times;
}

bool hasCorners(const QuadMesh& mesh, FaceId face, const std::array<VertexId, 4>& corners) {
    std::vector<VertexId> vertices;
    for (const VertexId vertex : mesh.fv_ccw_range(face))
        vertices.push_back(vertex);
    const auto first = std::find(vertices.begin(), vertices.end(), corners.front());
    std::rotate(vertices.begin(), first, vertices.end());
    return std::ranges::equal(vertices, corners);
}

std::string segmentFault(const QuadMesh& mesh, const Segment& segment, const std::vector<int>& border) {
    const auto a = static_cast<std::size_t>(segment.size[0]), b = static_cast<std::size_t>(segment.size[1]);
    if (a * b == 0 || segment.faces.size() != a * b) return "wrong number of faces";
    const std::vector<VertexId> grid = vertexGrid(mesh, segment);
    const auto vertex = [&](std::size_t i, std::size_t j) { return grid[j * (a + 1) + i]; };
    for (std::size_t j = 0; j < b; ++j)
        for (std::size_t i = 0; i < a; ++i)
            if (!hasCorners(mesh, segment.faces[j * a + i],
                            {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)}))
                return "face " + std::to_string(i) + ", " + std::to_string(j) + " is out of place";
    std::array<std::vector<VertexId>, 4> sides;
    for (std::size_t i = 0; i <= a; ++i) {
        sides[0].push_back(vertex(i, 0));
        sides[2].push_back(vertex(a - i, b));
    }
    for (std::size_t j = 0; j <= b; ++j) {
        sides[1].push_back(vertex(a, j));
        sides[3].push_back(vertex(0, b - j));
    }
    if (segment.sides != sides) return "the sides do not run around the faces";
    for (std::size_t k = 0; k < 4; ++k)
        if (segment.corners[k] != sides[k].front()) return "a corner does not begin its side";
    std::size_t onBorder = 0;
    for (const FaceId face : segment.faces)
        for (const EdgeId edge : mesh.fe_range(face))
            onBorder += border[at(edge)] > 0;
    return onBorder == 2 * (a + b) ? "" : "a border runs inside it, or none along a side";
}

} // namespace

std::string layoutFault(const QuadMesh& mesh, const Layout& layout) {
    const std::vector<int> border = timesOnBorder(mesh, layout);
    if (std::ranges::any_of(border, [](int times) { return times > 1; })) return "an edge is border twice";
    std::vector<int> segmentsOf(mesh.n_faces(), 0);
    FaceId lowestBefore(-1);
    for (std::size_t s = 0; s < layout.segments.size(); ++s) {
        const Segment& segment = layout.segments[s];
        if (const std::string fault = segmentFault(mesh, segment, border); !fault.empty())
            return "segment " + std::to_string(s) + ": " + fault;
        for (const FaceId face : segment.faces)
            ++segmentsOf[at(face)];
        const FaceId lowest = *std::min_element(segment.faces.begin(), segment.faces.end());
        if (lowest < lowestBefore) return "segment " + std::to_string(s) + " is out of order";
        lowestBefore = lowest;
    }
    if (std::ranges::any_of(segmentsOf, [](int times) { return times != 1; }))
        return "a quad is not in exactly one segment";
    double cost = 0;
    for (const Track& track : properTracks(layout))
        cost += track.cost;
    return std::abs(cost - layout.cost) < 1e-9 * (1 + std::abs(cost)) ? "" : "wrong cost";
}

std::vector<Path> soundPaths(const QuadMesh& mesh, const Layout& layout) {
    EXPECT_EQ(layoutFault(mesh, layout), "");
    std::vector<Path> paths;
    for (const Track& track : properTracks(layout))
        paths.push_back(pathOf(mesh, track));
    return paths;
}

} // namespace qm::test
