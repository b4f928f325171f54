/// \file Values of a few ids out of many.
#pragma once

#include <unordered_map>

namespace qm {

/// A value for every id, of which few have been given one and all others have `Value{}`; time and memory are
/// linear in those few.
template <class Key, class Value> class SparseIdVector {
public:
    [[nodiscard]] Value operator[](Key id) const {
        const auto known = values_.find(id);
        return known == values_.end() ? Value{} : known->second;
    }
    /// The value of an id, to be changed; it stays where it is while other ids are given theirs.
    [[nodiscard]] Value& at(Key id) { return values_[id]; }

private:
    std::unordered_map<Key, Value> values_;
};

} // namespace qm
