#include "layout/motorcycle_graph.h"

#include <utility>

namespace qm {

void MotorcycleGraph::add(Track track) {
    cost += track.cost;
    tracks.push_back(std::move(track));
}

} // namespace qm
