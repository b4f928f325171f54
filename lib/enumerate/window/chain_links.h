/// \file Which chains cross each other, and clusters of them.
#pragma once

#include "enumerate/state/problem.h"

#include <vector>

namespace qm {

class ChainLinks {
public:
    explicit ChainLinks(const Problem& problem);

    /// Those that cross the chain, ascending, and the chain itself if it does.
    [[nodiscard]] const std::vector<int>& neighbours(int chain) const {
        return neighbours_[static_cast<std::size_t>(chain)];
    }

    /// The chain and others, always the one next that crosses the cluster most for its length, until they
    /// have this many variables.
    /// \param weights  of every chain: how much rather than others it is taken
    [[nodiscard]] std::vector<int> cluster(int chain, std::size_t variables,
                                           const std::vector<double>& weights) const;

private:
    std::vector<int> lengths_;
    std::vector<std::vector<int>> neighbours_;
    std::vector<std::vector<int>> crossings_; ///< with each neighbour
};

} // namespace qm
