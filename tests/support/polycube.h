/// \file Small quad meshes made of squares, for tests that need no files.
#pragma once

#include "check/neighbourhoods.h"

#include <array>
#include <vector>

namespace qm::testing {

using Cells = std::vector<std::array<int, 3>>;

/// The surface of a set of unit cubes, each of its squares divided into n x n quads. Not a manifold if cubes
/// touch in an edge or corner only.
[[nodiscard]] check::CheckedMesh polycube(const Cells& cells, int n = 1);

/// A box of cells from (0, 0, 0) to (x, y, z), exclusive.
[[nodiscard]] Cells box(int x, int y, int z);

/// A slab of 3 x 3 cubes with one more on the middle of its top: its base complex has four ordinary
/// junctions.
[[nodiscard]] Cells bump();

/// The squares of a plane, with holes; the mesh has a boundary.
/// \param rows  'x' is a square, anything else none
[[nodiscard]] check::CheckedMesh plane(const std::vector<const char*>& rows);

/// a x b quads whose opposite borders are one: a torus.
[[nodiscard]] check::CheckedMesh torus(int a, int b);

/// a quads around and b along: a tube with two boundary loops.
[[nodiscard]] check::CheckedMesh tube(int a, int b);

/// Abstract squares, each divided into n x n quads, with sides glued in pairs, so that every oriented surface
/// can be had, with lines that cross themselves. The points have no meaning.
///
/// \param pairs  of sides, 4 * square + side; each side in one pair at most, those in none are boundary
[[nodiscard]] check::CheckedMesh glued(int squares, const std::vector<std::array<int, 2>>& pairs, int n);

} // namespace qm::testing
