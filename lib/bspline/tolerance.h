/// \file Patches with few control points within a tolerance of the mesh that share their borders exactly.
#pragma once

#include "bspline/border_curves.h"
#include "bspline/closeness.h"
#include "bspline/deviation.h"
#include "bspline/patch_fit.h"
#include "bspline/surfaces.h"
#include "layout/layout.h"

#include <cstddef>
#include <vector>

namespace qm {

/// First the curves of all borders, then every patch between its curves, with the normals that both sides of
/// a smooth border are to have. Distances are first told from tangent planes, which takes the fewest control
/// points but does not promise the tolerance; patches that turn out to miss it are fitted closer until it is
/// certain.
class ToleranceFit {
public:
    /// Fits everything. All that is passed must outlive the fit. \param tolerance  in the mesh's unit
    /// \param tangency  of the curves, as for `BorderCurves`: less takes more control points \param
    /// mostPoints gives up, and is not complete, as soon as patches take more control points than this
    ToleranceFit(const QuadMesh& mesh, const Layout& layout, const std::vector<double>& dihedralAngles,
                 double rho, double tolerance, double tangency, std::size_t mostPoints, unsigned jobs);

    [[nodiscard]] bool isComplete() const { return complete_; }

    /// One for every segment, in their order.
    [[nodiscard]] const std::vector<Patch>& patches() const { return patches_; }

    /// Fits the patches that miss the tolerance anew, closer around the places where they do, with the curves
    /// there and the neighbours that share those. After a few calls every patch keeps the tolerance for
    /// certain. \param places  of every patch \return which patches were fitted
    std::vector<bool> tighten(const DeviatingPlaces& places);

    [[nodiscard]] const BorderCurves& curves() const { return curves_; }
    [[nodiscard]] double tolerance() const { return tolerance_; }

    /// All that a patch is fitted to, at the present closeness.
    [[nodiscard]] PatchFitInput input(std::size_t patch) const;
    /// Puts another patch between the same curves in a patch's place.
    void replace(std::size_t patch, Patch by);
    /// Asks for more closeness around places, from now on.
    void comeCloser(const DeviatingPlaces& places);

private:
    void fitPatches(const std::vector<bool>& which, std::size_t mostPoints);

    const QuadMesh& mesh_;
    const Layout& layout_;
    double tolerance_;
    unsigned jobs_;
    BorderCurves curves_;
    std::vector<Closeness> closeness_; ///< by vertex
    int calls_ = 0;                    ///< of `tighten`
    bool complete_ = true;
    std::vector<Patch> patches_;
};

} // namespace qm
