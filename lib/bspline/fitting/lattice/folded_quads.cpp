#include "bspline/fitting/lattice/folded_quads.h"

#include "base/at.h"
#include "base/positions.h"
#include "bspline/reference/lattice/bilinear_quad.h"
#include "bspline/splines/evaluate.h"

#include <algorithm>
#include <cstddef>

namespace qm {
namespace {

/// A surface counts as folded over a sound quad if the cosine of the angle between their normals is less: 80
/// degrees.
constexpr double uprightCosine = 0.17;

} // namespace

void replaceFoldedNormals(const LatticeSource& source, FitLattice& lattice) {
    const std::vector<double>& us = lattice.targets.parameters[0];
    const std::vector<double>& vs = lattice.targets.parameters[1];
    const auto first = [](const std::vector<double>& list, int at) {
        return positionIn(list, std::ranges::lower_bound(list, at));
    };
    const auto& [columns, rows] = source.grid->size;
    for (int quad = 0; quad < columns * rows; ++quad) {
        if (!source.isSound[at(quad)]) continue;
        const int u = quad % columns;
        const int v = quad / columns;
        const auto forPoints = [&](const auto& function) {
            for (std::size_t j = first(vs, v); j <= first(vs, v + 1); ++j)
                for (std::size_t i = first(us, u); i <= first(us, u + 1); ++i)
                    function(j * us.size() + i);
        };
        const auto corner = [&](int i, int j) {
            return lattice.reference[first(vs, v + j) * us.size() + first(us, u + i)];
        };
        const BilinearQuad flat({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
        bool isFolded = false;
        forPoints([&](std::size_t k) {
            isFolded = isFolded || (lattice.normals[k] | flat.normal()) < uprightCosine;
        });
        if (!isFolded) continue;
        forPoints([&](std::size_t k) {
            const auto parameters = lattice.parametersAt(k);
            const SurfacePoint point = flat.evaluate(parameters[0] - u, parameters[1] - v);
            lattice.normals[k] = lattice.axes[k] = unitNormal(point.du, point.dv).value_or(Point(0, 0, 0));
            lattice.jacobian[k] = (point.du % point.dv).norm();
            lattice.isGuess[k] = true;
        });
    }
}

} // namespace qm
