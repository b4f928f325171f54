/// \file Single measurements of a surface, and their summary.
#pragma once

#include "bspline/borders.h"
#include "bspline/evaluate.h"
#include "bspline/quad_grid.h"
#include "bspline/surfaces.h"
#include "layout/layout.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace qm {

struct DeviationSamples {
    std::vector<double> distances;
    std::vector<double> kinks; ///< degrees
    double gap = 0;
    double normalDeviation = 0;
};

/// \param diagonal  of the bounding box, to which lengths are related
[[nodiscard]] Deviation summary(const DeviationSamples& samples, double diagonal);

/// So many parameters for every edge, and one more.
[[nodiscard]] std::vector<double> latticeParameters(int edges, int steps);

/// Calls visit(u, v, on, of) at so many steps along every edge: with the surface there, and the point of the
/// quads that has the same parameters.
template <class Visitor>
void visitLattice(const Patch& patch, const QuadGrid& quads, int samplesPerEdge, const Visitor& visit) {
    const auto us = latticeParameters(quads.size()[0], samplesPerEdge);
    const auto vs = latticeParameters(quads.size()[1], samplesPerEdge);
    const auto points = evaluateLattice(patch, us, vs);
    std::size_t k = 0;
    for (const double v : vs)
        for (const double u : us)
            visit(u, v, points[k++], quads.at(u, v));
}

/// The angles between the normals of surface and quad at the quads' centres, row by row, in degrees.
[[nodiscard]] std::vector<double> normalDeviations(const Patch& patch, const QuadGrid& quads);

/// Where on every border edge gaps are measured. Kinks are measured between the edge's ends only: at a vertex
/// a patch may have more than one normal.
constexpr std::array<double, 6> borderSamples = {0, 0.05, 0.35, 0.65, 0.95, 1};
constexpr std::span<const double> kinkSamples = std::span(borderSamples).subspan(1, borderSamples.size() - 2);

/// Parameters u and v of one side's patch at a share of a border edge.
[[nodiscard]] std::array<double, 2> parametersAt(const BorderEdge& border, std::size_t side,
                                                 const Layout& layout, double along);

/// The surfaces on both sides of a border edge that has two, at a share of it.
[[nodiscard]] std::array<SurfacePoint, 2> meeting(const BorderEdge& border, const Layout& layout,
                                                  const std::vector<Patch>& patches, double along);

/// The angle between the surfaces' normals, degrees.
[[nodiscard]] double kink(const std::array<SurfacePoint, 2>& points);

} // namespace qm
