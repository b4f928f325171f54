#include "bspline/fitting/system/smooth_system.h"

#include "base/parallel.h"
#include "bspline/fitting/system/continuity_equations.h"
#include "bspline/splines/eigen_point.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace qm {
namespace {

Patch patchOf(const PatchSpace& space, std::size_t segment, const Eigen::MatrixX3d& solution) {
    Patch patch;
    patch.segment = SegmentId(segment);
    patch.knots = space.knots;
    patch.count = {static_cast<int>(space.count(0)), static_cast<int>(space.count(1))};
    patch.controlPoints.reserve(space.size());
    for (std::size_t k = 0; k < space.size(); ++k)
        patch.controlPoints.push_back(point(solution.row(eigenIndex(space.firstUnknown + k))));
    return patch;
}

/// Equations in free unknowns; the terms of patches that stay are constants.
struct FreeEquations {
    std::vector<LinearForm> forms;
    Eigen::MatrixX3d constants;
};

FreeEquations freeEquations(const std::vector<LinearForm>& equations, const FreeUnknowns& unknowns,
                            const std::vector<PatchSpace>& spaces, const std::vector<Patch>& patches) {
    std::vector<const Point*> points; // by unknown
    for (std::size_t patch = 0; patch < spaces.size(); ++patch)
        for (std::size_t k = 0; k < spaces[patch].size(); ++k)
            points.push_back(unknowns.isFree(points.size()) ? nullptr : &patches[patch].controlPoints[k]);
    FreeEquations result{{}, Eigen::MatrixX3d::Zero(eigenIndex(equations.size()), 3)};
    for (const LinearForm& equation : equations) {
        LinearForm form = unknowns.among(equation);
        if (form.unknowns.empty()) continue;
        auto constants = result.constants.row(eigenIndex(result.forms.size()));
        for (std::size_t k = 0; k < equation.unknowns.size(); ++k)
            if (const Point* fixed = points[equation.unknowns[k]])
                constants -= equation.weights[k] * vector(*fixed).transpose();
        result.forms.push_back(std::move(form));
    }
    result.constants.conservativeResize(eigenIndex(result.forms.size()), Eigen::NoChange);
    return result;
}

} // namespace

SmoothSystem::SmoothSystem(const KnotPlan& plan, const std::vector<PatchSpace>& spaces,
                           const std::vector<FitLattice>& lattices,
                           const std::vector<std::vector<ThinPlate>>& plates, const std::vector<bool>& isFree,
                           const std::vector<Patch>& patches, unsigned jobs)
    : jobs_(jobs) {
    const FreeUnknowns unknowns(spaces, isFree);
    for (std::size_t k = 0; k < spaces.size(); ++k) {
        if (!isFree[k]) continue;
        free_.push_back(k);
        spaces_.push_back(spaces[k]);
        spaces_.back().firstUnknown = unknowns.number(spaces[k].firstUnknown);
        for (const Point& point : lattices[k].reference)
            size_ = std::max(size_, point.max_abs());
    }
    std::vector<Eigen::SparseMatrix<double>> forms(free_.size());
    parallelFor(free_.size(), jobs, [&](std::size_t k) {
        forms[k] = patchForm(spaces_[k], lattices[free_[k]].targets, plates[free_[k]]);
    });
    FreeEquations equations =
        freeEquations(continuityEquations(plan, spaces, isFree), unknowns, spaces, patches);
    unknowns_ = eigenIndex(unknowns.count());
    system_.emplace(std::move(forms), std::move(equations.forms), equations.constants, jobs);
}

void SmoothSystem::solve(const std::vector<FitLattice>& lattices, Accuracy accuracy,
                         std::vector<Patch>& patches) {
    Eigen::MatrixX3d rightHandSide = Eigen::MatrixX3d::Zero(unknowns_, 3);
    parallelFor(free_.size(), jobs_, [&](std::size_t k) {
        addPatchTargets(spaces_[k], lattices[free_[k]].targets, rightHandSide);
    });
    system_->improve(rightHandSide, accuracy, solution_);
    for (std::size_t k = 0; k < free_.size(); ++k)
        patches[free_[k]] = patchOf(spaces_[k], free_[k], solution_);
}

bool SmoothSystem::holds() const {
    constexpr double rounding = 1e-11; // relative to the largest coordinate
    return unknowns_ == 0 || system_->violation(solution_) <= rounding * size_;
}

} // namespace qm
