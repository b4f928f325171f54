/// \file Typed indices, so that an arc cannot be passed where a junction is expected.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace qm {

/// The index of an element in the array of its kind. Negative means "none".
template <class Tag> class Id {
public:
    constexpr Id() = default;
    constexpr explicit Id(std::int64_t index) : value_(static_cast<std::int32_t>(index)) {}
    constexpr explicit Id(std::size_t index) : value_(static_cast<std::int32_t>(index)) {}
    constexpr explicit Id(int index) : value_(index) {}

    [[nodiscard]] constexpr bool valid() const { return value_ >= 0; }
    [[nodiscard]] constexpr int value() const { return value_; }
    /// The index as a size; the id must be valid.
    [[nodiscard]] constexpr std::size_t idx() const { return static_cast<std::size_t>(value_); }

    constexpr auto operator<=>(const Id&) const = default; // NOLINT(modernize-use-nullptr): no pointer
    /// The id so many places later or earlier.
    [[nodiscard]] constexpr Id operator+(int places) const { return Id(value_ + places); }
    [[nodiscard]] constexpr Id operator-(int places) const { return Id(value_ - places); }

private:
    std::int32_t value_ = -1;
};

using SeparatrixId = Id<struct SeparatrixTag>;
using LineId = Id<struct LineTag>;
using ArcId = Id<struct ArcTag>;
using JunctionId = Id<struct JunctionTag>;
using SegmentId = Id<struct SegmentTag>;
using SubMeshId = Id<struct SubMeshTag>;

} // namespace qm

template <class Tag> struct std::hash<qm::Id<Tag>> {
    std::size_t operator()(qm::Id<Tag> id) const noexcept { return std::hash<int>{}(id.value()); }
};
