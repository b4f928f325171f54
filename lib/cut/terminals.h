/// \file Where a two-way cut starts from (docs/METHOD.md#mesh-cut).
#pragma once

#include "cut/cut.h"
#include "cut/surface_distances.h"

#include <array>
#include <vector>

namespace qm {

/// Source and sink of a cut, which differ, and what is to stay together on either side.
struct TerminalPair {
    VertexId source;
    VertexId sink;
    /// The source's and the sink's group, unless both are empty: then every extraordinary vertex belongs to
    /// the nearer terminal.
    std::array<std::vector<VertexId>, 2> groups;
};

/// Irregular: p1 and p2 are the two extraordinary vertices farthest apart over the surface; the others form
/// groups by the nearer of the two; a terminal is the vertex nearest in space to the mean of its group. Where
/// there are fewer than two extraordinary vertices, feature seeds count as such. Farthest: the two vertices
/// farthest apart in space, to within one per cent, and neither has another vertex farther away. Box: the
/// vertices nearest to the centres of two opposite walls of the bounding box, for each axis.
/// \param vertices       of the sub-mesh, connected, ascending
/// \param extraordinary  vertices among them, ascending
/// \param seeds          vertices among them, ascending
/// \return the pairs to try; none if the terminals coincide, or there are no two vertices for groups
[[nodiscard]] std::vector<TerminalPair> chooseTerminals(const QuadMesh& mesh,
                                                        const std::vector<VertexId>& vertices,
                                                        const std::vector<VertexId>& extraordinary,
                                                        const std::vector<VertexId>& seeds, Terminals kind,
                                                        SurfaceDistances& distances);

} // namespace qm
