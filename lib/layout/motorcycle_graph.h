/// \file Tracks and motorcycle graphs as geometry, the result of the search (docs/METHOD.md#valid-tracks).
#pragma once

#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// The path of one particle, from its source to its crash point.
struct Track {
    std::vector<HalfedgeId> halfedges; ///< consecutive, at least one
    double cost = 0;                   ///< F(T): sum of the costs of its edges
};

/// Tracks that together leave only four-sided segments. No edge lies on two of them.
struct MotorcycleGraph {
    double cost = 0; ///< G_T, the sum of the tracks' costs
    std::vector<Track> tracks;

    void add(Track track);
};

} // namespace qm
