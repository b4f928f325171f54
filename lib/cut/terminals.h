/// \file Where a two-way cut starts from (method 4; paper 4.2.1 and "Evaluation of various cuts").
#pragma once

#include "cut/cut.h"
#include "cut/geodesics.h"

namespace qm {

/// Source and sink of a cut, and to which of them the particles' sources are said to belong.
struct TerminalPair {
    VertexId source;
    VertexId sink;
    VertexId groupSource; ///< sources nearer to this vertex than to groupSink are of the source's group
    VertexId groupSink;
};

/// Irregular: p1 and p2 are the sources of particles farthest apart over the surface, to within the accuracy
/// of the distances; the terminals are the vertices nearest to the centroids of the two groups. Farthest: the
/// two vertices with the largest distance in space among the extreme ones in many directions. Box: the
/// vertices nearest to the centres of two opposite walls of the bounding box, for each axis. \param vertices
/// of the sub-mesh, connected \param sources   vertices among them where particles start \return the pairs to
/// try; none if there are fewer than two sources or the terminals coincide
[[nodiscard]] std::vector<TerminalPair> chooseTerminals(const QuadMesh& mesh,
                                                        const std::vector<VertexId>& vertices,
                                                        const std::vector<VertexId>& sources, Terminals kind,
                                                        Geodesics& geodesics);

} // namespace qm
