/// \file Finds the quads over which a lattice folds.
#pragma once

#include "bspline/reference/lattice/bilinear_quad.h"
#include "bspline/reference/lattice/lagrange.h"
#include "bspline/reference/lattice/mesh_lattice.h"

#include <vector>

namespace qm {

/// Compares a lattice's surface with the quads between its corners.
class LatticeFolds {
public:
    /// \param lattice  must stay where it is; it may change
    explicit LatticeFolds(const MeshLattice& lattice);

    /// Some square of the lattice is turned over against the quad's part below it, or nearly so, or has
    /// hardly any area left; or the surface does so at one of the lattice's points.
    [[nodiscard]] bool isAbove(FaceId face) const;

    /// The quad between the corners of a face.
    [[nodiscard]] BilinearQuad quad(FaceId face) const;

private:
    [[nodiscard]] bool isInSquares(FaceId face, const BilinearQuad& quad) const;
    [[nodiscard]] bool isAtPoints(FaceId face, const BilinearQuad& quad) const;

    const MeshLattice& lattice_;
    std::vector<LagrangeWeights> weights_; ///< at the lattice's parameters
};

} // namespace qm
