/// \file Symmetric matrices whose rows have few entries left of the diagonal, factorised without fill.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace qm {

/// L D L^T of a symmetric matrix, row by row from its first entry to the diagonal: the rows of L reach no
/// further. Without pivoting, so the matrix has to be definite, or quasi-definite: positive definite on some
/// unknowns, negative definite on the others, in any order.
class ProfileFactor {
public:
    /// A matrix of zeros. \param first  the first column of every row, not beyond the diagonal
    explicit ProfileFactor(std::vector<std::size_t> first);

    /// The entry in a row and a column from the row's first to its diagonal; until `factorise`.
    [[nodiscard]] double& at(std::size_t row, std::size_t column) {
        return entries_[begin_[row] + column - first_[row]];
    }
    void factorise();
    [[nodiscard]] Eigen::VectorXd solve(Eigen::VectorXd right) const;

private:
    using Row = Eigen::Map<const Eigen::VectorXd>;
    [[nodiscard]] Row part(std::size_t row, std::size_t from, std::size_t to) const {
        return {entries_.data() + begin_[row] + from - first_[row], static_cast<Eigen::Index>(to - from)};
    }

    std::vector<std::size_t> first_;
    std::vector<std::size_t> begin_; ///< of every row among the entries
    std::vector<double> entries_;
};

} // namespace qm
