/// \file Ids given to a few of many things.
#pragma once

#include "base/ids.h"

#include <unordered_map>

namespace qm {

/// A map from ids to ids that takes as much memory as has been put into it.
template <class Key, class Value> class SparseIndex {
public:
    void put(Key key, Value value) { valueOf_[key] = value; }
    /// None if none was put.
    [[nodiscard]] Value operator[](Key key) const {
        const auto found = valueOf_.find(key);
        return found == valueOf_.end() ? Value() : found->second;
    }

private:
    std::unordered_map<Key, Value> valueOf_;
};

} // namespace qm
