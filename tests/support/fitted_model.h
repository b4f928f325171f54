/// \file Small meshes with layouts and surfaces for what is done with surfaces.
#pragma once

#include "bspline/fit.h"
#include "support/grid_layout.h"

#include <array>
#include <vector>

namespace qm::test {

struct FittedModel {
    QuadMesh mesh;
    Layout layout;
    Surfaces surfaces;
};

/// A grid fitted by rectangles.
[[nodiscard]] FittedModel fitted(const Grid& grid, const std::vector<Rectangle>& rectangles,
                                 const FitOptions& options);

/// Options of a fit that has the vertices exactly, and gaps.
[[nodiscard]] FitOptions interpolating();

/// A wavy sheet, 10 x 8 quads, and three rectangles on it that make a T-joint.
[[nodiscard]] Grid sheet();
[[nodiscard]] std::vector<Rectangle> tJoint();

/// A torus of 16 x 12 quads as one patch whose sides meet, or as several; closed either way.
[[nodiscard]] FittedModel torus(const std::vector<std::array<int, 4>>& rectangles);

/// A grid of which vertices at the same place are the same, as one patch.
/// \param turned  as in Rectangle
[[nodiscard]] FittedModel glued(const Grid& grid, int turned);

/// A strip that goes round in a loop until it passes its own beginning: like the letter rho.
[[nodiscard]] Grid loop();

/// A strip that winds round a cylinder, side by side.
[[nodiscard]] Grid helix();

/// A sheet whose side 0 is folded: its two ends are one line, its middle the rim of a hole.
[[nodiscard]] Grid pocket();

} // namespace qm::test
