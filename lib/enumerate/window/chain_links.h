/// \file Which chains cross each other, and clusters of chains that cross often.
#pragma once

#include "enumerate/state/problem.h"

#include <vector>

namespace qm {

class ChainLinks {
public:
    explicit ChainLinks(const Problem& problem);

    /// The chains that cross a chain, ascending; includes the chain itself if it crosses itself.
    [[nodiscard]] const std::vector<ChainId>& neighbours(ChainId chain) const { return neighbours_[chain]; }

    /// Grows a cluster from a chain until it has at least this many variables. Next comes always the chain
    /// with the most crossings with the cluster, relative to its length; of equals, the lowest. Takes time
    /// linear in the crossings of the cluster, up to a logarithm.
    /// \param weights  of every chain, not negative; the higher, the earlier it is added
    [[nodiscard]] std::vector<ChainId> cluster(ChainId chain, std::size_t variables,
                                               const IdVector<ChainId, double>& weights) const;

private:
    IdVector<ChainId, int> lengths_; ///< number of variables of every chain
    IdVector<ChainId, std::vector<ChainId>> neighbours_;
    IdVector<ChainId, std::vector<int>> crossings_; ///< number of crossings with each neighbour
};

} // namespace qm
