/// \file The quads of a layout as OBJ, PLY and glTF (quads.cpp, glb.cpp), and their colours (colours.cpp).
#pragma once

#include "bspline/splines/surfaces.h"
#include "export/files/export_options.h"
#include "layout/layout.h"
#include "mesh/quad_mesh.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace qm {

using Colour = std::array<std::uint8_t, 3>; ///< red, green, blue (sRGB)

/// The colours of all segments.
/// \param surfaces  needed for ColourBy::deviation only
[[nodiscard]] std::vector<Colour> segmentColours(const Layout& layout, const Surfaces* surfaces, ColourBy by);

[[nodiscard]] std::string quadsAsObj(const QuadMesh& mesh, const Layout& layout);
[[nodiscard]] std::string quadsAsPly(const QuadMesh& mesh, const Layout& layout,
                                     const std::vector<Colour>& colours);
/// \throw Error  if coordinates exceed single precision
[[nodiscard]] std::string quadsAsGlb(const QuadMesh& mesh, const Layout& layout,
                                     const std::vector<Colour>& colours);

} // namespace qm
