/// \file Finds the quads over which a lattice folds.
#pragma once

#include "bspline/reference/lattice/bilinear_quad.h"
#include "bspline/reference/lattice/lagrange.h"
#include "bspline/reference/lattice/mesh_lattice.h"

#include <vector>

namespace qm {

/// Smallest areas over a part of a quad, as shares of the part's own: with less, it is easily turned over.
struct FoldLimits {
    double minArea = 0; ///< of a square of the lattice
    /// Of what the derivatives span at a point of the lattice. The part is as much smaller as derivatives are
    /// shorter than the quad's, down to `minSpeed`.
    double minAreaAtPoint = 0;
    double minSpeed = 1;
};

/// Compares a lattice's surface with the quads between its corners.
class FoldTest {
public:
    /// \param lattice  must stay where it is; it may change
    FoldTest(const MeshLattice& lattice, const FoldLimits& limits);

    /// Some square of the lattice is turned over against the quad's part below it, or nearly so, or has
    /// hardly any area left; or the surface does so at one of the lattice's points.
    [[nodiscard]] bool foldsOver(FaceId face) const;

    /// The quad between the corners of a face.
    [[nodiscard]] BilinearQuad quad(FaceId face) const;

private:
    [[nodiscard]] bool foldsInSquares(FaceId face, const BilinearQuad& quad) const;
    [[nodiscard]] bool foldsAtPoints(FaceId face, const BilinearQuad& quad) const;

    const MeshLattice& lattice_;
    FoldLimits limits_;
    std::vector<LagrangeWeights> weights_; ///< at the lattice's parameters
};

} // namespace qm
