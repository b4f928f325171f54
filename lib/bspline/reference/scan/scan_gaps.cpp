#include "bspline/reference/scan/scan_gaps.h"

#include "base/grid_neighbours.h"
#include "bspline/splines/eigen_point.h"

#include <Eigen/IterativeLinearSolvers>

#include <cstddef>
#include <limits>

namespace qm {
namespace {

constexpr double enough = 0.5;        ///< what weighs as much is a target
constexpr double weightInGaps = 0.25; ///< of what is only guessed

class Filling {
public:
    Filling(const LatticeNormals& lattice, const std::vector<ReferenceGrid>& surface, Gaps gaps,
            FitTarget& reference)
        : lattice_(lattice), surface_(surface), gaps_(gaps), reference_(reference),
          unknowns_(lattice.points.size(), none) {
        lattice_.forEachPoint([&](std::size_t g, std::size_t k, std::size_t number) {
            if (isLeft(number) || reference_.weights[g][k] >= enough) return;
            if (unknowns_[number] == none) unknowns_[number] = count_++;
        });
    }

    void fill() {
        if (count_ == 0) return;
        const Eigen::MatrixX3d displacements = solve();
        lattice_.forEachPoint([&](std::size_t g, std::size_t k, std::size_t number) {
            if (unknowns_[number] == none) return;
            const Eigen::Vector3d moved = displacements.row(eigenIndex(unknowns_[number]));
            reference_.grids[g].points[k] = surface_[g].points[k] + point(moved);
            reference_.weights[g][k] = weightInGaps;
        });
    }

private:
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

    [[nodiscard]] bool isLeft(std::size_t number) const {
        return gaps_ == Gaps::butForSharpOnes && lattice_.sharp[number];
    }

    [[nodiscard]] Eigen::MatrixX3d solve() const {
        // Keeps the equations solvable where no target is near, and stays there at the surface.
        constexpr double pull = 1e-9;
        constexpr double accuracy = 1e-6;
        const auto size = eigenIndex(count_);
        std::vector<Eigen::Triplet<double>> entries;
        Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(size, 3);
        for (Eigen::Index i = 0; i < size; ++i)
            entries.emplace_back(i, i, pull);
        const auto add = [&](std::size_t g, std::size_t own, std::size_t other) {
            const std::size_t i = unknowns_[lattice_.numbers[g][own]];
            const std::size_t j = unknowns_[lattice_.numbers[g][other]];
            if (i == none || isLeft(lattice_.numbers[g][other])) return;
            const auto row = eigenIndex(i);
            entries.emplace_back(row, row, 1);
            if (j == none)
                right.row(row) += vector(reference_.grids[g].points[other] - surface_[g].points[other]);
            else
                entries.emplace_back(row, eigenIndex(j), -1);
        };
        // Those on common borders come twice, once from either side.
        for (std::size_t g = 0; g < surface_.size(); ++g)
            forGridNeighbours(surface_[g].columns(), surface_[g].points.size(),
                              [&](std::size_t a, std::size_t b) {
                                  add(g, a, b);
                                  add(g, b, a);
                              });
        Eigen::SparseMatrix<double> matrix(size, size);
        matrix.setFromTriplets(entries.begin(), entries.end());
        Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver(matrix);
        solver.setTolerance(accuracy);
        return solver.solve(right);
    }

    const LatticeNormals& lattice_;
    const std::vector<ReferenceGrid>& surface_;
    Gaps gaps_;
    FitTarget& reference_;
    std::vector<std::size_t> unknowns_; ///< by lattice point
    std::size_t count_ = 0;
};

} // namespace

void fillGaps(const LatticeNormals& lattice, const std::vector<ReferenceGrid>& surface, Gaps gaps,
              FitTarget& reference) {
    Filling(lattice, surface, gaps, reference).fill();
}

} // namespace qm
