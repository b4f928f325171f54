/// \file The connected components of a part of the mesh.
#pragma once

#include "base/at.h"
#include "base/disjoint_sets.h"
#include "base/ids.h"
#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// Looks at one set of vertices after the other, each in time linear in its own vertices.
class LabelComponents {
public:
    /// \param labels  of every vertex; may change between calls. Both must outlive the object.
    LabelComponents(const QuadMesh& mesh, const std::vector<SubMeshId>& labels);

    /// Numbers the components by their lowest vertices, from 0.
    /// \param vertices  all of one label, ascending
    /// \return how many there are
    int number(const std::vector<VertexId>& vertices);

    /// \param vertex  of the last set
    [[nodiscard]] int componentOf(VertexId vertex) const { return component_[at(vertex)]; }

private:
    const QuadMesh& mesh_;
    const std::vector<SubMeshId>& labels_;
    DisjointSets connected_;     ///< vertices of the last set
    std::vector<int> component_; ///< by vertex
};

} // namespace qm
