#include "bspline/deviation.h"

#include "base/parallel.h"
#include "bspline/bounding_box.h"
#include "bspline/deviation_samples.h"
#include "bspline/interpolate.h"
#include "bspline/patch_distance.h"

#include <algorithm>
#include <utility>

namespace qm {
namespace {

std::vector<double> distances(const Patch& patch, const QuadGrid& quads, const MeshDistance& mesh,
                              int samplesPerEdge, double negligible) {
    std::vector<double> result;
    visitLattice(
        patch, quads, samplesPerEdge, [&](double u, double v, const SurfacePoint& on, const Point& of) {
            const double bound = (on.position - of).norm();
            if (bound <= negligible)
                result.insert(result.end(), 2, bound);
            else
                result.insert(result.end(), {mesh(on.position, bound), distanceToPatch(patch, of, u, v, on)});
        });
    return result;
}

/// Gap and kinks along one edge of the layout.
DeviationSamples atBorder(const BorderEdge& border, const Layout& layout, const std::vector<Patch>& patches,
                          bool smooth) {
    DeviationSamples samples;
    if (border.places.size() != 2) return samples;
    for (const double along : borderSamples) {
        const auto points = meeting(border, layout, patches, along);
        samples.gap = std::max(samples.gap, (points[0].position - points[1].position).norm());
        if (smooth && along > 0 && along < 1) samples.kinks.push_back(kink(points));
    }
    return samples;
}

void add(const DeviationSamples& samples, DeviationSamples& all) {
    all.distances.insert(all.distances.end(), samples.distances.begin(), samples.distances.end());
    all.kinks.insert(all.kinks.end(), samples.kinks.begin(), samples.kinks.end());
    all.gap = std::max(all.gap, samples.gap);
    all.normalDeviation = std::max(all.normalDeviation, samples.normalDeviation);
}

} // namespace

DeviationMeter::DeviationMeter(const QuadMesh& mesh, const Layout& layout,
                               const std::vector<double>& dihedralAngles, const DeviationOptions& options)
    : mesh_(mesh), layout_(layout), dihedralAngles_(dihedralAngles), options_(options), distance_(mesh),
      diagonal_(boundingBoxDiagonal(mesh)), borders_(borderEdges(mesh, layout)) {}

QuadGrid DeviationMeter::quads(std::size_t patch) const {
    const Segment& segment = layout_.segments[patch];
    return {pointGrid(mesh_, segment), segment.size};
}

bool DeviationMeter::isSmooth(const BorderEdge& border) const {
    return dihedralAngles_[static_cast<std::size_t>(mesh_.edge_handle(border.halfedge).idx())] <=
           options_.rho;
}

MeasuredDeviation DeviationMeter::measure(const std::vector<Patch>& patches, const Control& control) const {
    std::vector<DeviationSamples> ofPatch(patches.size());
    parallelFor(patches.size(), control.jobs, [&](std::size_t k) {
        const QuadGrid grid = quads(k);
        ofPatch[k].distances =
            distances(patches[k], grid, distance_, options_.samplesPerEdge, 1e-14 * diagonal_);
        ofPatch[k].normalDeviation = std::ranges::max(normalDeviations(patches[k], grid));
    });
    std::vector<DeviationSamples> ofBorder(borders_.size());
    parallelFor(borders_.size(), control.jobs, [&](std::size_t k) {
        ofBorder[k] = atBorder(borders_[k], layout_, patches, isSmooth(borders_[k]));
    });

    DeviationSamples all; // a border counts once here, but for both its patches
    for (const DeviationSamples& samples : ofPatch)
        add(samples, all);
    for (std::size_t k = 0; k < borders_.size(); ++k) {
        add(ofBorder[k], all);
        for (const BorderPlace& place : borders_[k].places)
            add(ofBorder[k], ofPatch[place.patch]);
    }
    MeasuredDeviation result;
    result.ofAll = summary(all, diagonal_);
    for (const DeviationSamples& samples : ofPatch)
        result.ofPatch.push_back(summary(samples, diagonal_));
    return result;
}

} // namespace qm
