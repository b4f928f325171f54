/// \file The points of a segment's quads that a patch is fitted to, and what an error there counts.
#pragma once

#include "bspline/closeness.h"
#include "bspline/quad_grid.h"
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
    /// \param closeness  at the quads' vertices, row by row; if it is empty, nothing slides. It must outlive
    /// the samples
    PatchSamples(QuadGrid quads, double tolerance, std::span<const Closeness> closeness);

    [[nodiscard]] std::size_t size() const { return samples_.size(); }
    /// Parameters of the lattice along u (0) or v (1).
    [[nodiscard]] const std::vector<double>& parameters(std::size_t direction) const {
        return parameters_[direction];
    }
    /// The parameters u and v of a sample.
    [[nodiscard]] std::array<double, 2> at(std::size_t sample) const;
    [[nodiscard]] const std::vector<Point>& targets() const { return targets_; }
    [[nodiscard]] const std::vector<Eigen::Matrix3d>& metrics() const { return metrics_; }
    /// On the border the curves decide.
    [[nodiscard]] bool isOnBorder(std::size_t sample) const { return samples_[sample].onBorder; }

    /// An error at a sample, in tolerances; at edges and vertices of the mesh it counts off all quads of the
    /// segment there.
    [[nodiscard]] double counted(std::size_t sample, const Point& error) const;

    /// For both directions, which lines of the grid are edges that no smooth surface should follow.
    [[nodiscard]] const std::array<std::vector<bool>, 2>& sharpLines() const { return sharp_; }

    [[nodiscard]] const QuadGrid& quads() const { return quads_; }

private:
    struct Sample {
        std::array<Point, 4> normals;              ///< of the quads there
        std::array<std::array<Point, 2>, 4> steps; ///< along u and v
        std::size_t quads = 0;
        double tolerance = 0;
        bool slides = false;
        bool degenerate = false;
        bool onBorder = false;
    };

    [[nodiscard]] int size(std::size_t direction) const { return quads_.size()[direction]; }
    void addSample(std::size_t i, std::size_t j);
    [[nodiscard]] Closeness closenessAt(double u, double v) const;
    [[nodiscard]] Eigen::Matrix3d metricOf(const Sample& sample) const;
    void findSharpLines();

    QuadGrid quads_;
    std::span<const Closeness> closeness_;
    double tolerance_;
    int steps_; ///< of the lattice along every edge
    std::array<std::vector<double>, 2> parameters_;
    std::vector<Sample> samples_;
    std::vector<Point> targets_;
    std::vector<Eigen::Matrix3d> metrics_;
    std::array<std::vector<bool>, 2> sharp_;
};

} // namespace qm
