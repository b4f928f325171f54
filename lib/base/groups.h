/// \file Values that are sorted by a key, group by group.
#pragma once

#include <algorithm>
#include <functional>
#include <span>

namespace qm {

/// Calls `visit` with every maximal span of neighbours that have one key.
/// \param key  of a value: a member, or a function of it
template <class Values, class Key, class Visit>
void forEachGroup(Values& values, const Key& key, const Visit& visit) {
    for (auto begin = values.begin(); begin != values.end();) {
        const auto isOther = [&](const auto& value) {
            return std::invoke(key, value) != std::invoke(key, *begin);
        };
        const auto end = std::find_if(begin, values.end(), isOther);
        visit(std::span(begin, end));
        begin = end;
    }
}

} // namespace qm
