/// \file The quads of a layout as OBJ, PLY and glTF.
#pragma once

#include "export/colours.h"
#include "layout/layout.h"
#include "mesh/quad_mesh.h"

#include <string>
#include <vector>

namespace qm {

[[nodiscard]] std::string quadsAsObj(const QuadMesh& mesh, const Layout& layout);
[[nodiscard]] std::string quadsAsPly(const QuadMesh& mesh, const Layout& layout,
                                     const std::vector<Colour>& colours);
/// \throw Error  if coordinates exceed single precision
[[nodiscard]] std::string quadsAsGlb(const QuadMesh& mesh, const Layout& layout,
                                     const std::vector<Colour>& colours);

} // namespace qm
