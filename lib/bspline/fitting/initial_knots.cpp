#include "bspline/fitting/initial_knots.h"

#include "base/at.h"
#include "bspline/fitting/lattice_errors.h"
#include "bspline/splines/eigen_point.h"

#include <algorithm>
#include <map>

namespace qm {
namespace {

/// How much an offset counts that only slides along the reference: the fit may let it, but not far.
constexpr double ofSlides = 0.3;

/// Orthonormal polynomials up to degree 3 over equally spaced places.
Eigen::MatrixX4d orthonormalCubics(Eigen::Index places) {
    Eigen::MatrixX4d basis(places, 4);
    for (Eigen::Index i = 0; i < places; ++i) {
        const double x = 2.0 * static_cast<double>(i) / static_cast<double>(places - 1) - 1;
        basis.row(i) << 1, x, x * x, x * x * x;
    }
    for (Eigen::Index k = 0; k < 4; ++k) {
        for (Eigen::Index before = 0; before < k; ++before)
            basis.col(k) -= basis.col(before).dot(basis.col(k)) * basis.col(before);
        basis.col(k).normalize();
    }
    return basis;
}

/// The lines of a patch's lattice along u or v.
class Lines {
public:
    Lines(const FitLattice& lattice, const NormalLimits& limits, std::size_t direction, double tolerance)
        : lattice_(lattice), limits_(limits), direction_(direction), tolerance_(tolerance) {}

    [[nodiscard]] int length() const {
        return static_cast<int>(lattice_.targets.parameters[direction_].back());
    }

    /// Of the lattice, a quad.
    [[nodiscard]] int steps() const {
        return static_cast<int>(lattice_.targets.parameters[direction_].size() - 1) / length();
    }

    /// Is a cubic near every line between two grid lines?
    [[nodiscard]] bool fits(int begin, int end) {
        const Eigen::Index places = Eigen::Index{end - begin} * steps() + 1;
        constexpr Eigen::Index coefficients = 4;
        if (places <= coefficients) return true;
        auto [found, isNew] = bases_.try_emplace(places);
        if (isNew) found->second = orthonormalCubics(places);
        const std::size_t lines = lattice_.targets.parameters[1 - direction_].size();
        for (std::size_t line = 0; line < lines; ++line)
            if (!isNear(line, at(begin) * at(steps()), found->second)) return false;
        return true;
    }

private:
    [[nodiscard]] std::size_t index(std::size_t line, std::size_t along) const {
        return direction_ == 0 ? line * lattice_.columns() + along : along * lattice_.columns() + line;
    }

    /// In distance, and in the direction of its normal.
    [[nodiscard]] bool isNear(std::size_t line, std::size_t begin, const Eigen::MatrixX4d& basis) const {
        Eigen::MatrixX3d points(basis.rows(), 3);
        for (Eigen::Index i = 0; i < basis.rows(); ++i)
            points.row(i) = vector(lattice_.reference[index(line, begin + static_cast<std::size_t>(i))]);
        points -= basis * (basis.transpose() * points).eval();
        for (Eigen::Index i = 0; i < basis.rows(); ++i) {
            const std::size_t at = index(line, begin + static_cast<std::size_t>(i));
            const double off = distance(lattice_, at, point(points.row(i)));
            if (std::max(off, ofSlides * points.row(i).norm()) > tolerance_) return false;
            if (i == 0 || lattice_.freedom[at] != Freedom::surface) continue;
            const Point before = lattice_.reference[index(line, begin + static_cast<std::size_t>(i) - 1)];
            const double rise = distance(lattice_, at, point(points.row(i) - points.row(i - 1)));
            const double run = (lattice_.reference[at] - before).norm();
            if (rise > limits_.at(direction_, lattice_.parametersAt(at)) * run) return false;
        }
        return true;
    }

    const FitLattice& lattice_;
    const NormalLimits& limits_;
    std::size_t direction_;
    double tolerance_;
    std::map<Eigen::Index, Eigen::MatrixX4d> bases_;
};

/// The farthest grid line that one cubic reaches from another, by doubling and bisection.
int farthest(Lines& lines, int begin) {
    int reached = 1;
    int beyond = 2;
    while (begin + beyond <= lines.length() && lines.fits(begin, begin + beyond)) {
        reached = beyond;
        beyond *= 2;
    }
    beyond = std::min(beyond, lines.length() - begin + 1);
    while (beyond - reached > 1) {
        const int middle = (reached + beyond) / 2;
        (lines.fits(begin, begin + middle) ? reached : beyond) = middle;
    }
    return begin + reached;
}

} // namespace

std::vector<double> knotsBeside(const Layout& layout, const StretchMap& map, const KnotPlan& plan,
                                std::size_t patch, std::size_t direction) {
    std::vector<double> knots;
    const auto& stretches = plan.network().stretches;
    for (const int side : {static_cast<int>(direction), static_cast<int>(direction) + 2})
        for (const StretchEnd& end : map.on(patch, side)) {
            const Stretch& stretch = stretches[end.stretch];
            const StretchSide& other = stretch.sides[1 - end.which];
            for (const double knot : plan.chosen(other.patch, directionAlong(other.side))) {
                const double x = stretchParameter(layout.segments[other.patch].size, other, knot);
                if (x > 0 && x < stretch.length())
                    knots.push_back(patchParameter(layout.segments[patch].size, stretch.sides[end.which], x));
            }
        }
    std::ranges::sort(knots);
    return knots;
}

void insertInitialKnots(const Layout& layout, const std::vector<FitLattice>& lattices,
                        const std::vector<NormalLimits>& limits, const StretchMap& map, double tolerance,
                        KnotPlan& plan) {
    constexpr double notMuchNearer = 0.5;
    for (std::size_t patch = 0; patch < lattices.size(); ++patch)
        for (std::size_t direction = 0; direction < 2; ++direction) {
            Lines lines(lattices[patch], limits[patch], direction, tolerance);
            const auto beside = knotsBeside(layout, map, plan, patch, direction);
            int begin = 0;
            while (begin < lines.length()) {
                int end = farthest(lines, begin);
                const double min = std::max(begin + notMuchNearer * (end - begin), begin + 1.0);
                const auto after = std::ranges::upper_bound(beside, static_cast<double>(end));
                if (end < lines.length() && after != beside.begin() && *(after - 1) >= min)
                    end = static_cast<int>(*(after - 1));
                plan.insert(patch, direction, end);
                begin = end;
            }
        }
}

} // namespace qm
