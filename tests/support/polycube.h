/// \file Small quad meshes made of squares, for tests without files.
#pragma once

#include "check/mesh/neighbourhoods.h"

#include <array>
#include <vector>

namespace qm::test {

using Cells = std::vector<std::array<int, 3>>;

/// The surface of a set of unit cubes, with every square divided into n x n quads. If cubes touch only in an
/// edge or a corner, it is no manifold.
[[nodiscard]] check::CheckedMesh polycube(const Cells& cells, int n = 1);

/// The cells from (0, 0, 0) up to but not including (x, y, z).
[[nodiscard]] Cells box(int x, int y, int z);

/// A slab of 3 x 3 cubes with another one on the middle of its top. Its base complex has four ordinary
/// junctions.
[[nodiscard]] Cells bump();

/// Squares of the plane, possibly with holes; the mesh has a boundary.
/// \param rows  'x' stands for a square, anything else for none
[[nodiscard]] check::CheckedMesh plane(const std::vector<const char*>& rows);

/// A torus of a x b quads.
[[nodiscard]] check::CheckedMesh torus(int a, int b);

/// A tube of a quads around and b quads along, with two boundary loops.
[[nodiscard]] check::CheckedMesh tube(int a, int b);

/// Abstract squares, each divided into n x n quads, whose sides are glued in pairs. This makes every oriented
/// surface possible, including lines that cross themselves. The points have no meaning.
/// \param pairs  of sides, numbered 4 * square + side; each side is in one pair at most, and on the boundary
/// otherwise
[[nodiscard]] check::CheckedMesh glued(int squares, const std::vector<std::array<int, 2>>& pairs, int n);

/// Several meshes as one, their vertices and faces one after the other.
[[nodiscard]] check::CheckedMesh together(const std::vector<check::CheckedMesh>& parts);

} // namespace qm::test
