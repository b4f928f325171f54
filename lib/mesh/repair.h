/// \file Mending what can be mended without guessing.
#pragma once

#include "mesh/soup.h"

namespace qm {

struct RepairReport {
    std::size_t weldedVertices = 0;  ///< vertices taken out because another lies at the same place
    std::size_t degenerateFaces = 0; ///< faces taken out because a vertex occurs twice in them
    std::size_t duplicateFaces = 0;  ///< faces taken out because another has the same vertices
    std::size_t flippedFaces = 0;    ///< faces whose orientation was reversed

    [[nodiscard]] bool changed() const {
        return weldedVertices + degenerateFaces + duplicateFaces + flippedFaces > 0;
    }
};

/// Welds vertices closer than 1e-9 of the bounding box's diagonal, drops degenerate and duplicate faces, and
/// orients every component as most of its faces are. Vertices are renumbered when some are welded; their
/// order stays. \param soup  quads with indices in range and finite coordinates \throw Error  if the faces
/// cannot be oriented consistently: the surface has one side only
RepairReport repairSoup(Soup& soup);

} // namespace qm
