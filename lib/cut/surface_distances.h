/// \file Distances over the surface inside one sub-mesh, however they are found.
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

    /// Distance from the source to each of some vertices of its sub-mesh, in their order; infinity to those
    /// that cannot be reached inside it.
    [[nodiscard]] virtual std::vector<double> between(VertexId source,
                                                      const std::vector<VertexId>& targets) = 0;
};

} // namespace qm
