/// \file Where annuli can come to lie, so that a program can count them (docs/METHOD.md#layout).
///
/// An annulus is a stack of closed strips of quads: no border crosses them, and none lies between two of
/// them. So annuli are counted by strips that no border crosses, less the places where two of these lie side
/// by side without a border. Strips that nothing ever divides make up one band.
#pragma once

#include "base/ids.h"
#include "mesh/quad_mesh.h"

#include <array>
#include <vector>

namespace qm {

/// Bands are numbered from 0.
struct AnnulusBands {
    /// Of every band: the arcs that cross it, ascending. While all of them are out it lies in one annulus.
    std::vector<std::vector<ArcId>> across;
    /// A closed line between two bands, or with the same band on both sides. While its arcs are out and no
    /// arc crosses the bands, both lie in the same annulus, or a single one is a torus.
    struct Joint {
        std::array<std::size_t, 2> bands;
        std::vector<ArcId> arcs; ///< ascending
    };
    std::vector<Joint> joints;
};

/// \param arcOf  the arc over every edge; invalid where there is none
[[nodiscard]] AnnulusBands annulusBands(const QuadMesh& mesh, const std::vector<ArcId>& arcOf);

} // namespace qm
