/// \file The curves of all borders within a tolerance, and what the patches between them need of them.
#pragma once

#include "bspline/chains.h"
#include "bspline/closeness.h"
#include "bspline/corner_directions.h"
#include "bspline/curve_fit.h"
#include "bspline/knot_sharing.h"
#include "bspline/line_derivatives.h"
#include "bspline/normal_field.h"
#include "bspline/spline_curve.h"
#include "layout/layout.h"

#include <cstddef>
#include <vector>

namespace qm {

/// One curve for every chain of border edges, through every vertex where borders meet. Curves take over one
/// another's knots, since a patch needs those of all its sides.
class BorderCurves {
public:
    /// What is passed must outlive the curves. \param tolerance  in the mesh's unit \param tangency  the sine
    /// of the largest angle between the plane in which more than two curves should meet and their tangents
    /// there
    BorderCurves(const QuadMesh& mesh, const Layout& layout, const std::vector<double>& dihedralAngles,
                 double rho, double tolerance, double tangency, unsigned jobs);

    [[nodiscard]] const Chains& chains() const { return chains_; }
    /// Whether patches are to meet smoothly across a border edge.
    [[nodiscard]] bool isSmooth(HalfedgeId halfedge) const;

    /// Fits some chains anew. \param closeness  by vertex index
    void fit(const std::vector<bool>& which, const std::vector<Closeness>& closeness);

    /// Asks no more of the tangents around a patch than where no other curve shares their planes, from the
    /// next fit on: what pulls a curve into a plane may bend the patch beside it.
    void loosen(std::size_t patch);

    /// True if one of these chains is on a side of the patch.
    [[nodiscard]] bool touches(std::size_t patch, const std::vector<bool>& chains) const;

    /// Both in the side's direction; the normals at `normalParameters`, zero where the border is not smooth.
    [[nodiscard]] SplineCurve side(std::size_t patch, int side) const;
    [[nodiscard]] std::vector<Point> normals(std::size_t patch, int side) const;

private:
    [[nodiscard]] CurveFitInput input(std::size_t chain, const std::vector<Closeness>& closeness) const;
    void shareKnots(const std::vector<bool>& which, const std::vector<CurveFitInput>& inputs);
    void lowerDegrees(const std::vector<bool>& which, const std::vector<CurveFitInput>& inputs);

    const QuadMesh& mesh_;
    double tolerance_;
    unsigned jobs_;
    std::size_t patches_;
    Chains chains_;
    LineDerivatives lines_;
    NormalField field_;
    CornerDirections corners_;
    KnotSharing sharing_;
    std::vector<int> valences_;
    double exact_;                 ///< how near is at a vertex
    std::vector<double> tangency_; ///< by chain
    std::vector<SplineCurve> curves_;
};

} // namespace qm
