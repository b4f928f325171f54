/// \file The members of JSON objects.
#pragma once

#include <nlohmann/ordered_map.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace qm {

/// Keeps the order in which members were added. The library's map alone copies all its values, with all that
/// is in them, whenever it needs more room: its keys are constant, so a vector of them cannot move. This one
/// moves the values.
template <class Key, class Value, class Compare, class Allocator>
class Members : public nlohmann::ordered_map<Key, Value, Compare, Allocator> {
    using Map = nlohmann::ordered_map<Key, Value, Compare, Allocator>;

public:
    using Map::Map;

    template <class AnyKey> std::pair<typename Map::iterator, bool> emplace(AnyKey&& key, Value&& value) {
        makeRoom();
        return Map::emplace(std::forward<AnyKey>(key), std::move(value));
    }
    template <class AnyKey> Value& operator[](AnyKey&& key) {
        return emplace(std::forward<AnyKey>(key), Value{}).first->second;
    }
    /// Adds a member whose key is known to be new: does not search for it.
    void append(Key key, Value&& value) {
        makeRoom();
        Map::Container::emplace_back(std::move(key), std::move(value));
    }

private:
    void makeRoom() {
        if (this->size() < this->capacity()) return;
        Members larger;
        larger.reserve(std::max<std::size_t>(1, 2 * this->size()));
        for (auto& [key, value] : *this)
            larger.Map::Container::emplace_back(key, std::move(value));
        this->swap(larger);
    }
};

} // namespace qm
