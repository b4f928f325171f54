/// \file Merges neighbouring faces in one plane, cylinder or cone into one face of any outline
/// (merge_faces.cpp), and edges that follow one another on one line, circle or ellipse (merge_edges.cpp).
#pragma once

#include "export/boundary/boundary.h"

#include <vector>

namespace qm {

enum class MergedSurface { plane, ruled };

/// Removes the edges between faces of one plane, or of one cylinder or cone, and the vertices that no edge
/// needs any more. A merged face may have holes; no vertex is on its outline twice, and it has a few hundred
/// edges at most. What would go all around a cylinder or cone becomes faces of half a turn at most, so that
/// none meets itself. A merged face takes the place of the first of its faces.
/// \param origins   merged likewise
/// \param boundary  its faces of such surfaces have no holes yet
/// \param mayMerge  by face
/// \return whether there were any
bool mergeFaces(Boundary& boundary, FaceOrigins& origins, MergedSurface kind,
                const std::vector<bool>& mayMerge);

/// Two edges between the same faces become one where nothing else ends at their common vertex, if their
/// curves are the same line, circle or ellipse, and that does not become a closed edge.
/// \return whether there were any
bool mergeEdges(Boundary& boundary);

} // namespace qm
