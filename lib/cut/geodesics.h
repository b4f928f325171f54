/// \file Geodesic distances on part of a mesh (docs/METHOD.md#mesh-cut): a front as in Kimmel and Sethian
/// 1998 (docs/METHOD.md#kimmel-1998), virtual sources in polygons as in Melvær and Reimers 2012
/// (docs/METHOD.md#melvaer-2012).
#pragma once

#include "base/at.h"
#include "base/ids.h"
#include "cut/front.h"
#include "cut/surface_distances.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace qm {

/// Distances over the surface from a vertex, by advancing a front: a vertex is reached over an edge, a quad's
/// diagonal, or across a triangle from the virtual source of two vertices reached before. On flat parts that
/// is the straight distance but for rounding. On curved ones it is too short or too long by one per cent on
/// average and several at most, the less the finer the mesh; only between near neighbours in a quad that is
/// sheared beyond 45 degrees is it worse. It is no exact metric: there and back may differ as much.
class Geodesics : public SurfaceDistances {
public:
    /// \param labels  sub-mesh of every vertex; may change between calls
    Geodesics(const QuadMesh& mesh, const std::vector<SubMeshId>& labels);

    /// The same on any quads. Of a triangle or an edge, the last corner is repeated.
    /// \param quads  positions of their corners among the points
    Geodesics(const std::vector<Point>& points, const std::vector<std::array<int, 4>>& quads,
              const std::vector<SubMeshId>& labels);

    /// Distance from the source of every vertex of the source's sub-mesh, infinity for all vertices that
    /// cannot be reached inside it. Valid until the next call.
    const std::vector<double>& from(VertexId source) { return from(std::array{Start{source.idx(), 0}}); }

    /// Where a front begins, and how far from the source that is.
    struct Start {
        int vertex;
        double distance;
    };
    /// The same from several vertices of one sub-mesh, at least one.
    const std::vector<double>& from(std::span<const Start> starts);

    std::vector<double> between(VertexId source, const std::vector<VertexId>& targets) override;

private:
    struct Quad {
        std::array<int, 4> corners;
        std::array<double, 4> sides; ///< from corner k to the next
        std::array<double, 2> diagonals;

        [[nodiscard]] double length(unsigned i, unsigned j) const;
    };
    struct Node {
        double distance;
        int vertex;
        bool final;
        bool improved; ///< since the last vertex became final
    };

    [[nodiscard]] std::vector<int> numberNodes(const std::vector<Point>& points);
    void forget();
    void spread(int node, SubMeshId subMesh);
    void reach(const Quad& quad, unsigned from, unsigned to, SubMeshId subMesh);
    [[nodiscard]] double across(const Quad& quad, unsigned a, unsigned b, unsigned target,
                                double limit) const;
    [[nodiscard]] Node& nodeAt(int node) { return nodes_[at(node)]; }
    [[nodiscard]] const Node& nodeAt(int node) const { return nodes_[at(node)]; }

    const std::vector<SubMeshId>& labels_;
    std::vector<Node> nodes_; ///< the vertices in an order that has neighbours close to each other
    std::vector<int> nodeOf_; ///< of every vertex
    std::vector<Quad> quads_; ///< in the same order
    std::vector<std::uint32_t> firstCorner_;   ///< of every node, in cornersAround_; and the end
    std::vector<std::uint32_t> cornersAround_; ///< 4 * quad + corner
    std::vector<double> distance_;             ///< of every vertex
    std::vector<int> touched_;                 ///< nodes with a distance
    std::vector<int> improved_;                ///< nodes that have become nearer, to be queued
    Front front_;
};

} // namespace qm
