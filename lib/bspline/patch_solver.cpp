#include "bspline/patch_solver.h"

#include "bspline/design_matrix.h"
#include "bspline/eigen_point.h"
#include "bspline/evaluate.h"
#include "bspline/patch_frame.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace qm {
namespace {

/// Weight of the prescribed normals while knots are looked for, and the weight from which on they are tried
/// once there are enough knots. A normal counts with its effect at the distance of an edge.
constexpr double searchWeight = 0.3;
constexpr std::array<double, 3> mostWeights = {16, 3, 0.8};
/// How much less the length of a derivative across the border counts than its direction: but for it, a
/// derivative of length zero would be orthogonal to every normal.
constexpr double lengthShare = 0.1;

/// Patches with more quads than this get fewer rounds.
constexpr int largePatch = 800;

/// What least squares over the knots leaves of every column.
Eigen::MatrixXd leftOver(const std::vector<double>& knots, const std::vector<double>& parameters,
                         const Eigen::MatrixXd& values) {
    const SparseMatrix design = designMatrix(knots, parameters);
    SparseMatrix normal = design.transpose() * design;
    for (int k = 0; k < normal.rows(); ++k)
        normal.coeffRef(k, k) += 1e-9;
    const Eigen::SimplicialLDLT<SparseMatrix> factor(normal);
    const Eigen::MatrixXd right = design.transpose() * values;
    const Eigen::MatrixXd solution = factor.solve(right);
    return values - design * solution;
}

} // namespace

PatchSolver::PatchSolver(const PatchFitInput& input, double tolerance, std::span<const Closeness> closeness)
    : input_(input),
      samples_({input.grid, input.size}, tolerance, closeness), normalAt_{normalParameters(input.size[0]),
                                                                          normalParameters(input.size[1])} {
    prescribeNormals();
}

bool PatchSolver::isLarge() const {
    return input_.size[0] * input_.size[1] > largePatch;
}

PatchSolver::NormalWeights PatchSolver::normalWeights(double weight) const {
    NormalWeights weights;
    for (std::size_t d = 0; d < 2; ++d)
        for (auto& ofEnd : weights[d])
            ofEnd.assign(normalAt_[d].size(), weight);
    return weights;
}

bool PatchSolver::isQuick(const Knots& knots) {
    constexpr double most = 2e9; // multiplications of one factorisation in its band
    const auto fewer = static_cast<double>(std::min(knots[0].size(), knots[1].size()));
    const auto more = static_cast<double>(std::max(knots[0].size(), knots[1].size()));
    return 3 * fewer * more * (9 * fewer) * (9 * fewer) < most;
}

PatchAttempt PatchSolver::attempt(const Knots& knots, bool aimsAtNormals) const {
    const double hopeless = isLarge() ? 1.5 : 2; // errors that weights do not mend
    const NormalWeights normals = normalWeights(aimsAtNormals ? searchWeight : 0);
    std::vector<double> weights(samples_.size(), 1);
    PatchAttempt best;
    for (int round = 0; round < (!aimsAtNormals ? 1 : isLarge() ? 2 : 3); ++round) {
        PatchAttempt next = solve(knots, weights, normals);
        for (std::size_t k = 0; k < samples_.size(); ++k)
            weights[k] *= 0.1 + next.errors[k];
        const double largest = next.largest;
        if (round == 0 || largest < best.largest) best = std::move(next);
        if (largest <= 1 || !(largest <= hopeless)) break;
    }
    return best;
}

std::optional<PatchAttempt> PatchSolver::smoothest(const Knots& knots, const Patch& known) const {
    if (!isQuick(knots)) return std::nullopt;
    constexpr double upright = 0.3;
    const double advance = std::min(upright, leastAdvance(known));
    for (const double most : mostWeights) {
        if (isLarge() && most == mostWeights.front()) continue; // seldom enough to take the time
        std::vector<double> weights(samples_.size(), 1);
        NormalWeights normals = normalWeights(most);
        for (int round = 0; round < (isLarge() ? 2 : 5); ++round) {
            PatchAttempt next = solve(knots, weights, normals);
            if (next.largest <= 1) {
                if (leastAdvance(next.patch) >= advance) return next;
                break;
            }
            for (std::size_t k = 0; k < samples_.size(); ++k)
                if (next.errors[k] > 1) {
                    weights[k] *= std::min(next.errors[k] * 1.5, 4.0);
                    lower(normals, k);
                }
        }
    }
    return std::nullopt;
}

