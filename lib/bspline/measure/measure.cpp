#include "bspline/measure/measure.h"

#include "base/at.h"
#include "base/parallel.h"
#include "bspline/measure/border_measures.h"
#include "bspline/measure/certified_deviation.h"
#include "bspline/measure/folds.h"
#include "bspline/measure/shape_measures.h"
#include "bspline/measure/vertex_distances.h"
#include "bspline/reference/lattice/reference_grid.h"
#include "mesh/bounding_box.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace qm {
namespace {

constexpr int samplesPerEdge = 16; ///< of normals and gaps along borders

/// What is known of a patch, or of all, before it is summed up.
struct Parts {
    Samples fromReference;
    Samples fromFacets;
    Samples fromVertices;
    Samples angles;
    ShapeMeasures shape;

    void add(const Parts& other) {
        append(fromReference, other.fromReference);
        append(fromFacets, other.fromFacets);
        append(fromVertices, other.fromVertices);
        shape.add(other.shape);
    }
};

class Meter {
public:
    Meter(const MeasuredSurfaces& surfaces, unsigned jobs)
        : mesh_(surfaces.mesh), layout_(surfaces.layout), patches_(surfaces.patches),
          references_(surfaces.references), jobs_(jobs), diagonal_(boundingBox(mesh_).diagonal()),
          borders_(borderEdges(mesh_, layout_)), facets_(facetGrids(mesh_, layout_)),
          toReference_(layout_, patches_, references_, borders_, jobs),
          toFacets_(layout_, patches_, facets_, borders_, jobs), parts_(patches_.size()) {
        result_.ofPatch.resize(patches_.size());
    }

    void certify(double negligible) {
        const CertificationOptions certification{measureClosing, negligible};
        fromReference_ = certifiedDeviations(toReference_, certification, jobs_);
        fromFacets_ = certifiedDeviations(toFacets_, certification, jobs_);
    }

    void measurePatch(std::size_t k) {
        PatchMeasurement& patch = result_.ofPatch[k];
        Parts& parts = parts_[k];
        CertifiedDeviation& certified = fromReference_[k];
        patch.deviation.max = certified.upper;
        patch.lowerBound = certified.lower;
        patch.farthest = certified.place;
        patch.farthest.patch = k;
        parts.fromReference = std::move(certified.samples);

        CertifiedDeviation& fromFacets = fromFacets_[k];
        patch.deviation.maxFromFacets = fromFacets.upper;
        parts.fromFacets = std::move(fromFacets.samples);
        parts.shape = measureShape(toReference_, k);
        patch.folds = findFolds(patches_[k], references_[k]);
        patch.deviation.folds = patch.folds.size();
        const MeetingMeasures inner = measureInnerLines(patches_[k], samplesPerEdge);
        patch.deviation.largestGap = inner.gap;
        if (!inner.angles.empty())
            patch.deviation.largestInnerNormalAngle = *std::ranges::max_element(inner.angles);
    }

    void measureVertices() {
        std::vector<double> ofReference;
        ofReference.reserve(patches_.size());
        for (const PatchMeasurement& patch : result_.ofPatch)
            ofReference.push_back(patch.deviation.max);
        auto distances = vertexDistances(mesh_, layout_, toReference_, ofReference, jobs_);
        for (std::size_t k = 0; k < patches_.size(); ++k)
            parts_[k].fromVertices = std::move(distances[k]);
    }

    void measureBorders(const std::vector<bool>& isSmooth) {
        std::vector<MeetingMeasures> measures(borders_.size());
        parallelFor(borders_.size(), jobs_, [&](std::size_t k) {
            measures[k] = measureBorder(borders_[k], layout_, patches_, samplesPerEdge);
        });
        for (std::size_t k = 0; k < borders_.size(); ++k) {
            const std::size_t edge = at(mesh_.edge_handle(borders_[k].halfedge));
            Samples angles;
            if (isSmooth[edge])
                for (const double angle : measures[k].angles)
                    angles.push_back({angle});
            const auto addTo = [&](Deviation& deviation, Parts& parts) {
                deviation.largestGap = std::max(deviation.largestGap, measures[k].gap);
                append(parts.angles, angles);
            };
            addTo(result_.ofAll.deviation, all_);
            for (const BorderPlace& place : borders_[k].places)
                addTo(result_.ofPatch[place.patch].deviation, parts_[place.patch]);
        }
    }

    Measurement finish() {
        PatchMeasurement& all = result_.ofAll;
        for (std::size_t k = 0; k < patches_.size(); ++k) {
            PatchMeasurement& patch = result_.ofPatch[k];
            Deviation& sum = all.deviation;
            all_.add(parts_[k]);
            const auto raise = [](double& value, double by) { value = std::max(value, by); };
            raise(sum.max, patch.deviation.max);
            raise(sum.maxFromFacets, patch.deviation.maxFromFacets);
            raise(sum.largestGap, patch.deviation.largestGap);
            raise(sum.largestInnerNormalAngle, patch.deviation.largestInnerNormalAngle);
            sum.folds += patch.deviation.folds;
            if (patch.lowerBound > all.lowerBound) {
                all.lowerBound = patch.lowerBound;
                all.farthest = patch.farthest;
            }
            summarise(parts_[k], patch.deviation);
        }
        summarise(all_, all.deviation);
        return std::move(result_);
    }

private:
    void summarise(const Parts& parts, Deviation& deviation) const {
        deviation.rms = rootMeanSquare(parts.fromReference);
        deviation.percentile95 = percentile95(parts.fromReference);
        deviation.rmsFromFacets = rootMeanSquare(parts.fromFacets);
        deviation.maxFromVertices = largest(parts.fromVertices);
        deviation.rmsFromVertices = rootMeanSquare(parts.fromVertices);
        deviation.largestNormalAngle = largest(parts.angles);
        deviation.rmsNormalAngle = rootMeanSquare(parts.angles);
        deviation.percentile95NormalAngle = percentile95(parts.angles);
        deviation.largestNormalDeviation = parts.shape.largestNormalDeviation;
        deviation.rmsNormalDeviation = parts.shape.rmsNormalDeviation();
        deviation.bendingRatio = parts.shape.bendingRatio();
        if (!(diagonal_ > 0)) return;
        deviation.maxRelative = deviation.max / diagonal_;
        deviation.rmsRelative = deviation.rms / diagonal_;
        deviation.percentile95Relative = deviation.percentile95 / diagonal_;
        deviation.largestGapRelative = deviation.largestGap / diagonal_;
    }

    const QuadMesh& mesh_;
    const Layout& layout_;
    const std::vector<Patch>& patches_;
    const std::vector<ReferenceGrid>& references_;
    unsigned jobs_;
    double diagonal_;
    std::vector<BorderEdge> borders_;
    std::vector<ReferenceGrid> facets_;
    PairedSurfaces toReference_;
    PairedSurfaces toFacets_;
    std::vector<CertifiedDeviation> fromReference_; ///< by patch
    std::vector<CertifiedDeviation> fromFacets_;
    std::vector<Parts> parts_; ///< by patch
    Parts all_;
    Measurement result_;
};

} // namespace

Measurement measureSurfaces(const MeasuredSurfaces& surfaces, const std::vector<bool>& isSmooth,
                            double negligible, unsigned jobs) {
    Meter meter(surfaces, jobs);
    meter.certify(negligible);
    parallelFor(surfaces.patches.size(), jobs, [&](std::size_t k) { meter.measurePatch(k); });
    meter.measureVertices();
    meter.measureBorders(isSmooth);
    return meter.finish();
}

} // namespace qm
