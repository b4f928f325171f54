/// \file The quasi-complexity U and the number of junctions n_j of one sub-mesh (docs/METHOD.md#mesh-cut).
#pragma once

#include "cut/cut.h"

#include <vector>

namespace qm {

/// Measures sub-meshes one by one, each in time linear in its own separatrices.
class Measure {
public:
    Measure(const QuadMesh& mesh, const BaseComplex& complex);

    /// \param separatrices  those that start in the sub-mesh
    /// \return the figures of the sub-mesh, without its terminals
    [[nodiscard]] SubMesh operator()(const std::vector<SeparatrixId>& separatrices,
                                     const std::vector<SubMeshId>& labels, SubMeshId subMesh);

    [[nodiscard]] VertexId sourceOf(SeparatrixId separatrix) const;

private:
    /// Number of halfedges up to the first vertex outside, or to the end of the particle's reach.
    [[nodiscard]] std::size_t reachInside(SeparatrixId separatrix,
                                          const std::vector<SubMeshId>& labels) const;

    const QuadMesh& mesh_;
    const BaseComplex& complex_;
    std::vector<int> seeds_;  ///< at every vertex
    std::vector<int> passes_; ///< particles that pass each vertex; all 0 between calls
};

} // namespace qm
