/// \file Real meshes whose cheapest graphs are known from other sources.
#pragma once

#include <cstddef>
#include <span>

namespace qm::bench {

struct KnownMinima {
    const char* mesh;
    std::size_t extraordinaryVertices;
    std::size_t ordinaryJunctions;
    const char* graphs;      ///< their number; "" if no other source gives it
    double minimum;          ///< G_T, to a millionth
    double minimumTMesh;     ///< likewise of class tmesh
    double precision = 2e-6; ///< of the minimum of class tmesh, relative if it was proven so only
};

/// The meshes, smallest first.
[[nodiscard]] std::span<const KnownMinima> knownMinima();

/// Larger meshes whose minima were not known.
[[nodiscard]] std::span<const char* const> hardMeshes();

} // namespace qm::bench
