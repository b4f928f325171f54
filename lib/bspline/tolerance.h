/// \file Patches with few control points within a tolerance of the mesh that share their borders exactly.
#pragma once

#include "bspline/chains.h"
#include "bspline/closeness.h"
#include "bspline/corner_directions.h"
#include "bspline/curve_fit.h"
#include "bspline/deviation.h"
#include "bspline/knot_sharing.h"
#include "bspline/line_derivatives.h"
#include "bspline/normal_field.h"
#include "bspline/spline_curve.h"
#include "bspline/surfaces.h"
#include "merge/layout.h"

#include <cstddef>
#include <vector>

namespace qm {

/// First the curves of all chains of border edges, through every vertex where borders meet; they take over
/// one another's knots, since a patch needs those of all its sides. Then every patch between its curves, with
/// the normals that both sides of a smooth border are to have. Distances are first told from tangent planes,
/// which takes the fewest control points but does not promise the tolerance; patches that turn out to miss it
/// are fitted closer until it is certain.
class ToleranceFit {
public:
    /// Fits everything. All that is passed must outlive the fit. \param tolerance  in the mesh's unit
    ToleranceFit(const QuadMesh& mesh, const Layout& layout, const std::vector<double>& dihedralAngles,
                 double rho, double tolerance, unsigned jobs);

    /// One for every segment, in their order.
    [[nodiscard]] const std::vector<Patch>& patches() const { return patches_; }

    /// Fits the patches that miss the tolerance anew, closer around the places where they do, with the curves
    /// there and the neighbours that share those. After a few calls every patch keeps the tolerance for
    /// certain. \param places  of every patch \return which patches were fitted
    std::vector<bool> tighten(const std::vector<std::vector<DeviatingPlace>>& places);

private:
    [[nodiscard]] bool touches(std::size_t patch, const std::vector<bool>& chains) const;
    [[nodiscard]] CurveFitInput curveInput(std::size_t chain) const;
    void fitCurves(const std::vector<bool>& which);
    void shareKnots(const std::vector<bool>& which);
    void lowerDegrees(const std::vector<bool>& which);
    void fitPatches(const std::vector<bool>& which);
    void fitOne(std::size_t patch);

    const QuadMesh& mesh_;
    const Layout& layout_;
    double tolerance_;
    unsigned jobs_;
    Chains chains_;
    LineDerivatives lines_;
    NormalField field_;
    CornerDirections corners_;
    KnotSharing sharing_;
    std::vector<int> valences_;
    double exact_;                     ///< how near is at a vertex
    std::vector<Closeness> closeness_; ///< by vertex
    int calls_ = 0;
    std::vector<SplineCurve> curves_;
    std::vector<Patch> patches_;
};

} // namespace qm
