/// \file Real meshes whose cheapest graphs are known from elsewhere.
#pragma once

#include <cstddef>
#include <span>

namespace qm::bench {

struct KnownMinima {
    const char* mesh;
    std::size_t extraordinaryVertices;
    std::size_t ordinaryJunctions;
    const char* graphs;      ///< how many; "" if only we know
    double minimum;          ///< G_T, to a millionth
    double minimumTMesh;     ///< likewise of class tmesh
    double precision = 2e-6; ///< of the minimum of class tmesh, relative if it was proven so only
};

/// Smallest first.
[[nodiscard]] std::span<const KnownMinima> knownMinima();

/// Larger ones, of which no minimum was known.
[[nodiscard]] std::span<const char* const> hardMeshes();

} // namespace qm::bench
