/// \file Patches with few control points within a tolerance of the mesh that share their borders exactly.
#pragma once

#include "bspline/chains.h"
#include "bspline/line_derivatives.h"
#include "bspline/spline_curve.h"
#include "bspline/surfaces.h"
#include "merge/layout.h"

#include <cstddef>
#include <vector>

namespace qm {

/// First the curves of all chains of border edges, through every vertex where borders meet; then every patch
/// between its curves. Distances are first told from tangent planes, which takes the fewest control points
/// but does not promise the tolerance; patches that turn out to miss it are fitted closer until it is
/// certain.
class ToleranceFit {
public:
    /// Fits everything. All that is passed must outlive the fit. \param tolerance  in the mesh's unit
    ToleranceFit(const QuadMesh& mesh, const Layout& layout, const std::vector<double>& dihedralAngles,
                 double rho, double tolerance, unsigned jobs);

    /// One for every segment, in their order.
    [[nodiscard]] const std::vector<Patch>& patches() const { return patches_; }

    /// Fits the patches that miss the tolerance anew, with the curves about them and the neighbours that
    /// share those. After a few calls every patch keeps the tolerance for certain. \param missed  for every
    /// patch
    void tighten(const std::vector<bool>& missed);

private:
    [[nodiscard]] std::vector<std::size_t> chainLevels() const;
    [[nodiscard]] bool touches(std::size_t patch, const std::vector<bool>& chains) const;
    void fitCurves(const std::vector<bool>& which);
    void fitPatches(const std::vector<bool>& which);
    void fitOne(std::size_t patch);

    const QuadMesh& mesh_;
    const Layout& layout_;
    double tolerance_;
    unsigned jobs_;
    Chains chains_;
    LineDerivatives lines_;
    std::vector<int> valences_;
    double exact_;                    ///< how near is at a vertex
    std::vector<std::size_t> levels_; ///< of patches: how close they are fitted
    int calls_ = 0;
    std::vector<SplineCurve> curves_;
    std::vector<Patch> patches_;
};

} // namespace qm
