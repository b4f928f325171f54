/// \file The points of the reference that a patch is fitted to, and how an offset from them counts.
#pragma once

#include "bspline/fitting/patch_form.h"
#include "bspline/network/smooth_network.h"
#include "bspline/reference/reference_grid.h"
#include "bspline/splines/surfaces.h"
#include "layout/layout.h"

#include <cstddef>
#include <vector>

namespace qm {

/// How a surface may slide over the reference without being farther from it.
enum class Freedom : char {
    surface, ///< in the tangent plane
    crease,  ///< along a crease or the mesh boundary
    corner   ///< not at all
};

struct FitLattice {
    PatchTargets targets; ///< at the lattice of the reference
    int steps = 2;        ///< of the lattice, a mesh edge
    std::vector<Freedom> freedom;
    std::vector<Point> axes;      ///< unit: the reference's normal; at a crease the direction of the curve
    std::vector<double> jacobian; ///< length of the cross product of the reference's derivatives by u and v

    [[nodiscard]] std::size_t columns() const { return targets.parameters[0].size(); }
    [[nodiscard]] std::size_t rows() const { return targets.parameters[1].size(); }
};

/// Of every segment. \param reference  of every segment
[[nodiscard]] std::vector<FitLattice> fitLattices(const QuadMesh& mesh, const Layout& layout,
                                                  const SmoothNetwork& network,
                                                  const std::vector<ReferenceGrid>& reference);

/// The distance from the reference that an offset from one of its lattice points makes.
[[nodiscard]] double distance(const FitLattice& lattice, std::size_t point, const Point& offset);

/// What is wrong with a patch at every lattice point, such that 1 is just allowed: its distance from the
/// reference over the tolerance; where it is folded, at least 2.
[[nodiscard]] std::vector<double> errors(const FitLattice& lattice, const Patch& patch, double tolerance);

} // namespace qm
