/// \file One step of Catmull-Clark subdivision of polygons, with sharp edges.
#pragma once

#include "mesh/soup/soup.h"
#include "remesh/polygons/polygon_edges.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace qm {

/// The points that a step makes: one for every vertex, edge and face.
struct StepPoints {
    std::vector<Point> vertices, edges, faces;
};

/// The step of [Catmull and Clark 1978](docs/METHOD.md#catmull-1978) for one surface, whatever the places of
/// its vertices, with the rules of [DeRose et al. 1998](docs/METHOD.md#derose-1998) for sharp edges.
class SubdivisionStep {
public:
    /// \param soup  polygons, whose vertices tell where curves of sharp edges have corners; it must outlive
    /// the step
    SubdivisionStep(const Soup& soup, const PolygonEdges& edges);

    /// Without smoothing: the middles of edges and faces.
    [[nodiscard]] StepPoints straight(const std::vector<Point>& vertices) const;

    [[nodiscard]] StepPoints from(const std::vector<Point>& control) const;

    /// The points of the mesh whose step ends in the given vertices.
    [[nodiscard]] StepPoints through(const std::vector<Point>& vertices) const;

private:
    /// How a vertex moves.
    struct VertexRule {
        std::array<std::int64_t, 2> along{}; ///< the other ends of its first two sharp edges
        std::size_t sharpEdges = 0;
        std::size_t edges = 0;
        bool stays = true; ///< as a corner does

        void addEdge(std::int64_t other, bool isSharp);
    };

    [[nodiscard]] std::vector<Point> vertexPoints(const std::vector<Point>& control,
                                                  const StepPoints& middles) const;
    void smoothEdges(StepPoints& points) const;

    const Soup& soup_;
    const PolygonEdges& edges_;
    std::vector<VertexRule> rules_;
};

} // namespace qm
