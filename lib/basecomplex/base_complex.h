/// \file Separatrices and the base complex (docs/METHOD.md#base-complex).
#pragma once

#include "base/ids.h"
#include "mesh/quad_mesh.h"

#include <optional>
#include <span>
#include <vector>

namespace qm {

/// A feature seed: two particles leave the halfedge's first vertex, one along the halfedge, one the other way
/// on the same mesh line. That vertex must be interior and regular. No vertex bears two seeds.
struct Seed {
    HalfedgeId direction;
};

/// The directed path of one particle from its source, an extraordinary vertex or a seed, straight on until it
/// meets an extraordinary vertex, the boundary, or a seed of the line that it runs on.
struct Separatrix {
    std::vector<HalfedgeId> halfedges; ///< consecutive, at least one
    /// The same path backwards; none if it ends at a regular boundary vertex.
    std::optional<SeparatrixId> opposite;
    /// Halfedges up to the first vertex that it visits twice: no particle gets past its own track. All of
    /// them if it does not cross itself.
    std::size_t reach = 0;
    bool selfCrossing = false; ///< it visits some vertex twice between its ends
};

struct BaseComplex {
    std::vector<VertexId> extraordinaryVertices; ///< ascending
    std::vector<Seed> seeds;                     ///< as they were given
    /// Ordered by source vertex, then by the second vertex of the path.
    std::vector<Separatrix> separatrices;
    /// Regular vertices where two lines cross within the reach of their particles; a seed's line counts like
    /// any other (n_j).
    std::size_t ordinaryJunctions = 0;
};

/// Traces every separatrix, in time linear in the mesh: no edge lies on more than one line.
/// \param seeds  feature seeds (docs/METHOD.md#features); a seed on a separatrix splits it
/// \throw Error  if a seed's vertex is not interior and regular, or bears two seeds
[[nodiscard]] BaseComplex buildBaseComplex(const QuadMesh& mesh, std::span<const Seed> seeds = {});

} // namespace qm
