/// \file Arrays indexed by the ids of their elements, so that no number has to be cast.
#pragma once

#include "base/ids.h"

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace qm {

/// The ids from one up to but not including another, in order.
template <class Key> class IdRange {
public:
    class Iterator {
    public:
        using value_type = Key;
        using difference_type = std::ptrdiff_t;

        constexpr Iterator() = default;
        constexpr explicit Iterator(Key id) : id_(id) {}
        constexpr Key operator*() const { return id_; }
        constexpr Iterator& operator++() {
            id_ = id_ + 1;
            return *this;
        }
        constexpr Iterator operator++(int) { return Iterator(std::exchange(id_, id_ + 1)); }
        constexpr bool operator==(const Iterator&) const = default;

    private:
        Key id_;
    };

    constexpr IdRange(Key first, Key end) : first_(first), end_(end) {}
    [[nodiscard]] constexpr Iterator begin() const { return Iterator(first_); }
    [[nodiscard]] constexpr Iterator end() const { return Iterator(end_); }

private:
    Key first_;
    Key end_;
};

/// A vector that differs from std::vector only in the type of its index.
template <class Key, class Value> class IdVector : public std::vector<Value> {
    using Base = std::vector<Value>;

public:
    using Base::Base;
    explicit IdVector(Base values) : Base(std::move(values)) {}

    [[nodiscard]] decltype(auto) operator[](Key id) { return Base::operator[](id.idx()); }
    [[nodiscard]] decltype(auto) operator[](Key id) const { return Base::operator[](id.idx()); }

    [[nodiscard]] IdRange<Key> ids() const { return {Key(0), nextId()}; }
    /// The id that the next appended element will have.
    [[nodiscard]] Key nextId() const { return Key(this->size()); }
};

} // namespace qm
