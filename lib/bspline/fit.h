/// \file From a layout to its surfaces: the one call that does everything (docs/METHOD.md#smooth-fit).
#pragma once

#include "base/control.h"
#include "bspline/surfaces.h"
#include "layout/layout.h"

#include <vector>

namespace qm {

enum class Fit {
    interpolate, ///< through every vertex: (m + 3) x (n + 3) control points for m x n quads
    tolerance    ///< as few control points as the tolerance allows
};

/// A length as users give it: "0.1%" or "0.05".
struct Tolerance {
    double value = 0.1;
    bool percent = true; ///< of the diagonal of the mesh's bounding box; else in the mesh's unit

    [[nodiscard]] double length(double diagonal) const { return percent ? value / 100 * diagonal : value; }
    friend bool operator==(const Tolerance&, const Tolerance&) = default;
};

struct FitOptions {
    Fit fit = Fit::interpolate;
    /// Largest deviation from the mesh, between its vertices too; used by Fit::tolerance only.
    Tolerance tolerance;
    /// Across smooth borders, neighbours' normals should differ by at most so many degrees; used by
    /// Fit::tolerance only. Patches get control points for that as long as all together have no more than
    /// this share of interpolation's. What the tolerance itself takes, they have in any case.
    double maxKink = 1;
    double kinkBudget = 0.5;
    /// Neighbouring patches share their borders exactly, across T-joints too, and their tangents wherever the
    /// border is smooth. Fit::tolerance always does; Fit::interpolate, left without, is the paper's method:
    /// every patch by itself, with free ends.
    bool watertight = false;
    /// A border edge is smooth if its dihedral angle is at most this, in radians.
    double rho = 0.45;
    /// Deviation is measured at a lattice of this many steps along every mesh edge.
    int samplesPerEdge = 2;
};

/// One patch for every segment, and how far they are from the mesh. Linear in the mesh.
/// \param dihedralAngles  of every edge, in radians, by edge index
/// \throw Error  if an option is out of range
[[nodiscard]] Surfaces fitSurfaces(const QuadMesh& mesh, const Layout& layout,
                                   const std::vector<double>& dihedralAngles, const FitOptions& options,
                                   const Control& control = {});

} // namespace qm
