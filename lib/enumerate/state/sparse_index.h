/// \file A map from ids to ids for the case that few ids have a value.
#pragma once

#include "base/ids.h"

#include <unordered_map>

namespace qm {

/// A map from ids to ids whose memory is linear in the number of entries.
template <class Key, class Value> class SparseIndex {
public:
    void put(Key key, Value value) { valueOf_[key] = value; }
    /// The value of a key; none if the key has no entry.
    [[nodiscard]] Value operator[](Key key) const {
        const auto found = valueOf_.find(key);
        return found == valueOf_.end() ? Value() : found->second;
    }

private:
    std::unordered_map<Key, Value> valueOf_;
};

} // namespace qm
