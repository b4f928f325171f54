/// \file Repairing defects of a mesh that can be repaired without guessing.
#pragma once

#include "mesh/soup/soup.h"

namespace qm {

struct RepairReport {
    std::size_t weldedVertices = 0;  ///< vertices dropped because another lies at the same place
    std::size_t degenerateFaces = 0; ///< faces dropped because a vertex occurs twice in them
    std::size_t duplicateFaces = 0;  ///< faces dropped because another has the same vertices
    std::size_t flippedFaces = 0;    ///< faces whose orientation was reversed
    std::size_t splitVertices = 0;   ///< vertices where several fans of faces met

    [[nodiscard]] bool changed() const {
        return weldedVertices + degenerateFaces + duplicateFaces + flippedFaces + splitVertices > 0;
    }
};

/// Drops degenerate and duplicate faces, including a quad and its reverse; welds vertices at the same place
/// along borders; collapses quads with two opposite corners at the same place; orients every component like
/// the majority of its faces; and gives every fan of faces at a vertex its own vertex, which takes apart
/// solids that touch at a vertex or an edge (see `soup_repairs.h`).
/// Vertices and faces keep their order, and faces their first vertex. Isolated vertices stay. `validateSoup`
/// must check whether the result is a mesh.
/// \param soup  quads with indices in range and finite coordinates
/// \throw Error  if the surface is one-sided, or no face is left
RepairReport repairSoup(Soup& soup);

} // namespace qm
