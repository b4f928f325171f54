/// \file Which chains cross each other, and clusters of them.
#pragma once

#include "enumerate/state/problem.h"

#include <vector>

namespace qm {

class ChainLinks {
public:
    explicit ChainLinks(const Problem& problem);

    /// The chains that cross this one, ascending; itself among them if it crosses itself.
    [[nodiscard]] const std::vector<int>& neighbours(int chain) const {
        return neighbours_[static_cast<std::size_t>(chain)];
    }

    /// Grows a cluster from a chain: the chain that crosses the cluster most often for its length comes next,
    /// until the cluster has this many variables.
    /// \param weights  of every chain: a factor that makes it come earlier
    [[nodiscard]] std::vector<int> cluster(int chain, std::size_t variables,
                                           const std::vector<double>& weights) const;

private:
    std::vector<int> lengths_;
    std::vector<std::vector<int>> neighbours_;
    std::vector<std::vector<int>> crossings_; ///< with each neighbour
};

} // namespace qm
