#include "bspline/fitting/smooth_system.h"

#include "base/parallel.h"
#include "bspline/fitting/continuity_equations.h"
#include "bspline/splines/eigen_point.h"

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
        patch.controlPoints.push_back(point(solution.row(static_cast<Eigen::Index>(space.firstUnknown + k))));
    return patch;
}

} // namespace

SmoothSystem::SmoothSystem(const Layout& layout, const SmoothNetwork& network, std::vector<PatchSpace> spaces,
                           const std::vector<FitLattice>& lattices, double bending, unsigned jobs)
    : spaces_(std::move(spaces)), jobs_(jobs) {
    std::vector<std::vector<Eigen::Triplet<double>>> entries(spaces_.size());
    parallelFor(spaces_.size(), jobs,
                [&](std::size_t k) { addPatchForm(spaces_[k], lattices[k].targets, bending, entries[k]); });
    std::vector<Eigen::Triplet<double>> all;
    for (auto& ofPatch : entries) {
        all.insert(all.end(), ofPatch.begin(), ofPatch.end());
        ofPatch = {};
    }
    system_.emplace(unknownsOf(spaces_), all, continuityEquations(layout, network, spaces_));
}

std::vector<Patch> SmoothSystem::solve(const std::vector<FitLattice>& lattices, Accuracy accuracy) {
    Eigen::MatrixX3d rightHandSide =
        Eigen::MatrixX3d::Zero(static_cast<Eigen::Index>(unknownsOf(spaces_)), 3);
    parallelFor(spaces_.size(), jobs_,
                [&](std::size_t k) { addPatchTargets(spaces_[k], lattices[k].targets, rightHandSide); });
    system_->improve(rightHandSide, accuracy, solution_);
    std::vector<Patch> patches;
    for (std::size_t k = 0; k < spaces_.size(); ++k)
        patches.push_back(patchOf(spaces_[k], k, solution_));
    return patches;
}

} // namespace qm
