/// \file The recipes of all sample meshes, one source for each family of them.
#pragma once

#include "shape/quad_list.h"

#include <cstdint>

namespace qm {

// ---- ball.cpp: a cube, and the ball that it becomes.

/// \param n  quads along an edge
[[nodiscard]] QuadList cubeShape(int n);

/// A cube drawn onto the sphere of radius 1, in equal angles along its edges.
/// \param around  quads around the equator, even and at least 4; around the other axes there may be two fewer
[[nodiscard]] QuadList sphereShape(int around);

// ---- cylinder.cpp

/// Of radius 1 and height 3, with both caps. Each has a grid in its middle, whose corners are extraordinary.
/// \param around  quads around, even and at least 4
[[nodiscard]] QuadList cylinderShape(int around);

// ---- machine_parts.cpp: flat faces, sharp edges, drilled holes, fillets; n quads along each unit of length.

/// A block of 3 x 3 x 2 with a through hole whose rims are filleted. 16 extraordinary vertices, genus 1.
[[nodiscard]] QuadList blockShape(int n);

/// Two plates at a right angle, a fillet between them, a hole in each. Genus 2.
[[nodiscard]] QuadList bracketShape(int n);

/// A flat sheet with a round hole: a surface with boundary and four inner extraordinary vertices.
[[nodiscard]] QuadList plateShape(int n);

/// A thick plate with `holes` drilled holes in a row, which is its genus.
[[nodiscard]] QuadList drilledShape(int n, int holes);

// ---- rings.cpp: what grids make when opposite sides are joined.

/// An open tube of radius 1 and length 6: an annulus, with no extraordinary vertex.
/// \param around  quads around, at least 3
[[nodiscard]] QuadList tubeShape(int around);

/// A ring of radius 3 with a tube of radius 1 and no extraordinary vertex.
/// \param around  quads around the tube, at least 3
[[nodiscard]] QuadList torusShape(int around);

/// A ring whose lines wind around it like the threads of a screw, with a boss on its outside: the boss's
/// eight extraordinary vertices send out separatrices that wind around the ring many times.
/// \param n  quads around the tube, divided by 4
[[nodiscard]] QuadList helixShape(int n);

// ---- soft_solids.cpp: softened surfaces of voxel solids; n quads along each voxel's edge.

/// A slab with `holes` holes in a row, without any sharp edge.
[[nodiscard]] QuadList pretzelShape(int n, int holes);

/// A random solid of `voxels` voxels in one piece, softened a little. Its genus is random too.
[[nodiscard]] QuadList randomShape(int n, int voxels, std::uint64_t seed);

/// The same with some squares of its surface taken out: a manifold with boundary, maybe of several pieces.
[[nodiscard]] QuadList randomOpenShape(int n, int voxels, std::uint64_t seed);

} // namespace qm
