/// \file Closed meshes inside one another: solids and their cavities.
#pragma once

#include "mesh/quad_mesh.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace qm {

/// Triangles without a boundary; empty in the place of a mesh that is not closed.
using ClosedMesh = std::vector<std::array<Point, 3>>;

/// Adds two triangles for a quad.
void addQuad(const QuadMesh& mesh, FaceId face, ClosedMesh& triangles);

/// What a closed mesh is among others.
struct Nesting {
    /// Whether its faces must be reversed to look out of the solid: because they look inwards, or, of a
    /// cavity, because those around it do.
    bool inward = false;
    /// The mesh around it, if this one is a cavity: the smallest around it is no cavity, and looks the other
    /// way.
    std::optional<std::size_t> cavityOf;
};

/// By mesh. Meshes should not cross: one lies where its first corner does. Takes time n log n in the
/// triangles, and compares the boxes of all pairs of meshes.
[[nodiscard]] std::vector<Nesting> nestingOf(const std::vector<ClosedMesh>& meshes);

} // namespace qm
