/// \file Interface for distances over the surface inside one sub-mesh.
#pragma once

#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

class SurfaceDistances {
public:
    SurfaceDistances() = default;
    SurfaceDistances(const SurfaceDistances&) = delete;
    SurfaceDistances& operator=(const SurfaceDistances&) = delete;
    virtual ~SurfaceDistances() = default;

    /// The distances from the source to some vertices of its sub-mesh, in their order; infinity for vertices
    /// that cannot be reached inside the sub-mesh.
    [[nodiscard]] virtual std::vector<double> between(VertexId source,
                                                      const std::vector<VertexId>& targets) = 0;
};

} // namespace qm
