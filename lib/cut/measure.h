/// \file U and n_j of one sub-mesh (docs/METHOD.md#mesh-cut).
#pragma once

#include "cut/cut.h"

#include <vector>

namespace qm {

/// Measures sub-meshes one by one, each in time linear in its own separatrices.
class Measure {
public:
    Measure(const QuadMesh& mesh, const BaseComplex& complex);

    /// \param separatrices  that start in the sub-mesh
    /// \return without terminals
    [[nodiscard]] SubMesh operator()(const std::vector<std::size_t>& separatrices,
                                     const std::vector<SubMeshId>& labels, SubMeshId subMesh);

    [[nodiscard]] VertexId sourceOf(std::size_t separatrix) const;

private:
    /// Halfedges up to the first vertex outside, or to the end of the particle's way.
    [[nodiscard]] std::size_t reachInside(std::size_t separatrix, const std::vector<SubMeshId>& labels) const;

    const QuadMesh& mesh_;
    const BaseComplex& complex_;
    std::vector<int> seeds_;  ///< at every vertex
    std::vector<int> passes_; ///< of particles over every vertex; all 0 between two calls
};

} // namespace qm
