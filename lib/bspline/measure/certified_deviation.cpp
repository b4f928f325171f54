#include "bspline/measure/certified_deviation.h"

#include "base/infinity.h"
#include "base/parallel.h"
#include "bspline/measure/distance_bound.h"
#include "bspline/measure/gauss_points.h"
#include "bspline/measure/largest_first.h"
#include "bspline/measure/quarter_turns.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

class PatchSearch {
public:
    PatchSearch(const PairedSurfaces& surfaces, std::size_t patch, const CertificationOptions& options)
        : surfaces_(surfaces), patch_(patch), options_(options), bound_(surfaces) {}

    CertifiedDeviation run() {
        const std::vector<Cell> cells = surfaces_.cells(patch_);
        parts_.reserve(cells.size());
        result_.samples.reserve(4 * cells.size());
        for (const Cell& cell : cells)
            addCell(cell);
        if (farthest_ > 0) seed();
        const std::size_t effort = options_.stepsFor(parts_.size());
        result_.upper = boundLargestFirst(
            std::move(parts_), effort,
            [&](double upper) { return upper <= options_.enoughFor(result_.lower); },
            [&](const SurfacePart& part, const auto& add) { divide(part, add); });
        // To first order, samples can be too large.
        for (Sample& sample : result_.samples)
            sample.value = std::min(sample.value, result_.upper);
        return std::move(result_);
    }

private:
    /// The box between a cell's boundaries on both surfaces, and samples.
    void addCell(const Cell& cell) {
        surfaces_.get(0, cell, difference_);
        surfaces_.get(1, cell, reference_);
        for (std::size_t k = 0; k < difference_.points.size(); ++k)
            difference_.points[k] -= reference_.points[k];
        SurfacePart part;
        part.cell = cell;
        part.upper = farthestFrom(Eigen::Vector3d::Zero(), difference_);
        parts_.push_back(part);

        for (const GaussPoint& point : gaussPoints(surfaces_.box(cell))) {
            const LayoutPlace place{patch_, point.at};
            const double distance = distanceAt(place, point.u, point.v);
            result_.samples.push_back({distance, point.area});
            if (distance <= farthest_) continue;
            farthest_ = distance;
            farthestAt_ = place;
        }
    }

    /// To first order, where little slides along the reference.
    /// \param u, v  within the cell
    [[nodiscard]] double distanceAt(const LayoutPlace& place, double u, double v) {
        const PiecePoint away = evaluate(difference_, u, v);
        const PiecePoint on = evaluate(reference_, u, v);
        const Eigen::Vector3d normal = on.du.cross(on.dv);
        const double square = away.position.squaredNorm();
        const double area = normal.squaredNorm();
        const double height = away.position.dot(normal);
        constexpr double little = 0.1; // of a mesh edge
        const double slide = square - height * height / area;
        if (slide <= little * little * std::min(on.du.squaredNorm(), on.dv.squaredNorm()))
            return std::abs(height) / std::sqrt(area);
        return bound_.search()(1, place, on.position + away.position).distance;
    }

    /// A first lower bound, from the farthest sample.
    void seed() {
        FootSearch& search = bound_.search();
        for (std::size_t surface : {0U, 1U}) {
            const Eigen::Vector3d point = search.evaluateAt(surface, farthestAt_).position;
            result_.raise(search(1 - surface, farthestAt_, point).distance, farthestAt_);
        }
    }

    /// Hands over the parts of a part, bounded.
    template <class Add> void divide(const SurfacePart& part, const Add& add) {
        const auto addBounded = [&](SurfacePart& one) {
            bound_.tighten(one, result_.lower, options_.enoughFor(result_.lower));
            result_.raise(one.foot.distance, bound_.middle(one));
            add(one);
        };
        if (!part.isDirected) {
            for (std::size_t surface : {0U, 1U}) {
                SurfacePart whole = part;
                whole.isDirected = true;
                whole.surface = surface;
                whole.foot.place = bound_.middle(whole);
                addBounded(whole);
            }
            return;
        }
        const LayoutPlace middle = bound_.middle(part);
        for (const bool right : {false, true})
            for (const bool top : {false, true}) {
                SurfacePart quarter = part;
                (right ? quarter.from : quarter.to)[0] = part.division[0];
                (top ? quarter.from : quarter.to)[1] = part.division[1];
                const LayoutPlace at = bound_.middle(quarter);
                const auto way =
                    turned<double>({at.at[0] - middle.at[0], at.at[1] - middle.at[1]}, quarter.foot.turns);
                const auto extent = surfaces_.extent(quarter.foot.place.patch);
                for (std::size_t k = 0; k < 2; ++k)
                    quarter.foot.place.at[k] = std::clamp(quarter.foot.place.at[k] + way[k], 0.0, extent[k]);
                addBounded(quarter);
            }
    }

    const PairedSurfaces& surfaces_;
    std::size_t patch_;
    CertificationOptions options_;
    DistanceBound bound_;
    BezierPiece reference_;
    BezierPiece difference_;
    std::vector<SurfacePart> parts_;
    double farthest_ = 0; ///< of the samples
    LayoutPlace farthestAt_;
    CertifiedDeviation result_;
};

} // namespace

void CertifiedDeviation::raise(double distance, const LayoutPlace& at) {
    if (distance <= lower) return;
    lower = distance;
    place = at;
}

double CertificationOptions::enoughFor(double lower) const {
    return std::max(negligible, (1 + closing) * lower);
}

CertifiedDeviation certifiedDeviation(const PairedSurfaces& surfaces, std::size_t patch,
                                      const CertificationOptions& options) {
    return PatchSearch(surfaces, patch, options).run();
}

std::vector<CertifiedDeviation> certifiedDeviations(const PairedSurfaces& surfaces,
                                                    const CertificationOptions& options, unsigned jobs) {
    std::vector<CertifiedDeviation> result(surfaces.patches());
    CertificationOptions rough = options;
    rough.negligible = infinity;
    parallelFor(result.size(), jobs,
                [&](std::size_t k) { result[k] = certifiedDeviation(surfaces, k, rough); });
    CertificationOptions close = options;
    for (const CertifiedDeviation& one : result)
        close.negligible = std::max(close.negligible, one.lower / 2);
    parallelFor(result.size(), jobs, [&](std::size_t k) {
        if (!(result[k].upper <= close.enoughFor(result[k].lower)))
            result[k] = certifiedDeviation(surfaces, k, close);
    });
    return result;
}

} // namespace qm
