#include "bspline/patch_samples.h"

#include "bspline/design_matrix.h"
#include "bspline/eigen_point.h"
#include "bspline/evaluate.h"
#include "bspline/mesh_distance.h"
#include "bspline/slide.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace qm {
namespace {

/// Of the lattice along every edge. Many quads get fewer samples each, as long as errors may slide somewhere:
/// then the result is measured later.
int stepsFor(const std::array<int, 2>& size, std::span<const Closeness> closeness) {
    constexpr int manyQuads = 100;
    return size[0] * size[1] > manyQuads && std::ranges::any_of(closeness, &Closeness::slides) ? 2 : fitSteps;
}

} // namespace

PatchSamples::PatchSamples(QuadGrid quads, double tolerance, std::span<const Closeness> closeness)
    : quads_(std::move(quads)), closeness_(closeness), tolerance_(tolerance),
      steps_(stepsFor(quads_.size(), closeness)), parameters_{sampleParameters(size(0), steps_),
                                                              sampleParameters(size(1), steps_)} {
    const std::size_t samples = parameters_[0].size() * parameters_[1].size();
    samples_.reserve(samples);
    targets_.reserve(samples);
    metrics_.reserve(samples);
    for (std::size_t j = 0; j < parameters_[1].size(); ++j)
        for (std::size_t i = 0; i < parameters_[0].size(); ++i)
            addSample(i, j);
    findSharpLines();
}

std::array<double, 2> PatchSamples::at(std::size_t sample) const {
    const std::size_t width = parameters_[0].size();
    return {parameters_[0][sample % width], parameters_[1][sample / width]};
}

void PatchSamples::addSample(std::size_t i, std::size_t j) {
    const auto around = [&](std::size_t sample, int size) {
        const int at = static_cast<int>(sample) / steps_;
        const int last = std::min(at, size - 1);
        const bool between = static_cast<int>(sample) % steps_ == 0 && last > 0 && at == last;
        return std::pair(between ? last - 1 : last, last);
    };
    const auto [firstColumn, lastColumn] = around(i, size(0));
    const auto [firstRow, lastRow] = around(j, size(1));
    Sample& sample = samples_.emplace_back();
    Point target;
    sample.onBorder = i == 0 || j == 0 || i + 1 == parameters_[0].size() || j + 1 == parameters_[1].size();
    for (int row = firstRow; row <= lastRow; ++row)
        for (int column = firstColumn; column <= lastColumn; ++column) {
            const QuadCorners corners = quads_.corners(column, row);
            const double s = parameters_[0][i] - column;
            const double t = parameters_[1][j] - row;
            const Point alongU = (1 - t) * (corners[1] - corners[0]) + t * (corners[2] - corners[3]);
            const Point alongV = (1 - s) * (corners[3] - corners[0]) + s * (corners[2] - corners[1]);
            const Point normal = unitNormal(alongU, alongV);
            target = bilinear(corners, s, t);
            sample.normals[sample.quads] = normal;
            sample.steps[sample.quads++] = {alongU, alongV};
            sample.degenerate = sample.degenerate || normal.sqrnorm() == 0;
        }
    const Closeness closeness = closenessAt(parameters_[0][i], parameters_[1][j]);
    sample.tolerance = closeness.share * tolerance_;
    sample.slides = closeness.slides;
    targets_.push_back(target);
    metrics_.emplace_back(metricOf(sample) / (closeness.share * closeness.share));
}

Closeness PatchSamples::closenessAt(double u, double v) const {
    if (closeness_.empty()) return {1, false};
    const int column = std::min(static_cast<int>(u), size(0) - 1);
    const int row = std::min(static_cast<int>(v), size(1) - 1);
    const auto width = static_cast<std::size_t>(size(0)) + 1;
    const Closeness* corner =
        closeness_.data() + static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column);
    return between(between(corner[0], corner[1], u - column),
                   between(corner[width], corner[width + 1], u - column), v - row);
}

/// Off the mean plane of the quads an error counts in full, along it as little as it may slide there.
Eigen::Matrix3d PatchSamples::metricOf(const Sample& sample) const {
    Point normal{0, 0, 0};
    double shortest = HUGE_VAL;
    for (std::size_t k = 0; k < sample.quads; ++k) {
        normal += sample.normals[k];
        for (const Point& step : sample.steps[k])
            shortest = std::min(shortest, step.norm());
    }
    const double length = normal.norm();
    const double slide = std::max(sample.tolerance / (patchSlide * shortest), leastSlideWeight);
    if (!sample.slides || !(slide < 1) || !(length > 0.5)) return Eigen::Matrix3d::Identity();
    const Eigen::Vector3d direction = vector(normal) / length;
    return slide * slide * Eigen::Matrix3d::Identity() +
           (1 - slide * slide) * direction * direction.transpose();
}

void PatchSamples::findSharpLines() {
    constexpr double cosine = 0.85;
    for (std::size_t d = 0; d < 2; ++d)
        sharp_[d].assign(static_cast<std::size_t>(size(d)) + 1, false);
    const std::size_t width = parameters_[0].size();
    for (std::size_t k = 0; k < samples_.size(); ++k) {
        const Sample& sample = samples_[k];
        for (std::size_t a = 1; a < sample.quads; ++a) {
            if ((sample.normals[0] | sample.normals[a]) > cosine || sample.quads != 2) continue;
            const std::size_t i = k % width;
            const std::size_t j = k / width;
            const auto steps = static_cast<std::size_t>(steps_);
            const bool acrossU = i % steps == 0 && j % steps != 0;
            sharp_[acrossU ? 0 : 1][(acrossU ? i : j) / steps] = true;
        }
    }
}

double PatchSamples::counted(std::size_t sample, const Point& error) const {
    const Sample& here = samples_[sample];
    const double length = error.norm();
    if (!here.slides || length <= here.tolerance || here.degenerate) return length / here.tolerance;
    double result = 0;
    for (std::size_t k = 0; k < here.quads; ++k) {
        result = std::max(result, std::abs(error | here.normals[k]) / here.tolerance);
        for (const Point& along : here.steps[k]) {
            const double step = along.norm();
            const double slide = std::abs(error | along) / step;
            result = std::max(result, slide / std::max(patchSlide * step, here.tolerance));
        }
    }
    return result;
}

} // namespace qm
