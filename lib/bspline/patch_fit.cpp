#include "bspline/patch_fit.h"

#include "bspline/design_matrix.h"
#include "bspline/evaluate.h"
#include "bspline/knot_refinement.h"
#include "bspline/mesh_distance.h"
#include "bspline/slide.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

/// One coordinate of a lattice or net: rows along u, columns along v.
using Net = std::array<Eigen::MatrixXd, 3>;
using Factor = Eigen::SimplicialLDLT<SparseMatrix>;

/// Weights of the derivatives across the border: knots are looked for with the first, and with none where
/// that fails; once they are found, the others, in turn, say how far smoothness can be had for nothing.
constexpr double firstSlopeWeight = 1;
constexpr std::array<double, 7> slopeWeights = {64, 16, 4, 1, 0.25, 0.0625, 0.015625};

struct Target {
    std::array<std::vector<double>, 2> parameters;
    Net values; ///< at the parameters; then, as two more rows and columns, derivatives at the ends
};

void set(Net& net, Eigen::Index i, Eigen::Index j, const Point& point) {
    for (std::size_t c = 0; c < 3; ++c)
        net[c](i, j) = point[static_cast<unsigned>(c)];
}

Point get(const Net& net, Eigen::Index i, Eigen::Index j) {
    return {net[0](i, j), net[1](i, j), net[2](i, j)};
}

Target target(const PatchFitInput& input) {
    Target result;
    for (std::size_t d = 0; d < 2; ++d)
        result.parameters[d] = sampleParameters(input.size[d], fitSteps);
    const auto nu = static_cast<Eigen::Index>(result.parameters[0].size());
    const auto nv = static_cast<Eigen::Index>(result.parameters[1].size());
    for (auto& coordinate : result.values)
        coordinate.setZero(nu + 2, nv + 2);

    const auto width = static_cast<std::size_t>(input.size[0]) + 1;
    for (Eigen::Index j = 0; j < nv; ++j)
        for (Eigen::Index i = 0; i < nu; ++i) {
            const auto column =
                static_cast<std::size_t>(std::min<Eigen::Index>(i / fitSteps, input.size[0] - 1));
            const auto row =
                static_cast<std::size_t>(std::min<Eigen::Index>(j / fitSteps, input.size[1] - 1));
            const Point* corner = input.grid.data() + row * width + column;
            set(result.values, i, j,
                bilinear({corner[0], corner[1], corner[width + 1], corner[width]},
                         result.parameters[0][static_cast<std::size_t>(i)] - static_cast<double>(column),
                         result.parameters[1][static_cast<std::size_t>(j)] - static_cast<double>(row)));
        }

    const auto between = [](const std::vector<Point>& points, Eigen::Index sample) -> Point {
        const auto k = static_cast<std::size_t>(sample / fitSteps);
        const double share = static_cast<double>(sample % fitSteps) / fitSteps;
        return share == 0 ? points[k] : (1 - share) * points[k] + share * points[k + 1];
    };
    for (int end = 0; end < 2; ++end) {
        const auto e = static_cast<std::size_t>(end);
        for (Eigen::Index i = 0; i < nu && !input.across[0][e].empty(); ++i)
            set(result.values, i, nv + end, between(input.across[0][e], i));
        for (Eigen::Index j = 0; j < nv && !input.across[1][e].empty(); ++j)
            set(result.values, nu + end, j, between(input.across[1][e], j));
        for (int other = 0; other < 2; ++other)
            set(result.values, nu + other, nv + end, input.twists[static_cast<std::size_t>(2 * end + other)]);
    }
    return result;
}

/// Sampling along one direction, and least squares over the basis functions that are not on the border.
struct Direction {
    SparseMatrix full;
    SparseMatrix inner;
    Factor factor;

    Direction(const std::vector<double>& knots, const std::vector<double>& parameters,
              const std::array<double, 2>& weights)
        : full(designMatrix(knots, parameters, weights[0], weights[1])),
          inner(full.middleCols(1, full.cols() - 2)), factor(SparseMatrix(inner.transpose() * inner)) {}

    /// Coefficients of the columns' best approximations.
    [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& columns) const {
        return factor.solve(inner.transpose() * columns);
    }
};

/// A fit over given knots, with what is left over.
struct Attempt {
    Patch patch;
    std::array<Net, 2> leftBy; ///< what each direction's knots alone cannot approximate
    Net error;
};

class PatchFit {
public:
    PatchFit(const PatchFitInput& input, bool slides)
        : input_(input), slides_(slides), target_(target(input)) {}

