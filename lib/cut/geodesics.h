/// \file Geodesic distances over quads (docs/METHOD.md#mesh-cut): a front as in Kimmel and Sethian
/// 1998 (docs/METHOD.md#kimmel-1998), virtual sources in polygons as in Melvær and Reimers 2012
/// (docs/METHOD.md#melvaer-2012).
#pragma once

#include "base/at.h"
#include "cut/bucket_queue.h"
#include "mesh/quad_mesh.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace qm {

/// Distances over the surface from a vertex, by advancing a front. A vertex is reached over an edge, over a
/// quad's diagonal, or across a triangle from the virtual source of two vertices reached before. On flat
/// parts this is the straight distance up to rounding. On curved parts the error is one per cent on average
/// and several at most, and less on finer meshes; it is larger only between close neighbours in quads sheared
/// beyond 45 degrees. The distance is no exact metric: both directions may differ by as much.
class Geodesics {
public:
    /// \param points  the vertices
    /// \param quads   indices of their corners in `points`; a triangle or an edge repeats its last corner
    Geodesics(const std::vector<Point>& points, const std::vector<std::array<int, 4>>& quads);

    /// A vertex where a front begins, and its distance from the source.
    struct Start {
        int vertex;
        double distance;
    };

    /// The distance of every vertex from the source; infinity for vertices that cannot be reached. Valid
    /// until the next call.
    /// \param starts  at least one
    const std::vector<double>& from(std::span<const Start> starts);

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
        bool improved; ///< whether it was, since the last vertex became final
    };

    [[nodiscard]] std::vector<int> numberNodes(const std::vector<Point>& points);
    void forget();
    void spread(int node);
    void reach(const Quad& quad, unsigned from, unsigned to);
    [[nodiscard]] double across(const Quad& quad, unsigned a, unsigned b, unsigned target,
                                double limit) const;
    [[nodiscard]] Node& nodeAt(int node) { return nodes_[at(node)]; }
    [[nodiscard]] const Node& nodeAt(int node) const { return nodes_[at(node)]; }

    std::vector<Node> nodes_; ///< vertices in an order that keeps neighbours close together
    std::vector<int> nodeOf_; ///< of every vertex
    std::vector<Quad> quads_; ///< in the order of the nodes
    /// Index of every node's first entry in cornersAround_, and the end.
    std::vector<std::uint32_t> firstCorner_;
    std::vector<std::uint32_t> cornersAround_; ///< 4 * quad + corner
    std::vector<double> distance_;             ///< of every vertex
    std::vector<int> touched_;                 ///< nodes with a distance
    std::vector<int> improved_;                ///< nodes that have become nearer and must be queued
    BucketQueue front_;
};

} // namespace qm
