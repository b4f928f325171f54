/// \file Geodesic distances on a small sub-mesh, over all of its vertices (docs/METHOD.md#mesh-cut).
#pragma once

#include "base/ids.h"
#include "cut/geodesics.h"
#include "cut/surface_distances.h"

#include <optional>
#include <vector>

namespace qm {

class FineGeodesics : public SurfaceDistances {
public:
    /// \param labels  sub-mesh of every vertex; may change between calls. Both must outlive the object.
    FineGeodesics(const QuadMesh& mesh, const std::vector<SubMeshId>& labels);

    /// Prepares for another sub-mesh, in little more than linear time in its size.
    /// \param vertices  all vertices of one sub-mesh, ascending
    void prepare(const std::vector<VertexId>& vertices);

    /// \pre all vertices belong to the sub-mesh prepared last
    std::vector<double> between(VertexId source, const std::vector<VertexId>& targets) override;

private:
    const QuadMesh& mesh_;
    const std::vector<SubMeshId>& labels_;
    std::vector<int> indexOf_; ///< of every vertex in its sub-mesh
    std::optional<Geodesics> front_;
};

} // namespace qm
