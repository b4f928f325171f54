/// \file What earlier branchings tell about later ones: reliability branching
/// (docs/METHOD.md#achterberg-2005).
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace qm {

/// Mean growth of the bound per unit that a column is moved, up to 1 or down to 0.
class PseudoCosts {
public:
    explicit PseudoCosts(const std::vector<double>& costs) : up_(costs.size()), down_(costs.size()) {}

    void learn(int column, bool up, double distance, double growth) {
        Mean& mean = (up ? up_ : down_)[static_cast<std::size_t>(column)];
        const double rate = std::max(growth, 0.0) / std::max(distance, 1e-6);
        for (Mean* each : {&mean, &all_}) {
            each->sum += rate;
            ++each->count;
        }
    }

    /// How much is gained by branching on a column with this value.
    [[nodiscard]] double score(int column, double value) const {
        const auto index = static_cast<std::size_t>(column);
        return std::max(rate(up_[index]) * (1 - value), 1e-6) * std::max(rate(down_[index]) * value, 1e-6);
    }

    /// How many branchings it has learnt from, on the side with fewer.
    [[nodiscard]] int trust(int column) const {
        const auto index = static_cast<std::size_t>(column);
        return std::min(up_[index].count, down_[index].count);
    }

private:
    struct Mean {
        double sum = 0;
        int count = 0;
    };
    /// For a column that was never tried, the mean of all.
    [[nodiscard]] double rate(const Mean& mean) const {
        if (mean.count > 0) return mean.sum / mean.count;
        return all_.count > 0 ? all_.sum / all_.count : 1;
    }
    std::vector<Mean> up_;
    std::vector<Mean> down_;
    Mean all_;
};

} // namespace qm