    [[nodiscard]] Attempt attempt(const std::array<std::vector<double>, 2>& knots, double slopeWeight) const {
        const Direction u(knots[0], target_.parameters[0], weights(1, slopeWeight));
        const Direction v(knots[1], target_.parameters[1], weights(0, slopeWeight));
        Attempt result;
        result.patch = emptyPatch(knots[0], knots[1]);
        setBorder(result.patch, {input_.border[0], input_.border[1], {}, {}});
        const Eigen::Index columns = result.patch.count[0];
        const Eigen::Index rows = result.patch.count[1];
        for (std::size_t c = 0; c < 3; ++c) {
            Eigen::MatrixXd control(columns, rows);
            for (Eigen::Index j = 0; j < rows; ++j)
                for (Eigen::Index i = 0; i < columns; ++i)
                    control(i, j) = result.patch.controlPoints[static_cast<std::size_t>(j * columns + i)]
                                                              [static_cast<unsigned>(c)];
            Eigen::MatrixXd rest = goal(c, slopeWeight) - sampled(u, control, v);
            const Eigen::MatrixXd alongU = u.solve(rest);
            const Eigen::MatrixXd alongV = v.solve(rest.transpose()).transpose();
            const Eigen::MatrixXd inner = v.solve(alongU.transpose()).transpose();
            result.leftBy[0][c] = rest - u.inner * alongU;
            result.leftBy[1][c] = rest - alongV * v.inner.transpose();
            result.error[c] = rest - u.inner * inner * v.inner.transpose();
            for (Eigen::Index j = 0; j < inner.cols(); ++j)
                for (Eigen::Index i = 0; i < inner.rows(); ++i)
                    result.patch.controlPoints[static_cast<std::size_t>((j + 1) * columns + i + 1)]
                                              [static_cast<unsigned>(c)] = inner(i, j);
        }
        return result;
    }

    /// Marks where the tolerance is exceeded, in the direction to blame. False if nowhere.
    bool mark(const Attempt& attempt, double tolerance, std::array<KnotRefinement, 2>& refinement) const {
        bool found = false;
        const auto nu = static_cast<Eigen::Index>(target_.parameters[0].size());
        const auto nv = static_cast<Eigen::Index>(target_.parameters[1].size());
        for (Eigen::Index j = 0; j < nv; ++j)
            for (Eigen::Index i = 0; i < nu; ++i) {
                const double error = counted(get(attempt.error, i, j), i, j, tolerance);
                if (!(error > tolerance)) continue;
                found = true;
                const std::array<double, 2> at = {target_.parameters[0][static_cast<std::size_t>(i)],
                                                  target_.parameters[1][static_cast<std::size_t>(j)]};
                std::size_t blamed =
                    get(attempt.leftBy[0], i, j).sqrnorm() >= get(attempt.leftBy[1], i, j).sqrnorm() ? 0 : 1;
                if (!refinement[blamed].canRefine(at[blamed])) blamed = 1 - blamed;
                if (refinement[blamed].canRefine(at[blamed])) refinement[blamed].addError(at[blamed], error);
            }
        return found;
    }

private:
    /// The error at a sample; at edges and vertices of the mesh it counts off all quads of the segment there.
    [[nodiscard]] double counted(const Point& error, Eigen::Index i, Eigen::Index j, double tolerance) const {
        if (!slides_ || error.norm() <= tolerance) return error.norm();
        const auto quads = [](Eigen::Index sample, int size) {
            const auto last = std::min<Eigen::Index>(sample / fitSteps, size - 1);
            return std::pair(
                sample % fitSteps == 0 && last > 0 && sample / fitSteps == last ? last - 1 : last, last);
        };
        const auto [firstColumn, lastColumn] = quads(i, input_.size[0]);
        const auto [firstRow, lastRow] = quads(j, input_.size[1]);
        const auto width = static_cast<std::size_t>(input_.size[0]) + 1;
        double result = 0;
        for (Eigen::Index row = firstRow; row <= lastRow; ++row)
            for (Eigen::Index column = firstColumn; column <= lastColumn; ++column) {
                const Point* corner = input_.grid.data() + static_cast<std::size_t>(row) * width + column;
                const double s = static_cast<double>(i) / fitSteps - static_cast<double>(column);
                const double t = static_cast<double>(j) / fitSteps - static_cast<double>(row);
                const Point alongU =
                    (1 - t) * (corner[1] - corner[0]) + t * (corner[width + 1] - corner[width]);
                const Point alongV =
                    (1 - s) * (corner[width] - corner[0]) + s * (corner[width + 1] - corner[1]);
                const Point normal = unitNormal(alongU, alongV);
                if (normal.sqrnorm() == 0) return error.norm();
                const double slide = std::max(std::abs(error | alongU) / alongU.sqrnorm(),
                                              std::abs(error | alongV) / alongV.sqrnorm());
                result =
                    std::max(result, countedError(std::abs(error | normal), slide, patchSlide, tolerance));
            }
        return result;
    }

