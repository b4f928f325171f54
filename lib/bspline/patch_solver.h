/// \file The best patch over given knots, between given border curves.
#pragma once

#include "bspline/knot_refinement.h"
#include "bspline/patch_equations.h"
#include "bspline/patch_fit.h"
#include "bspline/patch_samples.h"

#include <array>
#include <optional>
#include <vector>

namespace qm {

/// Knots along u and v.
using Knots = std::array<std::vector<double>, 2>;

/// A fit over given knots.
struct PatchAttempt {
    Patch patch;
    std::vector<double> errors; ///< at the samples, in tolerances; 0 on the border
    double largest = 0;         ///< of the errors
};

/// Least squares over the samples and the prescribed normals. Where an error is large its weight grows, and
/// the same is solved again: that makes the largest error smaller than least squares alone would.
class PatchSolver {
public:
    /// \param closeness  as for `PatchSamples`
    PatchSolver(const PatchFitInput& input, double tolerance, std::span<const Closeness> closeness);

    [[nodiscard]] const PatchSamples& samples() const { return samples_; }

    /// Whether a solution over these knots takes no longer than moments while coordinates depend on one
    /// another: where errors slide, or normals are aimed at.
    [[nodiscard]] static bool isQuick(const Knots& knots);

    /// \param aimsAtNormals  the prescribed normals count, if moderately
    [[nodiscard]] PatchAttempt attempt(const Knots& knots, bool aimsAtNormals) const;

    /// The patch whose normals are as near to the prescribed ones as the tolerance allows: they count less
    /// wherever the tolerance is exceeded. None if it is exceeded all the same, or if that is not quick.
    /// \param known  another patch between the same curves: it is not folded more than this one
    [[nodiscard]] std::optional<PatchAttempt> smoothest(const Knots& knots, const Patch& known) const;

    /// Asks for knots where the tolerance is exceeded most, in the direction to blame.
    void mark(const PatchAttempt& attempt, std::array<KnotRefinement, 2>& refinement) const;

private:
    /// Weights of the prescribed normals, in the order of the input.
    using NormalWeights = OnBorder<std::vector<double>>;

    struct Prescribed {
        Point normal{0, 0, 0}; ///< across the border curve; zero where there is none
        Point aim{0, 0, 0};    ///< what the derivative across is to be, about
    };

    [[nodiscard]] double leastAdvance(const Patch& patch) const;
    void prescribeNormals();
    [[nodiscard]] bool isLarge() const;
    [[nodiscard]] NormalWeights normalWeights(double weight) const;
    void lower(NormalWeights& normals, std::size_t sample) const;
    [[nodiscard]] PatchAttempt solve(const Knots& knots, const std::vector<double>& weights,
                                     const NormalWeights& normalWeights) const;
    void addPull(PatchEquations& equations, const Patch& frame) const;
    void addNormals(PatchEquations& equations, const Patch& frame, const NormalWeights& weights) const;
    [[nodiscard]] Point stepAcross(std::size_t direction, std::size_t end, double along) const;
    [[nodiscard]] std::array<std::vector<double>, 2> leftBy(const Knots& knots) const;

    const PatchFitInput& input_;
    PatchSamples samples_;
    std::array<std::vector<double>, 2> normalAt_; ///< where normals are prescribed, along u and v
    OnBorder<std::vector<Prescribed>> prescribed_;
};

} // namespace qm
