/// \file The points of the reference that a patch is fitted to, and how far the patch may slide along it.
#pragma once

#include "bspline/fitting/energy/patch_form.h"
#include "bspline/network/smooth_network.h"
#include "bspline/reference/lattice/fit_target.h"
#include "layout/layout.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// The directions in which a surface may slide without moving away from the reference.
enum class Freedom : char {
    surface, ///< in the tangent plane
    crease,  ///< along a crease or the mesh boundary
    corner   ///< not at all
};

/// The reference above one segment, and the places of its creases and corners.
struct LatticeSource {
    const ReferenceGrid* grid = nullptr;
    const std::vector<double>* weights = nullptr; ///< of the grid's points; all 1 if null
    std::array<std::vector<bool>, 4> isCrease{};  ///< by side, edge by edge counter-clockwise
    /// The rules of the segment's corner vertices, or corner where a crease along a side ends on others.
    std::array<VertexRule::Kind, 4> corners{};
    std::vector<bool> isSound{}; ///< by quad: see `soundFaces`
    std::vector<bool> isStiff{}; ///< by quad: it is sound, and so are those around it
};

/// The part of a lattice that changes during a fit. All lists but the parameters have one entry per point:
/// (us[i], vs[j]) at j * columns() + i.
struct LatticeProgress {
    PatchTargets targets;         ///< the points that the patch is drawn to
    std::vector<double> emphasis; ///< factor of the weight, at least 1
    std::vector<Point> slides;    ///< from the reference's point to the target
    std::vector<bool> isHeld;     ///< the target may not slide, because the patch was folded there
    std::vector<char> holds;      ///< number of times that it was held, up to `maxHolds`
};

/// A lattice of parameters over one segment, with the reference at its points.
struct FitLattice : LatticeProgress {
    std::vector<Point> reference; ///< the reference's points
    std::vector<Freedom> freedom;
    std::vector<Point> normals;   ///< unit normals of the reference; 0 where it has none or folds
    std::vector<Point> axes;      ///< the normal, or at a crease the unit direction of the curve
    std::vector<double> jacobian; ///< length of the cross product of the reference's derivatives
    std::vector<double> edge;     ///< length of the shorter of these derivatives
    std::vector<bool> isGuess;    ///< the reference folds there although the quad is sound

    [[nodiscard]] std::size_t columns() const { return targets.parameters[0].size(); }
    [[nodiscard]] std::size_t rows() const { return targets.parameters[1].size(); }
    /// The number of point `k` on a line along u (0) or v (1).
    [[nodiscard]] std::size_t onLine(std::size_t direction, std::size_t line, std::size_t k) const {
        return direction == 0 ? line * columns() + k : k * columns() + line;
    }
    [[nodiscard]] std::array<double, 2> parametersAt(std::size_t point) const {
        return {targets.parameters[0][point % columns()], targets.parameters[1][point / columns()]};
    }
};

/// A target that was held this often never slides again.
constexpr int maxHolds = 2;

/// The sources of all segments.
/// \param reference  must outlive the result
[[nodiscard]] std::vector<LatticeSource> latticeSources(const QuadMesh& mesh, const Layout& layout,
                                                        const SmoothNetwork& network,
                                                        const FitTarget& reference, unsigned jobs);

/// Parameters along a direction of `size` quads: `steps` intervals per quad, and at least four between two
/// knots.
[[nodiscard]] std::vector<double> latticeParameters(int size, int steps, const std::vector<double>& knots);

/// A lattice whose targets are the points of the reference.
[[nodiscard]] FitLattice makeLattice(const LatticeSource& source,
                                     const std::array<std::vector<double>, 2>& parameters);

/// A lattice with an earlier state of its changing part.
[[nodiscard]] FitLattice restored(const LatticeSource& source, const LatticeProgress& progress);

/// The same lattice at other parameters; slides and emphasis are taken from the nearest points.
[[nodiscard]] FitLattice resample(const LatticeSource& source, const FitLattice& before,
                                  const std::array<std::vector<double>, 2>& parameters);

/// Sets the weights of the targets to those of the source times the emphasis.
void weighTargets(const LatticeSource& source, FitLattice& lattice);

} // namespace qm
