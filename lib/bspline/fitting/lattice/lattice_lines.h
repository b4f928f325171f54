/// \file The lines of a lattice: how far single cubics follow them.
#pragma once

#include "bspline/fitting/lattice/fit_lattice.h"
#include "bspline/fitting/lattice/normal_limits.h"

#include <Eigen/Core>

#include <cstddef>
#include <map>

namespace qm {

/// The lines of a patch's lattice along u or v. The lattice must have the same number of steps in every quad.
class LatticeLines {
public:
    /// What is passed must outlive the lines.
    /// \param limits     of the normals
    /// \param direction  0 for lines along u, 1 for lines along v
    /// \param tolerance  how far a cubic may be away from its line
    LatticeLines(const FitLattice& lattice, const NormalLimits& limits, std::size_t direction,
                 double tolerance)
        : lattice_(lattice), limits_(limits), direction_(direction), tolerance_(tolerance) {}

    /// Number of quads along a line.
    [[nodiscard]] int length() const {
        return static_cast<int>(lattice_.targets.parameters[direction_].back());
    }

    [[nodiscard]] std::size_t count() const { return lattice_.targets.parameters[1 - direction_].size(); }

    /// Whether a single cubic follows every line between two grid lines, within the tolerance and the limits
    /// of the normals.
    [[nodiscard]] bool fit(int begin, int end);
    /// The same for one line.
    [[nodiscard]] bool fits(std::size_t line, int begin, int end);

private:
    [[nodiscard]] int steps() const {
        return static_cast<int>(lattice_.targets.parameters[direction_].size() - 1) / length();
    }
    [[nodiscard]] std::size_t index(std::size_t line, std::size_t along) const {
        return lattice_.onLine(direction_, line, along);
    }
    [[nodiscard]] bool isNear(std::size_t line, std::size_t begin, const Eigen::MatrixX4d& basis) const;

    const FitLattice& lattice_;
    const NormalLimits& limits_;
    std::size_t direction_;
    double tolerance_;
    std::map<Eigen::Index, Eigen::MatrixX4d> bases_; ///< by number of places
};

/// The farthest that a single cubic reaches, by doubling and bisection.
/// \param fits  (begin, end) whether a cubic follows the lattice between two grid lines
/// \return a grid line after `begin` and not after `length`
template <class Fits> int farthestReach(int begin, int length, const Fits& fits) {
    int reached = 1;
    int beyond = 2;
    while (begin + beyond <= length && fits(begin, begin + beyond)) {
        reached = beyond;
        beyond *= 2;
    }
    beyond = beyond < length - begin + 1 ? beyond : length - begin + 1;
    while (beyond - reached > 1) {
        const int middle = (reached + beyond) / 2;
        (fits(begin, begin + middle) ? reached : beyond) = middle;
    }
    return begin + reached;
}

} // namespace qm
