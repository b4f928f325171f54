#include "bspline/curve_fit.h"

#include "bspline/design_matrix.h"
#include "bspline/knot_refinement.h"
#include "bspline/slide.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace qm {
namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// Weights of the slopes at the ends: knots are looked for with the first, and with none where that fails;
/// once they are found, the others, in turn, say how far the slopes can be met for nothing.
constexpr double firstSlopeWeight = 1;
constexpr std::array<double, 7> slopeWeights = {64, 16, 4, 1, 0.25, 0.0625, 0.015625};

Eigen::RowVector3d row(const Point& point) {
    return {point[0], point[1], point[2]};
}

/// The polyline at all sample parameters, then the slopes at its ends.
Rows target(const CurveFitInput& input) {
    const std::size_t edges = input.points.size() - 1;
    Rows result(static_cast<int>(edges) * fitSteps + 3, 3);
    int k = 0;
    for (std::size_t edge = 0; edge < edges; ++edge)
        for (int step = 0; step < fitSteps; ++step) {
            const double share = static_cast<double>(step) / fitSteps;
            result.row(k++) = row((1 - share) * input.points[edge] + share * input.points[edge + 1]);
        }
    result.row(k++) = row(input.points.back());
    result.row(k++) = row(input.startSlope);
    result.row(k) = row(input.endSlope);
    return result;
}

/// Minimises |A x - b| under G x = g by multipliers. The regularisation makes the matrix quasi-definite, so
/// that it can be factorised even where conditions depend on one another; repetition takes its effect away.
Rows solveConstrained(const SparseMatrix& a, const Rows& b, const SparseMatrix& g, const Rows& values) {
    constexpr double regularisation = 1e-6;
    const auto unknowns = static_cast<int>(a.cols());
    const auto conditions = static_cast<int>(g.rows());
    const SparseMatrix normal = a.transpose() * a;
    std::vector<Eigen::Triplet<double, int>> entries;
    for (int k = 0; k < normal.outerSize(); ++k)
        for (SparseMatrix::InnerIterator entry(normal, k); entry; ++entry)
            entries.emplace_back(static_cast<int>(entry.row()), static_cast<int>(entry.col()), entry.value());
    for (int k = 0; k < g.outerSize(); ++k)
        for (SparseMatrix::InnerIterator entry(g, k); entry; ++entry) {
            entries.emplace_back(unknowns + static_cast<int>(entry.row()), static_cast<int>(entry.col()),
                                 entry.value());
            entries.emplace_back(static_cast<int>(entry.col()), unknowns + static_cast<int>(entry.row()),
                                 entry.value());
        }
    for (int k = 0; k < conditions; ++k)
        entries.emplace_back(unknowns + k, unknowns + k, -regularisation);
    SparseMatrix matrix(unknowns + conditions, unknowns + conditions);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<SparseMatrix> factor(matrix);

    Rows right(unknowns + conditions, 3);
    right.topRows(unknowns) = a.transpose() * b;
    Rows multipliers = Rows::Zero(conditions, 3);
    Rows solution;
    for (int round = 0; round < (conditions > 0 ? 4 : 1); ++round) {
        right.bottomRows(conditions) = values - regularisation * multipliers;
        solution = factor.solve(right);
        multipliers = solution.bottomRows(conditions);
    }
    return solution.topRows(unknowns);
}

/// A fit over given knots, with its error at every sample.
struct Attempt {
    Rows control;
    Rows error;
};

class CurveFit {
public:
    CurveFit(const CurveFitInput& input, bool slides)
        : input_(input), slides_(slides),
          parameters_(sampleParameters(static_cast<int>(input.points.size()) - 1, fitSteps)),
          target_(target(input)) {}

    [[nodiscard]] Attempt attempt(const std::vector<double>& knots, double slopeWeight) const {
        const SparseMatrix design = designMatrix(knots, parameters_, slopeWeight, slopeWeight);
        const auto count = static_cast<int>(design.cols());
        Rows goal = target_;
        goal.bottomRows(2) *= slopeWeight;
        Attempt result;
        result.control = Rows::Zero(count, 3);
        result.control.row(0) = row(input_.points.front());
        result.control.row(count - 1) = row(input_.points.back());
        const auto [conditions, values] = passThrough(knots, result.control);
        result.control.middleRows(1, count - 2) = solveConstrained(
            design.middleCols(1, count - 2), goal - design * result.control, conditions, values);
        result.error = design * result.control - goal;
        return result;
    }

