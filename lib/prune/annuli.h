/// \file The places where annuli may lie, so that a program can count them (docs/METHOD.md#pruning-program).
///
/// An annulus is a stack of closed strips of quads that no border crosses or separates. So the number of
/// annuli is the number of strips that no border crosses, less the number of places where two of these lie
/// side by side without a border between them. Strips that no arc ever separates make up one band.
#pragma once

#include "base/ids.h"
#include "mesh/quad_mesh.h"

#include <array>
#include <vector>

namespace qm {

/// The bands and their joints; bands are numbered from 0.
struct AnnulusBands {
    /// For every band, the arcs that cross it, ascending. If all of them are out, the band lies in an
    /// annulus.
    std::vector<std::vector<ArcId>> across;
    /// A closed line between two bands, or with the same band on both sides. If its arcs are out and no arc
    /// crosses the bands, both bands lie in the same annulus, or the single band is a torus.
    struct Joint {
        std::array<std::size_t, 2> bands;
        std::vector<ArcId> arcs; ///< on the line, ascending
    };
    std::vector<Joint> joints;
};

/// \param arcOf  the arc on every edge; none for edges without an arc
[[nodiscard]] AnnulusBands annulusBands(const QuadMesh& mesh, const std::vector<ArcId>& arcOf);

} // namespace qm
