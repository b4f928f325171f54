/// \file Separatrices and the base complex (docs/METHOD.md#base-complex).
#pragma once

#include "base/id_vector.h"
#include "base/ids.h"
#include "mesh/quad_mesh.h"

#include <optional>
#include <span>
#include <vector>

namespace qm {

/// A feature seed: two particles leave the first vertex of the halfedge, one along it and one in the opposite
/// direction on the same mesh line. The vertex must be interior and regular, and may have one seed only.
struct Seed {
    HalfedgeId direction;
};

/// The directed path of a particle that is never stopped: from its source, an extraordinary vertex or a seed,
/// straight on to an extraordinary vertex, the boundary, or a seed on its own line.
struct Separatrix {
    std::vector<HalfedgeId> halfedges; ///< consecutive, at least one
    /// The same path in the other direction; none if the path ends at a regular boundary vertex.
    std::optional<SeparatrixId> opposite;
    /// Number of halfedges up to the first vertex that the path visits twice, because no particle gets past
    /// its own track; all halfedges if it does not cross itself.
    std::size_t reach = 0;
    bool selfCrossing = false; ///< whether it visits a vertex twice between its ends
};

struct BaseComplex {
    std::vector<VertexId> extraordinaryVertices; ///< ascending
    std::vector<Seed> seeds;                     ///< as given
    /// Ordered by source vertex, then by the second vertex of the path.
    IdVector<SeparatrixId, Separatrix> separatrices;
    /// n_j: the number of regular vertices where two lines cross within the reach of their particles. The
    /// line of a seed counts like any other.
    std::size_t ordinaryJunctions = 0;
};

/// Traces every separatrix, in time linear in the mesh: no edge lies on more than one line.
/// \param seeds  feature seeds (docs/METHOD.md#features); a seed on a separatrix splits it
/// \throw Error  if a seed's vertex is not interior and regular, or has two seeds
[[nodiscard]] BaseComplex buildBaseComplex(const QuadMesh& mesh, std::span<const Seed> seeds = {});

/// Of every edge, whether a separatrix runs over it.
[[nodiscard]] std::vector<bool> edgesOnLines(const QuadMesh& mesh, const BaseComplex& complex);

} // namespace qm
