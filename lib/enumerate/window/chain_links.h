/// \file Which chains are close to each other, and clusters of chains that are (docs/METHOD.md#windows).
#pragma once

#include "enumerate/state/assignment.h"
#include "enumerate/state/problem.h"

#include <vector>

namespace qm {

class ChainLinks {
public:
    /// Links chains whose lines cross.
    explicit ChainLinks(const Problem& problem);
    /// Links chains whose tracks cross or touch in a graph. Most lines cross many others far from their own
    /// track, and a window of such lines is walled in by the tracks of all others.
    ChainLinks(const Problem& problem, const Assignment& graph);

    /// The chains linked to a chain, ascending; includes the chain itself if it crosses itself.
    [[nodiscard]] const std::vector<ChainId>& neighbours(ChainId chain) const { return neighbours_[chain]; }

    /// Grows a cluster from a chain until it has at least this many variables, or its tracks have. Next comes
    /// always the chain with the most crossings with the cluster, relative to its length or that of its
    /// tracks; of equals, the lowest. Takes time linear in the crossings of the cluster, up to a logarithm.
    /// \param weights  of every chain, not negative; the higher, the earlier it is added
    [[nodiscard]] std::vector<ChainId> cluster(ChainId chain, std::size_t variables,
                                               const IdVector<ChainId, double>& weights) const;

private:
    ChainLinks(const Problem& problem, const IdVector<VariableId, ChainId>& chainOf);

    IdVector<ChainId, int> lengths_; ///< number of variables of every chain, or of its tracks
    IdVector<ChainId, std::vector<ChainId>> neighbours_;
    IdVector<ChainId, std::vector<int>> crossings_; ///< number of crossings with each neighbour
};

} // namespace qm
