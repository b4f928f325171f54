/// \file The Catmull-Clark limit surface through the vertices of a mesh, by plain uniform subdivision. It
/// shares only the definition with the library's own.
#pragma once

#include "check/document/checked_document.h"
#include "check/mesh/neighbourhoods.h"

#include <array>
#include <cstddef>
#include <vector>

namespace measure {

using Place = std::array<double, 3>;

constexpr int levels = 3;
constexpr int perQuad = 1 << levels; ///< lattice steps along an edge of the mesh

constexpr std::size_t latticeSize = std::size_t{perQuad + 1} * (perQuad + 1);

/// Limit points above every quad: `latticeSize` of them, row by row from the quad's first corner towards its
/// second.
using LimitLattices = std::vector<std::vector<Place>>;

/// \param sharp   by edge; the boundary of the mesh is always sharp
/// \param layout  its sides determine where a curve of sharp edges goes straight on
[[nodiscard]] LimitLattices limitThroughVertices(const qm::check::CheckedMesh& mesh,
                                                 const qm::check::Neighbourhoods& around,
                                                 const std::vector<char>& sharp,
                                                 const qm::check::LayoutPart& layout);

} // namespace measure