    /// Marks where the tolerance is exceeded or a fixed point is missed. False if nowhere.
    bool mark(const Attempt& attempt, double tolerance, double exact, KnotRefinement& refinement) const {
        bool found = false;
        for (std::size_t k = 0; k < parameters_.size(); ++k) {
            const double distance = counted(k, attempt.error.row(static_cast<int>(k)), tolerance);
            if (distance > tolerance) {
                refinement.addError(parameters_[k], distance);
                found = true;
            }
        }
        for (const int fixed : input_.fixed)
            if (attempt.error.row(fixed * fitSteps).norm() > exact) {
                refinement.addKnot(fixed);
                found = true;
            }
        return found;
    }

private:
    /// The error at a sample; at a vertex of the polyline it counts across both edges.
    [[nodiscard]] double counted(std::size_t sample, const Eigen::RowVector3d& error,
                                 double tolerance) const {
        if (!slides_ || error.norm() <= tolerance) return error.norm();
        const std::size_t edges = input_.points.size() - 1;
        const std::size_t edge = std::min(sample / fitSteps, edges - 1);
        const std::size_t first = sample % fitSteps == 0 && edge > 0 ? edge - 1 : edge;
        double result = 0;
        for (std::size_t k = first; k <= edge; ++k) {
            const Eigen::RowVector3d along = row(input_.points[k + 1] - input_.points[k]);
            if (along.squaredNorm() == 0) return error.norm();
            const double slide = error.dot(along) / along.squaredNorm();
            const double off = (error - slide * along).norm();
            result = std::max(result, countedError(off, std::abs(slide), curveSlide, tolerance));
        }
        return result;
    }

    /// The conditions on all control points but the first and the last, which are known.
    [[nodiscard]] std::pair<SparseMatrix, Rows> passThrough(const std::vector<double>& knots,
                                                            const Rows& known) const {
        const auto inner = static_cast<int>(known.rows()) - 2;
        const auto size = static_cast<int>(input_.fixed.size());
        Rows values(size, 3);
        if (size == 0) return {SparseMatrix(0, inner), values};
        const std::vector<double> parameters(input_.fixed.begin(), input_.fixed.end());
        const SparseMatrix basis = designMatrix(knots, parameters, 0, 0).topRows(size);
        for (int k = 0; k < size; ++k)
            values.row(k) =
                row(input_.points[static_cast<std::size_t>(input_.fixed[static_cast<std::size_t>(k)])]);
        return {basis.middleCols(1, inner), values - basis * known};
    }

    const CurveFitInput& input_;
    bool slides_;
    std::vector<double> parameters_;
    Rows target_;
};

SplineCurve curveOf(const std::vector<double>& knots, const Rows& control) {
    SplineCurve curve;
    curve.knots = knots;
    for (int k = 0; k < control.rows(); ++k)
        curve.points.emplace_back(control(k, 0), control(k, 1), control(k, 2));
    return curve;
}

} // namespace

SplineCurve fitCurve(const CurveFitInput& input, double tolerance, double exact, bool slides) {
    const CurveFit fit(input, slides);
    std::vector<double> knots = bareKnots(static_cast<double>(input.points.size() - 1));
    double slopeWeight = firstSlopeWeight;
    while (true) {
        const Attempt attempt = fit.attempt(knots, slopeWeight);
        KnotRefinement refinement(knots);
        const bool fits = !fit.mark(attempt, tolerance, exact, refinement);
        const auto refined = refinement.refined();
        const bool exhausted = refined == knots;
        if (!fits && !(exhausted && slopeWeight == 0)) {
            // Closeness goes before smoothness: try without the slopes before knots are repeated.
            if (slopeWeight > 0 && (exhausted || KnotRefinement(refined).hasRepeatedKnots()))
                slopeWeight = 0;
            else
                knots = refined;
            continue;
        }
        for (const double weight : slopeWeights) {
            if (!fits) break;
            const Attempt smoother = fit.attempt(knots, weight);
            if (!fit.mark(smoother, tolerance, exact, refinement)) return curveOf(knots, smoother.control);
        }
        return curveOf(knots, attempt.control);
    }
}

} // namespace qm
