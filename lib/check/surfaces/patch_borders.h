/// \file Which patches meet at which edge of the mesh.
#pragma once

#include "check/document/checked_document.h"
#include "check/mesh/neighbourhoods.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm::check {

/// An edge of a segment's border: the parameters of its patch at both ends.
struct BorderPlace {
    std::size_t patch = 0;
    std::array<double, 2> begin{};
    std::array<double, 2> end{};
};

/// By edge: the places of the segments that it borders; two see it in opposite directions.
[[nodiscard]] std::vector<std::vector<BorderPlace>> patchBorders(const Neighbourhoods& around,
                                                                 const LayoutPart& layout);

} // namespace qm::check