    [[nodiscard]] std::array<double, 2> weights(std::size_t across, double slopeWeight) const {
        std::array<double, 2> result{};
        for (std::size_t end = 0; end < 2; ++end)
            result[end] = input_.across[across][end].empty() ? 0 : slopeWeight;
        return result;
    }

    /// The target with its derivatives weighted.
    [[nodiscard]] Eigen::MatrixXd goal(std::size_t coordinate, double slopeWeight) const {
        Eigen::MatrixXd result = target_.values[coordinate];
        const auto u = weights(1, slopeWeight);
        const auto v = weights(0, slopeWeight);
        for (int end = 0; end < 2; ++end) {
            result.row(result.rows() - 2 + end) *= u[static_cast<std::size_t>(end)];
            result.col(result.cols() - 2 + end) *= v[static_cast<std::size_t>(end)];
        }
        return result;
    }

    static Eigen::MatrixXd sampled(const Direction& u, const Eigen::MatrixXd& control, const Direction& v) {
        const Eigen::MatrixXd rows = u.full * control;
        return rows * v.full.transpose();
    }

    const PatchFitInput& input_;
    bool slides_;
    Target target_;
};

std::vector<double> tripleKnots(int edges) {
    std::vector<double> knots(4, 0);
    for (int k = 1; k < edges; ++k)
        knots.insert(knots.end(), 3, k);
    knots.insert(knots.end(), 4, edges);
    return knots;
}

/// The quads themselves, as a spline without any smoothness, but with the given border.
Patch quadsAsPatch(const PatchFitInput& input) {
    Patch patch = emptyPatch(tripleKnots(input.size[0]), tripleKnots(input.size[1]));
    const auto width = static_cast<std::size_t>(input.size[0]) + 1;
    for (int j = 0; j < patch.count[1]; ++j)
        for (int i = 0; i < patch.count[0]; ++i) {
            const int column = std::min(i / 3, input.size[0] - 1);
            const int row = std::min(j / 3, input.size[1] - 1);
            const Point* corner =
                input.grid.data() + static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column);
            patch.controlPoints[static_cast<std::size_t>(j * patch.count[0] + i)] = bilinear(
                {corner[0], corner[1], corner[width + 1], corner[width]}, i / 3.0 - column, j / 3.0 - row);
        }
    setBorder(patch, {input.border[0], input.border[1], {}, {}});
    return patch;
}

/// Of the fits over the patch's knots within the tolerance, the one that aims hardest at the derivatives.
Patch smoothest(const PatchFit& fit, const Patch& patch, double tolerance) {
    for (const double weight : slopeWeights) {
        const Attempt attempt = fit.attempt(patch.knots, weight);
        std::array<KnotRefinement, 2> unused = {KnotRefinement(patch.knots[0]),
                                                KnotRefinement(patch.knots[1])};
        if (!fit.mark(attempt, tolerance, unused)) return attempt.patch;
    }
    return patch;
}

} // namespace

Patch fitPatch(const PatchFitInput& input, double tolerance, bool slides) {
    const PatchFit fit(input, slides);
    std::array<std::vector<double>, 2> knots;
    for (std::size_t d = 0; d < 2; ++d)
        knots[d] = commonKnots(input.border[d][0].knots, input.border[d][1].knots);
    double slopeWeight = firstSlopeWeight;
    while (true) {
        const Attempt attempt = fit.attempt(knots, slopeWeight);
        std::array<KnotRefinement, 2> refinement = {KnotRefinement(knots[0]), KnotRefinement(knots[1])};
        if (!fit.mark(attempt, tolerance, refinement)) return smoothest(fit, attempt.patch, tolerance);
        const std::array<std::vector<double>, 2> refined = {refinement[0].refined(), refinement[1].refined()};
        const bool repeats =
            KnotRefinement(refined[0]).hasRepeatedKnots() || KnotRefinement(refined[1]).hasRepeatedKnots();
        if (slopeWeight > 0 && (repeats || refined == knots)) {
            slopeWeight = 0; // closeness goes before smoothness: try without, before knots are repeated
            continue;
        }
        if (refined == knots) return quadsAsPatch(input);
        knots = refined;
    }
}

} // namespace qm
