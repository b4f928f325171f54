/// \file The queue of a front: vertices that have been reached, the nearest first.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <tuple>
#include <vector>

namespace qm {

/// A priority queue for distances that mostly grow. Far entries are only sorted into buckets ("steps"), and
/// only the nearest bucket is a heap. Entries are ordered by distance, and among equal distances by rank,
/// whatever the width of the buckets.
class BucketQueue {
public:
    struct Entry {
        double distance;
        int rank; ///< decides between equal distances
        int node;

        bool operator>(const Entry& other) const {
            return std::tie(distance, rank) > std::tie(other.distance, other.rank);
        }
    };

    /// \param step  the usual difference of distance between neighbouring vertices; not negative
    explicit BucketQueue(double step) : stepsPerLength_(step > 0 ? 1 / step : 0) {}

    /// \pre the distance is not negative; it may be below that of entries already taken
    void push(const Entry& entry) {
        const double steps = entry.distance * stepsPerLength_;
        const std::size_t step = steps < maxSteps ? static_cast<std::size_t>(steps) : maxSteps;
        if (step <= current_) {
            near_.push_back(entry);
            std::ranges::push_heap(near_, std::greater{});
            return;
        }
        if (step >= far_.size()) far_.resize(step + 1);
        far_[step].push_back(entry);
    }

    [[nodiscard]] bool empty() {
        while (near_.empty() && current_ + 1 < far_.size()) {
            near_.swap(far_[++current_]);
            std::ranges::make_heap(near_, std::greater{});
        }
        if (!near_.empty()) return false;
        current_ = 0;
        return true;
    }

    /// \pre `empty` has been called since the last change, and was false
    Entry pop() {
        std::ranges::pop_heap(near_, std::greater{});
        const Entry entry = near_.back();
        near_.pop_back();
        return entry;
    }

private:
    static constexpr std::size_t maxSteps = 1U << 16U; ///< all farther entries share one bucket

    double stepsPerLength_;
    std::size_t current_ = 0; ///< the bucket of the nearest entry
    std::vector<Entry> near_;
    std::vector<std::vector<Entry>> far_; ///< the buckets beyond
};

} // namespace qm
