/// \file Values that a search gives one after the other, and takes back when it returns to an earlier state.
#pragma once

#include "base/id_vector.h"

#include <cstddef>
#include <vector>

namespace qm {

/// A value for every id, at first none. With two values, these are flags that are raised.
template <class Key, class Value> class ValuesWithUndo {
public:
    /// \param none  what stands for no value
    ValuesWithUndo(std::size_t size, Value none) : values_(size, none), none_(none) {}

    [[nodiscard]] std::size_t size() const { return values_.size(); }
    [[nodiscard]] Value operator[](Key id) const { return values_[id]; }

    /// Gives a value to an id that has none.
    /// \return false if it has one already, which stays
    bool give(Key id, Value value) {
        if (values_[id] != none_) return false;
        values_[id] = value;
        given_.push_back(id);
        return true;
    }

    /// The ids that have values, in the order in which they were given.
    [[nodiscard]] const std::vector<Key>& given() const { return given_; }
    /// Takes back all values but those given first.
    void undo(std::size_t kept) {
        for (; given_.size() > kept; given_.pop_back())
            values_[given_.back()] = none_;
    }

private:
    IdVector<Key, Value> values_;
    Value none_;
    std::vector<Key> given_;
};

} // namespace qm
