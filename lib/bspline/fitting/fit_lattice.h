/// \file The points of the reference that a patch is fitted to, and how far the patch may move beside them.
#pragma once

#include "bspline/fitting/patch_form.h"
#include "bspline/network/smooth_network.h"
#include "bspline/reference/reference_grid.h"
#include "layout/layout.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// How a surface may slide over the reference without being farther from it.
enum class Freedom : char {
    surface, ///< in the tangent plane
    crease,  ///< along a crease or the mesh boundary
    corner   ///< not at all
};

/// The reference above one segment, and where it has creases and corners.
struct LatticeSource {
    const ReferenceGrid* grid = nullptr;
    const std::vector<double>* weights = nullptr; ///< of the grid's points; all 1 if there are none
    std::array<std::vector<bool>, 4> isCrease{};  ///< by side, edge by edge counter-clockwise
    std::array<VertexRule::Kind, 4> corners{};    ///< what the reference does at the segment's
    std::vector<bool> isSound;                    ///< by quad: see `soundFaces`
};

/// What a fit makes of a lattice as it goes. All lists but the parameters have one entry a point: (us[i],
/// vs[j]) at j * columns() + i.
struct LatticeProgress {
    PatchTargets targets;         ///< where the patch is drawn to
    std::vector<double> emphasis; ///< factor of the weight, from 1 on
    std::vector<Point> slides;    ///< from the reference to where the patch was found to be
    std::vector<bool> isHeld;     ///< may not slide, because the patch was folded there
    std::vector<char> holds;      ///< how often it was, up to `maxHolds`
};

/// A lattice of parameters over one segment, with the reference there.
struct FitLattice : LatticeProgress {
    std::vector<Point> reference; ///< the reference's points
    std::vector<Freedom> freedom;
    std::vector<Point> normals;   ///< unit: the reference's; 0 where it has none or folds
    std::vector<Point> axes;      ///< the normal; at a crease the direction of the curve, unit
    std::vector<double> jacobian; ///< length of the cross product of the reference's derivatives by u and v
    std::vector<double> edge;     ///< length of the shorter one of these derivatives
    std::vector<bool> isGuess;    ///< the reference folds over a sound quad

    [[nodiscard]] std::size_t columns() const { return targets.parameters[0].size(); }
    [[nodiscard]] std::size_t rows() const { return targets.parameters[1].size(); }
    [[nodiscard]] std::array<double, 2> parametersAt(std::size_t point) const {
        return {targets.parameters[0][point % columns()], targets.parameters[1][point / columns()]};
    }
};

/// A point that was folded so often never slides again.
constexpr int maxHolds = 2;

/// Of every segment.
/// \param reference  of every segment; must outlive what is returned, as the weights must
/// \param weights  of the points of every grid; empty if all are 1
[[nodiscard]] std::vector<LatticeSource> latticeSources(const QuadMesh& mesh, const Layout& layout,
                                                        const SmoothNetwork& network,
                                                        const std::vector<ReferenceGrid>& reference,
                                                        const std::vector<std::vector<double>>& weights);

/// Parameters for a direction of a patch of so many quads: `steps` intervals a quad, and four at least
/// between any two knots.
[[nodiscard]] std::vector<double> latticeParameters(int size, int steps, const std::vector<double>& knots);

/// A lattice whose targets are the points of the reference.
[[nodiscard]] FitLattice makeLattice(const LatticeSource& source,
                                     const std::array<std::vector<double>, 2>& parameters);

/// One as it was.
[[nodiscard]] FitLattice restored(const LatticeSource& source, const LatticeProgress& progress);

/// The same with other parameters; slides and emphasis are taken over from those nearby.
[[nodiscard]] FitLattice resample(const LatticeSource& source, const FitLattice& before,
                                  const std::array<std::vector<double>, 2>& parameters);

/// Sets the weights of the targets from the emphasis.
void weighTargets(const LatticeSource& source, FitLattice& lattice);

} // namespace qm
