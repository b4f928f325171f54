/// \file The largest distances of patches from their reference, measured time and again while a fit changes
/// them.
#pragma once

#include "bspline/network/borders.h"
#include "bspline/network/stretches.h"
#include "bspline/reference/lattice/reference_grid.h"
#include "bspline/splines/surfaces.h"
#include "layout/layout.h"

#include <vector>

namespace qm {

class MaxDeviations {
public:
    /// \param layout, references  must outlive it; references are by patch
    /// \param limit  above it bounds are close, below they need not be
    MaxDeviations(const QuadMesh& mesh, const Layout& layout, const std::vector<ReferenceGrid>& references,
                  double limit, unsigned jobs);

    /// By patch: an upper bound of its distance from its reference. Patches that are as they were the last
    /// time, with those within three of them, are not measured again.
    [[nodiscard]] std::vector<double> operator()(const std::vector<Patch>& patches);

private:
    /// The patches whose distances may not be what they were.
    [[nodiscard]] std::vector<bool> changed(const std::vector<Patch>& patches) const;

    const Layout& layout_;
    const std::vector<ReferenceGrid>& references_;
    double limit_;
    unsigned jobs_;
    std::vector<BorderEdge> borders_;
    std::vector<Stretch> stretches_;
    std::vector<Patch> measured_;   ///< the last time
    std::vector<double> distances_; ///< found then
};

} // namespace qm
