/// \file The points of a segment's quads that a patch is fitted to, and what an error there counts.
#pragma once

#include "bspline/closeness.h"
#include "bspline/surfaces.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace qm {

/// A lattice over a segment's quads, row by row: four steps for every edge, two where there are many quads.
/// Where errors may slide, only their parts across the quads count in full.
class PatchSamples {
public:
    /// \param grid  row by row as in `vertexGrid`; it must outlive the samples \param closeness  at the same
    /// vertices; if it is empty, nothing slides
    PatchSamples(const std::array<int, 2>& size, std::span<const Point> grid, double tolerance,
                 std::span<const Closeness> closeness);

    [[nodiscard]] std::size_t size() const { return samples_.size(); }
    /// Parameters of the lattice along u (0) or v (1).
    [[nodiscard]] const std::vector<double>& parameters(std::size_t direction) const {
        return parameters_[direction];
    }
    /// The parameters u and v of a sample.
    [[nodiscard]] std::array<double, 2> at(std::size_t sample) const;
    [[nodiscard]] const Point& target(std::size_t sample) const { return samples_[sample].target; }
    [[nodiscard]] const Eigen::Matrix3d& metric(std::size_t sample) const { return samples_[sample].metric; }
    /// On the border the curves decide.
    [[nodiscard]] bool isOnBorder(std::size_t sample) const { return samples_[sample].onBorder; }

    /// An error at a sample, in tolerances; at edges and vertices of the mesh it counts off all quads of the
    /// segment there.
    [[nodiscard]] double counted(std::size_t sample, const Point& error) const;

    /// For both directions, which lines of the grid are edges that no smooth surface should follow.
    [[nodiscard]] const std::array<std::vector<bool>, 2>& sharpLines() const { return sharp_; }

    /// The point of the quads at any parameters.
    [[nodiscard]] Point onQuads(double u, double v) const;

private:
    struct Sample {
        Point target{0, 0, 0};
        Eigen::Matrix3d metric = Eigen::Matrix3d::Identity();
        std::array<Point, 4> normals;              ///< of the quads there
        std::array<std::array<Point, 2>, 4> steps; ///< along u and v
        std::size_t quads = 0;
        double tolerance = 0;
        bool slides = false;
        bool degenerate = false;
        bool onBorder = false;
    };

    [[nodiscard]] Sample sampleAt(std::size_t i, std::size_t j) const;
    [[nodiscard]] Closeness closenessAt(double u, double v) const;
    [[nodiscard]] Eigen::Matrix3d metricOf(const Sample& sample) const;
    void findSharpLines();

    std::array<int, 2> size_;
    std::span<const Point> grid_;
    std::span<const Closeness> closeness_;
    double tolerance_;
    int steps_; ///< of the lattice along every edge
    std::array<std::vector<double>, 2> parameters_;
    std::vector<Sample> samples_;
    std::array<std::vector<bool>, 2> sharp_;
};

} // namespace qm
