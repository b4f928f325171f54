/// \file When windows were searched last, whichever chain they began with (docs/METHOD.md#windows).
#pragma once

#include "enumerate/state/problem.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

namespace qm {

/// Chains that cross each other often grow to the same window, which need not be searched once for each of
/// them.
class SearchedWindows {
public:
    /// The time of the last search of the window of these chains, to be read and set; at first 0.
    /// \param chains  ascending
    [[nodiscard]] std::size_t& timeOf(const std::vector<ChainId>& chains) {
        std::uint64_t key = chains.size();
        for (const ChainId chain : chains)
            key = (key ^ std::hash<ChainId>{}(chain)) * 0x9e3779b97f4a7c15ULL;
        return times_[key];
    }
    void clear() { times_.clear(); }

private:
    /// By a number for the chains, because large windows would take much memory. Should two windows have the
    /// same number, one of them may be passed over, which does no harm.
    std::unordered_map<std::uint64_t, std::size_t> times_;
};

} // namespace qm
