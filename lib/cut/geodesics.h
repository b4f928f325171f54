/// \file Geodesic distances on part of a mesh.
#pragma once

#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// Distances over the surface from a vertex, by advancing a front: a vertex is reached over an edge, a quad's
/// diagonal, or across a triangle from the virtual source of two vertices reached before. On flat parts that
/// is the straight distance but for rounding; elsewhere the error is a few per cent at most.
class Geodesics {
public:
    /// \param part    of every vertex: the number of the part it belongs to
    Geodesics(const QuadMesh& mesh, const std::vector<int>& part);

    /// Distance from the source of every vertex of the source's part, infinity for those that cannot be
    /// reached inside it. Other entries are whatever an earlier call left there.
    const std::vector<double>& from(VertexId source);

private:
    void spread(VertexId vertex, int part);
    [[nodiscard]] double across(VertexId target, VertexId a, VertexId b) const;

    const QuadMesh& mesh_;
    const std::vector<int>& part_;
    std::vector<double> distance_;
    std::vector<int> lastRun_;     ///< the run in which a vertex got its distance
    std::vector<int> acceptedRun_; ///< the run in which its distance became final
    std::vector<std::pair<double, int>> queue_;
    int run_ = 0;
};

} // namespace qm
