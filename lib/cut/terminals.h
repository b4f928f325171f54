/// \file Choice of the terminals of a two-way cut (docs/METHOD.md#mesh-cut).
#pragma once

#include "cut/cut.h"
#include "cut/pieces.h"
#include "cut/surface_distances.h"

#include <array>
#include <vector>

namespace qm {

/// The source and the sink of a cut, which differ, and the vertices that must stay on either side.
struct TerminalPair {
    VertexId source;
    VertexId sink;
    /// The groups of the source and of the sink. If both are empty, every extraordinary vertex belongs to the
    /// nearer terminal.
    std::array<std::vector<VertexId>, 2> groups;
};

/// Irregular: p1 and p2 are the two extraordinary vertices farthest apart over the surface; all others form
/// groups by the nearer of the two; a terminal is the vertex nearest in space to the mean of its group. With
/// fewer than two extraordinary vertices, feature seeds are added to them. Farthest: the two vertices
/// farthest apart in space, within one per cent; neither has another vertex farther away. Box: for each axis,
/// the vertices nearest to the centres of two opposite walls of the bounding box.
/// \param vertices  of the sub-mesh, connected, ascending
/// \param sources   vertices among them
/// \return the pairs to try; none if the terminals coincide, or if there are not two vertices for groups
[[nodiscard]] std::vector<TerminalPair> chooseTerminals(const QuadMesh& mesh,
                                                        const std::vector<VertexId>& vertices,
                                                        const PieceSources& sources, Terminals kind,
                                                        SurfaceDistances& distances);

} // namespace qm