/// Makes the normals near a sample count less.
void PatchSolver::lower(NormalWeights& normals, std::size_t sample) const {
    constexpr double near = 1.6; // edges
    constexpr double factor = 0.5;
    const std::array<double, 2> at = samples_.at(sample);
    for (std::size_t d = 0; d < 2; ++d)
        for (std::size_t end = 0; end < 2; ++end) {
            const double away = std::abs(at[1 - d] - (end == 0 ? 0 : input_.size[1 - d]));
            if (away > near) continue;
            for (std::size_t k = 0; k < normalAt_[d].size(); ++k)
                if (std::abs(normalAt_[d][k] - at[d]) <= near)
                    normals[d][end][k] = std::max(searchWeight, factor * normals[d][end][k]);
        }
}

void PatchSolver::mark(const PatchAttempt& attempt, std::array<KnotRefinement, 2>& refinement) const {
    const auto left = leftBy(attempt.patch.knots);
    // The smaller errors may go with the largest ones; but where all are large, that takes too many rounds.
    constexpr double far = 10;
    const double enough = attempt.largest > far ? 1 : 1 + 0.3 * (attempt.largest - 1);
    for (std::size_t k = 0; k < samples_.size(); ++k) {
        if (!(attempt.errors[k] > 1) || attempt.errors[k] < enough) continue;
        const std::array<double, 2> at = samples_.at(k);
        std::size_t blamed = left[0][k] >= left[1][k] ? 0 : 1;
        if (!refinement[blamed].canRefine(at[blamed])) blamed = 1 - blamed;
        if (refinement[blamed].canRefine(at[blamed]))
            refinement[blamed].addError(at[blamed], attempt.errors[k]);
    }
}

PatchAttempt PatchSolver::solve(const Knots& knots, const std::vector<double>& weights,
                                const NormalWeights& normalWeights) const {
    Patch frame = emptyPatch(knots[0], knots[1]);
    setBorder(frame, {input_.border[0], input_.border[1], {}, {}});
    PatchEquations equations(frame);
    const auto tableU = basisTable(knots[0], frame.degree[0], samples_.parameters(0));
    const auto tableV = basisTable(knots[1], frame.degree[1], samples_.parameters(1));
    equations.addLattice(tableU, tableV, weights, samples_.metrics(), samples_.targets());
    addPull(equations, frame);
    addNormals(equations, frame, normalWeights);
    PatchAttempt result;
    result.patch = equations.solve();
    const std::vector<Point> positions = positionLattice(result.patch, tableU, tableV);
    for (std::size_t k = 0; k < samples_.size(); ++k) {
        const double error =
            samples_.isOnBorder(k) ? 0 : samples_.counted(k, positions[k] - samples_.targets()[k]);
        result.errors.push_back(error);
        if (!(error <= result.largest)) result.largest = error;
    }
    return result;
}

/// What the samples do not determine stays near the quads.
void PatchSolver::addPull(PatchEquations& equations, const Patch& frame) const {
    constexpr double weight = 1e-4;
    const auto greville = [&](std::size_t d, std::size_t k) {
        const auto first = frame.knots[d].begin() + static_cast<std::ptrdiff_t>(k) + 1;
        return std::accumulate(first, first + frame.degree[d], 0.0) / frame.degree[d];
    };
    const auto one = [](std::size_t k) {
        return k < 3 ? BasisWeights{0, {k == 0 ? 1.0 : 0, k == 1 ? 1.0 : 0, k == 2 ? 1.0 : 0, 0}}
                     : BasisWeights{k - 3, {0, 0, 0, 1}};
    };
    const auto rows = static_cast<std::size_t>(frame.count[1]);
    const auto columns = static_cast<std::size_t>(frame.count[0]);
    for (std::size_t j = 1; j + 1 < rows; ++j)
        for (std::size_t i = 1; i + 1 < columns; ++i)
            equations.add(one(i), one(j), weight * Eigen::Matrix3d::Identity(),
                          samples_.quads().at(greville(0, i), greville(1, j)));
}

