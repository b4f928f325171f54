#include "bspline/reference/bending/bending_equations.h"

#include "base/at.h"
#include "base/parallel.h"
#include "bspline/splines/eigen_point.h"

#include <Eigen/LU>

#include <numeric>
#include <span>
#include <utility>

namespace qm {
namespace {

using Values = Eigen::VectorXd; // three a vertex

Eigen::Index row(std::size_t vertexOrCorner) {
    return eigenIndex(3 * vertexOrCorner);
}

/// A corner of a quad.
struct TermCorner {
    std::size_t term;
    std::size_t corner;
};

/// The equations of all vertices, each of which sums up what its own corners contribute, on several threads.
class Equations {
public:
    Equations(const std::vector<BendingTerm>& terms, std::size_t vertices, unsigned jobs)
        : terms_(terms), jobs_(jobs), firstCorner_(vertices + 1), corners_(4 * terms.size()),
          products_(terms.size()), inverse_(vertices) {
        for (const BendingTerm& term : terms)
            for (const VertexId vertex : term.vertices())
                ++firstCorner_[at(vertex) + 1];
        std::partial_sum(firstCorner_.begin(), firstCorner_.end(), firstCorner_.begin());
        std::vector<std::size_t> next(firstCorner_.begin(), firstCorner_.end() - 1);
        for (std::size_t term = 0; term < terms.size(); ++term)
            for (std::size_t corner = 0; corner < 4; ++corner)
                corners_[next[at(terms[term].vertices()[corner])]++] = {term, corner};
        parallelForMany(vertices, jobs_, [&](std::size_t vertex) { inverse_[vertex] = inverse(vertex); });
    }

    [[nodiscard]] Values rightHandSide() const {
        return sums([&](const TermCorner& place) -> Eigen::Vector3d {
            return terms_[place.term].right().segment<3>(row(place.corner));
        });
    }

    /// The left-hand side.
    [[nodiscard]] Values operator()(const Values& tilts) {
        parallelForMany(terms_.size(), jobs_, [&](std::size_t term) {
            CornerTilts ofTerm;
            for (std::size_t corner = 0; corner < 4; ++corner)
                ofTerm.segment<3>(row(corner)) = tilts.segment<3>(row(at(terms_[term].vertices()[corner])));
            products_[term] = terms_[term].matrix() * ofTerm;
        });
        return sums([&](const TermCorner& place) -> Eigen::Vector3d {
            return products_[place.term].segment<3>(row(place.corner));
        });
    }

    /// What every vertex's own equations alone would ask for; zero where there are none.
    [[nodiscard]] Values guess(const Values& right) const {
        Values result(right.size());
        parallelForMany(inverse_.size(), jobs_, [&](std::size_t vertex) {
            result.segment<3>(row(vertex)) = inverse_[vertex] * right.segment<3>(row(vertex));
        });
        return result;
    }

private:
    [[nodiscard]] std::span<const TermCorner> cornersOf(std::size_t vertex) const {
        return std::span(corners_).subspan(firstCorner_[vertex],
                                           firstCorner_[vertex + 1] - firstCorner_[vertex]);
    }

    /// By vertex, of a vector of every corner.
    template <class Summand> [[nodiscard]] Values sums(const Summand& summand) const {
        Values result(row(inverse_.size()));
        parallelForMany(inverse_.size(), jobs_, [&](std::size_t vertex) {
            Eigen::Vector3d sum = Eigen::Vector3d::Zero();
            for (const TermCorner& place : cornersOf(vertex))
                sum += summand(place);
            result.segment<3>(row(vertex)) = sum;
        });
        return result;
    }

    [[nodiscard]] Eigen::Matrix3d inverse(std::size_t vertex) const {
        constexpr double singular = 1e-12;
        Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
        for (const TermCorner& place : cornersOf(vertex))
            block += terms_[place.term].matrix().block<3, 3>(row(place.corner), row(place.corner));
        if (block(2, 2) == 0) block(2, 2) = 1; // no twist
        // Slopes and twists have different units.
        const double product = block.diagonal().prod();
        const bool isRegular = product > 0 && block.determinant() > singular * product;
        return isRegular ? Eigen::Matrix3d(block.inverse()) : Eigen::Matrix3d::Zero();
    }

    const std::vector<BendingTerm>& terms_;
    unsigned jobs_;
    std::vector<std::size_t> firstCorner_; ///< by vertex, in `corners_`
    std::vector<TermCorner> corners_;      ///< vertex by vertex
    std::vector<CornerTilts> products_;    ///< scratch, by term
    std::vector<Eigen::Matrix3d> inverse_; ///< by vertex, of its own equations
};

} // namespace

BendingTerm::BendingTerm(const std::array<VertexId, 4>& vertices, const QuadBending& bending)
    : vertices_(vertices), right_(bending.right.cast<float>()) {
    auto next = upper_.begin();
    for (Eigen::Index i = 0; i < 12; ++i)
        for (Eigen::Index j = i; j < 12; ++j)
            *next++ = static_cast<float>(bending.matrix(i, j));
}

Eigen::Matrix<double, 12, 12> BendingTerm::matrix() const {
    Eigen::Matrix<double, 12, 12> matrix;
    auto next = upper_.begin();
    for (Eigen::Index i = 0; i < 12; ++i)
        for (Eigen::Index j = i; j < 12; ++j)
            matrix(i, j) = matrix(j, i) = *next++;
    return matrix;
}

std::vector<Eigen::Vector3d> minBendingTilts(const std::vector<BendingTerm>& terms, std::size_t vertices,
                                             unsigned jobs) {
    constexpr double accuracy = 1e-6;
    constexpr int maxRounds = 100; // ten times what real meshes take
    Equations equations(terms, vertices, jobs);
    Values residual = equations.rightHandSide();
    Values tilts = Values::Zero(residual.size());
    Values direction = equations.guess(residual);
    double size = residual.dot(direction);
    const double enough = accuracy * accuracy * size;
    for (int k = 0; k < maxRounds && size > enough; ++k) {
        const Values change = equations(direction);
        const double step = size / direction.dot(change);
        tilts += step * direction;
        residual -= step * change;
        const Values towards = equations.guess(residual);
        const double before = std::exchange(size, residual.dot(towards));
        direction = towards + size / before * direction;
    }
    std::vector<Eigen::Vector3d> result;
    result.reserve(vertices);
    for (std::size_t vertex = 0; vertex < vertices; ++vertex)
        result.emplace_back(tilts.segment<3>(row(vertex)));
    return result;
}

} // namespace qm
