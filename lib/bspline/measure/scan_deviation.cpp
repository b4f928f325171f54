#include "bspline/measure/scan_deviation.h"

#include "base/infinity.h"
#include "base/parallel.h"
#include "bspline/measure/gauss_points.h"
#include "bspline/measure/largest_first.h"
#include "bspline/splines/eigen_point.h"
#include "bspline/splines/patch_bezier.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace qm {
namespace {

struct BoundedPiece : PatchPiece {
    double upper = 0; ///< 0 where the scan tells nothing
};

class ScanSearch {
public:
    ScanSearch(const Patch& patch, std::size_t number, const TriangleSurface& scan, double cutOff,
               const CertificationOptions& options)
        : patch_(patch), number_(number), scan_(scan), cutOff_(cutOff), options_(options) {}

    CertifiedDeviation run() {
        const int degree = std::max(patch_.degree[0], patch_.degree[1]);
        forEachPiece(bezierPieces(patch_, knotsAndGridLines(patch_), {degree, degree}),
                     [&](PatchPiece part) { add(std::move(part)); });
        const std::size_t effort = options_.stepsFor(pieces_.size());
        result_.upper = boundLargestFirst(
            std::move(pieces_), effort,
            [&](double upper) { return upper <= options_.enoughFor(result_.lower); },
            [&](const BoundedPiece& whole, const auto& addPart) {
                for (PatchPiece& quarter : quarters(whole))
                    addPart(bounded(std::move(quarter), whole.upper));
            });
        return std::move(result_);
    }

private:
    /// What the scan tells about a place, if anything.
    [[nodiscard]] std::optional<TriangleSurface::Nearest> witness(const Eigen::Vector3d& place) const {
        auto foot = scan_.nearest(point(place), cutOff_);
        if (foot && foot->onBoundary) foot.reset();
        return foot;
    }

    void add(PatchPiece part) {
        BoundedPiece result{std::move(part), infinity};
        bool isCovered = false;
        for (const GaussPoint& at : gaussPoints(result.box)) {
            const Eigen::Vector3d place = evaluate(result.piece, at.u, at.v).position;
            const auto foot = witness(place);
            if (!foot) continue;
            isCovered = true;
            result_.samples.push_back({foot->distance, at.area});
            result.upper = std::min(result.upper, foot->distance + farthestFrom(place, result.piece));
            result_.raise(foot->distance, {number_, at.at});
        }
        if (isCovered) pieces_.push_back(std::move(result));
    }

    /// \param upper  bound of a piece that this one is part of
    [[nodiscard]] BoundedPiece bounded(PatchPiece part, double upper) {
        BoundedPiece result{std::move(part)};
        const auto foot = witness(evaluate(result.piece, 0.5, 0.5).position);
        if (!foot) return result;
        result_.raise(foot->distance, {number_, middleOf(result.box)});
        for (const Eigen::Vector3d& corner : result.piece.points)
            result.upper = std::max(result.upper, scan_.distance(foot->face, point(corner)));
        result.upper = std::min(upper, result.upper);
        return result;
    }

    const Patch& patch_;
    std::size_t number_;
    const TriangleSurface& scan_;
    double cutOff_;
    CertificationOptions options_;
    std::vector<BoundedPiece> pieces_;
    CertifiedDeviation result_; ///< whose upper bound holds only where the scan tells something
};

} // namespace

ScanDeviations deviationFromScan(const std::vector<Patch>& patches, const TriangleSurface& scan,
                                 double cutOff, const CertificationOptions& options, unsigned jobs) {
    std::vector<CertifiedDeviation> ofPatch(patches.size());
    parallelFor(patches.size(), jobs,
                [&](std::size_t k) { ofPatch[k] = ScanSearch(patches[k], k, scan, cutOff, options).run(); });
    ScanDeviations result;
    Samples samples;
    for (const CertifiedDeviation& one : ofPatch) {
        if (one.lower > result.max) {
            result.max = one.lower;
            result.farthest = one.place;
        }
        append(samples, one.samples);
    }
    result.rms = rootMeanSquare(samples);
    result.percentile95 = percentile95(std::move(samples));
    return result;
}

} // namespace qm
