/// \file Mending what can be mended without guessing.
#pragma once

#include "mesh/soup.h"

namespace qm {

struct RepairReport {
    std::size_t weldedVertices = 0;  ///< vertices taken out because another lies at the same place
    std::size_t degenerateFaces = 0; ///< faces taken out because a vertex occurs twice in them
    std::size_t duplicateFaces = 0;  ///< faces taken out because another has the same vertices
    std::size_t flippedFaces = 0;    ///< faces whose orientation was reversed
    std::size_t splitVertices = 0;   ///< vertices where several fans of faces met

    [[nodiscard]] bool changed() const {
        return weldedVertices + degenerateFaces + duplicateFaces + flippedFaces + splitVertices > 0;
    }
};

/// Drops degenerate and duplicate faces, a quad and its reverse among them; welds vertices at the same place
/// along borders; collapses quads with two opposite corners at the same place; and orients every component
/// as most of its faces are (see `weld.h`, `orientation.h`). Where several fans of faces meet at a vertex,
/// each gets a vertex of its own (see `fans.h`). Vertices and faces keep their order, a face its first
/// vertex. Isolated vertices stay. Whether the result is a mesh is for `validateSoup` to say.
/// \param soup  quads with indices in range and finite coordinates
/// \throw Error  if the surface has one side only, or no face is left
RepairReport repairSoup(Soup& soup);

} // namespace qm
