#include "bspline/reference/bending/bending_equations.h"

#include "base/at.h"
#include "base/parallel.h"
#include "bspline/splines/eigen_point.h"

#include <Eigen/LU>

#include <utility>

namespace qm {
namespace {

using Values = Eigen::VectorXd; // three a vertex

Eigen::Index row(int vertexOrCorner) {
    return Eigen::Index{3} * vertexOrCorner;
}

void add(const std::array<VertexId, 4>& vertices, const CornerTilts& what, Values& to) {
    for (int corner = 0; corner < 4; ++corner)
        to.segment<3>(row(vertices[at(corner)].idx())) += what.segment<3>(row(corner));
}

Values rightHandSide(const std::vector<BendingTerm>& terms, Eigen::Index size) {
    Values sum = Values::Zero(size);
    for (const BendingTerm& term : terms)
        add(term.vertices(), term.right(), sum);
    return sum;
}

/// \param products  scratch, by term
Values product(const std::vector<BendingTerm>& terms, const Values& tilts, std::vector<CornerTilts>& products,
               unsigned jobs) {
    parallelForMany(terms.size(), jobs, [&](std::size_t k) {
        CornerTilts ofTerm;
        for (int corner = 0; corner < 4; ++corner)
            ofTerm.segment<3>(row(corner)) = tilts.segment<3>(row(terms[k].vertices()[at(corner)].idx()));
        products[k] = terms[k].matrix() * ofTerm;
    });
    Values sum = Values::Zero(tilts.size());
    for (std::size_t k = 0; k < terms.size(); ++k)
        add(terms[k].vertices(), products[k], sum);
    return sum;
}

/// The inverse of every vertex's own equations; zero where there are none.
class Preconditioner {
public:
    Preconditioner(const std::vector<BendingTerm>& terms, std::size_t vertices)
        : inverse_(vertices, Eigen::Matrix3d::Zero()) {
        constexpr double singular = 1e-12;
        for (const BendingTerm& term : terms) {
            const auto matrix = term.matrix();
            for (int corner = 0; corner < 4; ++corner)
                inverse_[at(term.vertices()[at(corner)])] += matrix.block<3, 3>(row(corner), row(corner));
        }
        for (Eigen::Matrix3d& block : inverse_) {
            if (block(2, 2) == 0) block(2, 2) = 1; // no twist
            // Slopes and twists have different units.
            const double product = block.diagonal().prod();
            const bool isRegular = product > 0 && block.determinant() > singular * product;
            block = isRegular ? Eigen::Matrix3d(block.inverse()) : Eigen::Matrix3d::Zero();
        }
    }

    [[nodiscard]] Values operator*(const Values& values) const {
        Values result(values.size());
        for (int vertex = 0; vertex < std::ssize(inverse_); ++vertex)
            result.segment<3>(row(vertex)) = inverse_[at(vertex)] * values.segment<3>(row(vertex));
        return result;
    }

private:
    std::vector<Eigen::Matrix3d> inverse_;
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
    const Preconditioner preconditioner(terms, vertices);
    Values residual = rightHandSide(terms, eigenIndex(3 * vertices));
    Values tilts = Values::Zero(residual.size());
    Values direction = preconditioner * residual;
    double size = residual.dot(direction);
    const double enough = accuracy * accuracy * size;
    std::vector<CornerTilts> products(terms.size());
    for (int k = 0; k < maxRounds && size > enough; ++k) {
        const Values change = product(terms, direction, products, jobs);
        const double step = size / direction.dot(change);
        tilts += step * direction;
        residual -= step * change;
        const Values towards = preconditioner * residual;
        const double before = std::exchange(size, residual.dot(towards));
        direction = towards + size / before * direction;
    }
    std::vector<Eigen::Vector3d> result;
    result.reserve(vertices);
    for (int vertex = 0; vertex < static_cast<int>(vertices); ++vertex)
        result.emplace_back(tilts.segment<3>(row(vertex)));
    return result;
}

} // namespace qm
