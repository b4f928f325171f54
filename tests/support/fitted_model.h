/// \file Small meshes with layouts and surfaces, for tests of code that uses surfaces.
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

/// A grid whose segments are rectangles, with fitted surfaces.
[[nodiscard]] FittedModel fitted(const Grid& grid, const std::vector<Rectangle>& rectangles,
                                 const FitOptions& options);

/// Options of a fit that interpolates the vertices, and leaves gaps.
[[nodiscard]] FitOptions interpolating();

/// A wavy sheet of 10 x 8 quads, and three rectangles on it with a T-joint.
[[nodiscard]] Grid sheet();
[[nodiscard]] std::vector<Rectangle> tJoint();

/// A closed torus of 16 x 12 quads with one patch, whose sides meet, or with several.
[[nodiscard]] FittedModel torus(const std::vector<std::array<int, 4>>& rectangles);

/// A grid in which vertices at the same place are identified, as one patch.
/// \param turned  as in Rectangle
[[nodiscard]] FittedModel glued(const Grid& grid, int turned);

/// A strip that forms a loop and then continues along its own beginning, like the letter rho.
[[nodiscard]] Grid loop();

/// A strip that winds round a cylinder and joins itself side by side.
[[nodiscard]] Grid helix();

/// A sheet whose side 0 is folded: both ends of the side are one line, and its middle is the rim of a hole.
[[nodiscard]] Grid pocket();

/// One patch on a sheet, with knots at a grid line that allow a sharp bend there.
enum class Bend { sharp, none };
[[nodiscard]] FittedModel bentSheet(Bend bend);

/// Half a cylinder and half of the ring that closes it above, a patch each.
[[nodiscard]] FittedModel cup();

} // namespace qm::test
