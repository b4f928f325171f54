/// \file Indices given to a few of many things.
#pragma once

#include <unordered_map>

namespace qm {

/// A map from numbers to indices that takes as much memory as has been put into it.
class SparseIndex {
public:
    void put(int number, int index) { indexOf_[number] = index; }
    /// -1 if none was put.
    [[nodiscard]] int operator[](int number) const {
        const auto found = indexOf_.find(number);
        return found == indexOf_.end() ? -1 : found->second;
    }

private:
    std::unordered_map<int, int> indexOf_;
};

} // namespace qm