/// The derivative across a border is to be orthogonal to the normals there.
void PatchSolver::addNormals(PatchEquations& equations, const Patch& frame,
                             const NormalWeights& weights) const {
    for (std::size_t d = 0; d < 2; ++d) {
        const auto table = basisTable(frame.knots[d], frame.degree[d], normalAt_[d]);
        for (std::size_t end = 0; end < 2; ++end) {
            const BasisWeights across = derivativeWeights(
                basisValues(frame.knots[1 - d], frame.degree[1 - d], end == 0 ? 0 : input_.size[1 - d]));
            for (std::size_t k = 0; k < prescribed_[d][end].size(); ++k) {
                const auto& [normal, aim] = prescribed_[d][end][k];
                const double weight = weights[d][end][k];
                if (normal.sqrnorm() == 0 || weight == 0) continue;
                const Eigen::Matrix3d off = vector(normal) * vector(normal).transpose();
                const Eigen::Matrix3d metric =
                    weight * weight * (off + lengthShare * lengthShare * (Eigen::Matrix3d::Identity() - off));
                const BasisWeights along = valueWeights(table[k]);
                equations.add(d == 0 ? along : across, d == 0 ? across : along, metric, aim);
            }
        }
    }
}

void PatchSolver::prescribeNormals() {
    for (std::size_t d = 0; d < 2; ++d)
        for (std::size_t end = 0; end < 2; ++end)
            for (std::size_t k = 0; k < input_.normals[d][end].size(); ++k) {
                const Point tangent = derivative(input_.border[d][end], normalAt_[d][k]);
                const Point normal = unitNormalAcross(input_.normals[d][end][k], tangent);
                const Point step = stepAcross(d, end, normalAt_[d][k]);
                Point aim = step - (step | normal) * normal;
                if (const double size = aim.norm(); size > 0.5 * step.norm()) aim *= step.norm() / size;
                prescribed_[d][end].push_back({normal, aim});
            }
}

/// How far the patch leads inwards from its borders, as a share of what the quads beside them do: the least
/// at all places of normals. Where it is negative, the patch is folded.
double PatchSolver::leastAdvance(const Patch& patch) const {
    double least = 1;
    for (std::size_t d = 0; d < 2; ++d)
        for (std::size_t end = 0; end < 2; ++end) {
            const auto points = pointsOnBorder(patch, d, end);
            for (std::size_t k = 0; k < prescribed_[d][end].size(); ++k) {
                const Point& aim = prescribed_[d][end][k].aim;
                const Point& across = d == 0 ? points[k].dv : points[k].du;
                if (aim.sqrnorm() > 0) least = std::min(least, (across | aim) / aim.sqrnorm());
            }
        }
    return least;
}

/// Of the quads beside a border, across it.
Point PatchSolver::stepAcross(std::size_t direction, std::size_t end, double along) const {
    const double last = input_.size[1 - direction];
    const double outer = end == 0 ? 0 : last - 1;
    return direction == 0 ? samples_.quads().at(along, outer + 1) - samples_.quads().at(along, outer)
                          : samples_.quads().at(outer + 1, along) - samples_.quads().at(outer, along);
}

/// What the knots of each direction alone leave of the samples, as errors count.
std::array<std::vector<double>, 2> PatchSolver::leftBy(const Knots& knots) const {
    const auto nu = static_cast<Eigen::Index>(samples_.parameters(0).size());
    const auto nv = static_cast<Eigen::Index>(samples_.parameters(1).size());
    std::array<std::array<Eigen::MatrixXd, 3>, 2> left;
    for (unsigned c = 0; c < 3; ++c) {
        Eigen::MatrixXd values(nu, nv);
        for (Eigen::Index j = 0; j < nv; ++j)
            for (Eigen::Index i = 0; i < nu; ++i)
                values(i, j) = samples_.targets()[static_cast<std::size_t>(j * nu + i)][c];
        left[0][c] = leftOver(knots[0], samples_.parameters(0), values);
        left[1][c] = leftOver(knots[1], samples_.parameters(1), values.transpose()).transpose();
    }
    std::array<std::vector<double>, 2> result;
    for (std::size_t d = 0; d < 2; ++d)
        for (Eigen::Index j = 0; j < nv; ++j)
            for (Eigen::Index i = 0; i < nu; ++i)
                result[d].push_back(samples_.counted(static_cast<std::size_t>(j * nu + i),
                                                     {left[d][0](i, j), left[d][1](i, j), left[d][2](i, j)}));
    return result;
}

} // namespace qm
