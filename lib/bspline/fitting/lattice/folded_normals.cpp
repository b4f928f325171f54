#include "bspline/fitting/lattice/folded_normals.h"

#include "base/at.h"
#include "base/grid_neighbours.h"
#include "bspline/fitting/lattice/lattice_cells.h"
#include "bspline/reference/lattice/bilinear_quad.h"
#include "bspline/splines/evaluate.h"

#include <cstddef>

namespace qm {
namespace {

/// A surface counts as folded over a sound quad if the cosine of the angle between their normals is less: 80
/// degrees.
constexpr double uprightCosine = 0.17;

void replaceOverSoundQuads(const LatticeSource& source, FitLattice& lattice) {
    const auto& [columns, rows] = source.grid->size;
    for (int quad = 0; quad < columns * rows; ++quad) {
        if (!source.isSound[at(quad)]) continue;
        const int u = quad % columns;
        const int v = quad / columns;
        const KnotCell cell{{u * 1.0, v * 1.0}, {u + 1.0, v + 1.0}};
        const BilinearQuad flat = quadBelow(*source.grid, u, v);
        bool isFolded = false;
        forPoints(cell, lattice, [&](std::size_t k) {
            isFolded = isFolded || (lattice.normals[k] | flat.normal()) < uprightCosine;
        });
        if (!isFolded) continue;
        forPoints(cell, lattice, [&](std::size_t k) {
            const auto parameters = lattice.parametersAt(k);
            const SurfacePoint point = flat.evaluate(parameters[0] - u, parameters[1] - v);
            lattice.normals[k] = lattice.axes[k] = point.normal();
            lattice.jacobian[k] = (point.du % point.dv).norm();
            lattice.isGuess[k] = true;
        });
    }
}

} // namespace

void mendFoldedNormals(const LatticeSource& source, FitLattice& lattice) {
    replaceOverSoundQuads(source, lattice);
    const std::vector<Point> all = lattice.normals;
    forGridNeighbours(lattice.columns(), all.size(), [&](std::size_t a, std::size_t b) {
        if ((all[a] | all[b]) > 0) return;
        lattice.normals[a] = lattice.normals[b] = Point(0, 0, 0);
        lattice.jacobian[a] = lattice.jacobian[b] = 0;
    });
}

} // namespace qm
