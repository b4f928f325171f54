#include "bspline/measure/scan_deviation.h"

#include "base/parallel.h"
#include "bspline/splines/eigen_point.h"
#include "bspline/splines/patch_bezier.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace qm {
namespace {

/// A box of the patch, and its polynomial.
struct Box {
    BezierPiece piece;
    std::array<double, 2> from{};
    std::array<double, 2> to{};
    double upper = 0;
};

bool isNearer(const Box& a, const Box& b) {
    return a.upper < b.upper;
}

double farthestFrom(const Eigen::Vector3d& place, const BezierPiece& piece) {
    double square = 0;
    for (const Eigen::Vector3d& corner : piece.points)
        square = std::max(square, (corner - place).squaredNorm());
    return std::sqrt(square);
}

class ScanSearch {
public:
    ScanSearch(const Patch& patch, std::size_t number, const NearestOnScan& nearest, double cutOff,
               const CertificationOptions& options)
        : patch_(patch), number_(number), nearest_(nearest), cutOff_(cutOff), options_(options) {}

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
                box.from = {breaks[0][i], breaks[1][j]};
                box.to = {breaks[0][i + 1], breaks[1][j + 1]};
                addCell(std::move(box));
            }
        refine();
        return std::move(result_);
    }

private:
    [[nodiscard]] bool isWitness(const ScanPoint& foot) const {
        return !foot.onBoundary && foot.distance <= cutOff_;
    }

    void raise(double distance, const std::array<double, 2>& at) {
        if (distance <= result_.lower) return;
        result_.lower = distance;
        result_.place = {number_, at};
    }

    void addCell(Box box) {
        const double area = (box.to[0] - box.from[0]) * (box.to[1] - box.from[1]) / 4;
        box.upper = HUGE_VAL;
        bool isCovered = false;
        for (const double v : gaussNodes)
            for (const double u : gaussNodes) {
                const Eigen::Vector3d place = evaluate(box.piece, u, v).position;
                const ScanPoint foot = nearest_(point(place));
                if (!isWitness(foot)) continue;
                isCovered = true;
                result_.samples.emplace_back(foot.distance, area);
                box.upper = std::min(box.upper, foot.distance + farthestFrom(place, box.piece));
                raise(foot.distance,
                      {std::lerp(box.from[0], box.to[0], u), std::lerp(box.from[1], box.to[1], v)});
            }
        if (isCovered) boxes_.push_back(std::move(box));
    }

    [[nodiscard]] bool isClosed(double upper) const {
        return upper <= std::max(options_.negligible, (1 + options_.closing) * result_.lower);
    }

    void refine() {
        std::ranges::make_heap(boxes_, isNearer);
        std::size_t effort = 1000 + options_.effort * boxes_.size();
        while (!boxes_.empty() && !isClosed(boxes_.front().upper) && effort > 4) {
            std::ranges::pop_heap(boxes_, isNearer);
            const Box box = std::move(boxes_.back());
            boxes_.pop_back();
            for (const double u : {0.0, 0.5})
                for (const double v : {0.0, 0.5})
                    addQuarter(box, u, v);
            effort -= 4;
        }
    }

    void addQuarter(const Box& box, double u, double v) {
        Box quarter;
        restrict(box.piece, {u, v}, {u + 0.5, v + 0.5}, quarter.piece);
        const std::array<double, 2> begin{u, v};
        std::array<double, 2> middle{};
        for (std::size_t k = 0; k < 2; ++k) {
            quarter.from[k] = std::lerp(box.from[k], box.to[k], begin[k]);
            quarter.to[k] = std::lerp(box.from[k], box.to[k], begin[k] + 0.5);
            middle[k] = 0.5 * (quarter.from[k] + quarter.to[k]);
        }
        const Eigen::Vector3d place = evaluate(quarter.piece, 0.5, 0.5).position;
        const ScanPoint foot = nearest_(point(place));
        if (!isWitness(foot)) return;
        raise(foot.distance, middle);
        double fromTriangle = 0;
        for (const Eigen::Vector3d& corner : quarter.piece.points)
            fromTriangle = std::max(fromTriangle, distanceToTriangle(foot.triangle, point(corner)));
        quarter.upper = std::min(box.upper, fromTriangle);
        if (isClosed(quarter.upper)) return;
        boxes_.push_back(std::move(quarter));
        std::ranges::push_heap(boxes_, isNearer);
    }

    const Patch& patch_;
    std::size_t number_;
    const NearestOnScan& nearest_;
    double cutOff_;
    CertificationOptions options_;
    std::vector<Box> boxes_;    ///< a heap, from `refine` on
    CertifiedDeviation result_; ///< without an upper bound
};

} // namespace

ScanDeviations deviationFromScan(const std::vector<Patch>& patches, const NearestOnScan& nearest,
                                 double cutOff, const CertificationOptions& options, unsigned jobs) {
    std::vector<CertifiedDeviation> ofPatch(patches.size());
    parallelFor(patches.size(), jobs, [&](std::size_t k) {
        ofPatch[k] = ScanSearch(patches[k], k, nearest, cutOff, options).run();
    });
    ScanDeviations result;
    std::vector<std::pair<double, double>> samples;
    for (const CertifiedDeviation& one : ofPatch) {
        if (one.lower > result.max) {
            result.max = one.lower;
            result.farthest = one.place;
        }
        samples.insert(samples.end(), one.samples.begin(), one.samples.end());
    }
    result.rms = rootMeanSquare(samples);
    result.percentile95 = percentile95(std::move(samples));
    return result;
}

double distanceToTriangle(const std::array<Point, 3>& triangle, const Point& point) {
    const Point normal = (triangle[1] - triangle[0]) % (triangle[2] - triangle[0]);
    const double area = normal.sqrnorm();
    bool isAbove = area > 0;
    double square = HUGE_VAL;
    for (std::size_t k = 0; k < 3; ++k) {
        const Point& from = triangle[k];
        const Point along = triangle[(k + 1) % 3] - from;
        const Point away = point - from;
        isAbove = isAbove && ((normal % along) | away) >= 0;
        const double length = along.sqrnorm();
        const double t = length > 0 ? std::clamp((away | along) / length, 0.0, 1.0) : 0;
        square = std::min(square, (away - t * along).sqrnorm());
    }
    if (isAbove) return std::abs((point - triangle[0]) | normal) / std::sqrt(area);
    return std::sqrt(square);
}

} // namespace qm
