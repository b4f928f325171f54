/// \file Which chains cross each other, and clusters of them.
#pragma once

#include "enumerate/state/problem.h"

#include <vector>

namespace qm {

class ChainLinks {
public:
    explicit ChainLinks(const Problem& problem);

    /// The chains that cross this one, ascending; itself among them if it crosses itself.
    [[nodiscard]] const std::vector<ChainId>& neighbours(ChainId chain) const { return neighbours_[chain]; }

    /// Grows a cluster from a chain: the chain that crosses the cluster most often for its length comes next,
    /// until the cluster has this many variables.
    /// \param weights  of every chain: a factor that makes it come earlier
    [[nodiscard]] std::vector<ChainId> cluster(ChainId chain, std::size_t variables,
                                               const IdVector<ChainId, double>& weights) const;

private:
    IdVector<ChainId, int> lengths_; ///< variables
    IdVector<ChainId, std::vector<ChainId>> neighbours_;
    IdVector<ChainId, std::vector<int>> crossings_; ///< how many with each neighbour
};

} // namespace qm
