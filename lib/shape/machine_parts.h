/// \file Shapes like machine parts: flat faces, sharp edges, drilled holes, fillets.
#pragma once

#include "shape/quad_list.h"
#include "shape/true_surface.h"

namespace qm {

// n is the number of quads along each unit of length.

/// A block of 3 x 3 x 2 with a through hole whose rims are filleted. 16 extraordinary vertices, genus 1.
[[nodiscard]] QuadList blockShape(int n);
[[nodiscard]] TrueSurface blockSurface();

/// Two plates at a right angle, a fillet between them, a hole in each. Genus 2.
[[nodiscard]] QuadList bracketShape(int n);

/// A flat sheet with a round hole: a surface with boundary and four inner extraordinary vertices.
[[nodiscard]] QuadList plateShape(int n);
[[nodiscard]] TrueSurface plateSurface();

/// A thick plate with `holes` drilled holes in a row, which is its genus.
[[nodiscard]] QuadList drilledShape(int n, int holes);
[[nodiscard]] TrueSurface drilledSurface(int holes);

} // namespace qm
