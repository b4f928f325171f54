/// \file Conversion of numbers, enumerators and ids to indices and sizes of arrays: `angles[at(edge)]`.
#pragma once

#include <concepts>
#include <cstddef>
#include <type_traits>

namespace qm {

/// \param index  not negative
template <class Index>
requires std::signed_integral<Index> || std::is_enum_v<Index>
[[nodiscard]] constexpr std::size_t at(Index index) {
    return static_cast<std::size_t>(index);
}

/// \param id  a valid id of a mesh element
template <class Handle>
requires requires(const Handle& id) {
    { id.idx() } -> std::same_as<int>;
}
[[nodiscard]] constexpr std::size_t at(const Handle& id) {
    return static_cast<std::size_t>(id.idx());
}

} // namespace qm
