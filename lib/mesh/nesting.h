/// \file Closed parts of a mesh inside one another: solids and their cavities.
#pragma once

#include "mesh/quad_mesh.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace qm {

/// What a closed part of a mesh is among others.
struct Nesting {
    /// Whether its faces must be reversed to look out of the solid: because they look inwards, or, of a
    /// cavity, because those around it do.
    bool inward = false;
    /// The part around it, if this one is a cavity: the smallest around it is no cavity, and looks the other
    /// way.
    std::optional<std::size_t> cavityOf;
};

/// The faces of every component; empty in the place of one that has a boundary, or no faces.
[[nodiscard]] std::vector<std::vector<FaceId>> closedComponents(const QuadMesh& mesh);

/// Parts should not cross: one lies where its first corner does. Takes time n log n in the faces, and
/// compares the boxes of all pairs of parts.
/// \param parts  the faces of every part, without a boundary; empty in the place of a part that is not closed
/// \return by part
[[nodiscard]] std::vector<Nesting> nestingOf(const QuadMesh& mesh,
                                             const std::vector<std::vector<FaceId>>& parts);

} // namespace qm
