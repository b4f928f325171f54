#include "bspline/measure/scan_deviation.h"

#include "base/infinity.h"
#include "base/parallel.h"
#include "bspline/measure/gauss_points.h"
#include "bspline/measure/largest_first.h"
#include "bspline/splines/eigen_point.h"
#include "bspline/splines/patch_bezier.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace qm {
namespace {

/// A box of the patch, and its polynomial.
struct Box {
    BezierPiece piece;
    std::array<std::array<double, 2>, 2> range{}; ///< along u and along v
    double upper = 0;                             ///< 0 where the scan tells nothing
};

double farthestFrom(const Eigen::Vector3d& place, const BezierPiece& piece) {
    double square = 0;
    for (const Eigen::Vector3d& corner : piece.points)
        square = std::max(square, (corner - place).squaredNorm());
    return std::sqrt(square);
}

class ScanSearch {
public:
    ScanSearch(const Patch& patch, std::size_t number, const TriangleSurface& scan, double cutOff,
               const CertificationOptions& options)
        : patch_(patch), number_(number), scan_(scan), cutOff_(cutOff), options_(options) {}

    CertifiedDeviation run() {
        std::array<std::vector<double>, 2> breaks;
        for (std::size_t k = 0; k < 2; ++k) {
            const std::vector<double> knots = differentKnots(patch_.knots[k], patch_.degree[k]);
            breaks[k] = mergedBreaks(knots, gridLines(static_cast<int>(std::lround(knots.back()))));
        }
        const BezierPieces pieces =
            bezierPieces(patch_, breaks, std::max(patch_.degree[0], patch_.degree[1]));
        for (std::size_t j = 0; j + 1 < breaks[1].size(); ++j)
            for (std::size_t i = 0; i + 1 < breaks[0].size(); ++i) {
                Box box;
                pieces.get(i, j, box.piece);
                box.range = {{{breaks[0][i], breaks[0][i + 1]}, {breaks[1][j], breaks[1][j + 1]}}};
                addCell(std::move(box));
            }
        const std::size_t effort = options_.stepsFor(boxes_.size());
        result_.upper = boundLargestFirst(
            std::move(boxes_), effort,
            [&](double upper) { return upper <= options_.enoughFor(result_.lower); },
            [&](const Box& box, const auto& add) {
                for (const double u : {0.0, 0.5})
                    for (const double v : {0.0, 0.5})
                        add(quarter(box, u, v));
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

    void addCell(Box box) {
        box.upper = infinity;
        bool isCovered = false;
        for (const GaussPoint& at : gaussPoints(box.range)) {
            const Eigen::Vector3d place = evaluate(box.piece, at.u, at.v).position;
            const auto foot = witness(place);
            if (!foot) continue;
            isCovered = true;
            result_.samples.push_back({foot->distance, at.area});
            box.upper = std::min(box.upper, foot->distance + farthestFrom(place, box.piece));
            result_.raise(foot->distance, {number_, at.at});
        }
        if (isCovered) boxes_.push_back(std::move(box));
    }

    [[nodiscard]] Box quarter(const Box& box, double u, double v) {
        Box result;
        restrict(box.piece, {u, v}, {u + 0.5, v + 0.5}, result.piece);
        const std::array<double, 2> begin{u, v};
        std::array<double, 2> middle{};
        for (std::size_t k = 0; k < 2; ++k) {
            const auto& [from, to] = box.range[k];
            result.range[k] = {std::lerp(from, to, begin[k]), std::lerp(from, to, begin[k] + 0.5)};
            middle[k] = 0.5 * (result.range[k][0] + result.range[k][1]);
        }
        const auto foot = witness(evaluate(result.piece, 0.5, 0.5).position);
        if (!foot) return result;
        result_.raise(foot->distance, {number_, middle});
        for (const Eigen::Vector3d& corner : result.piece.points)
            result.upper = std::max(result.upper, scan_.distance(foot->face, point(corner)));
        result.upper = std::min(box.upper, result.upper);
        return result;
    }

    const Patch& patch_;
    std::size_t number_;
    const TriangleSurface& scan_;
    double cutOff_;
    CertificationOptions options_;
    std::vector<Box> boxes_;
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
