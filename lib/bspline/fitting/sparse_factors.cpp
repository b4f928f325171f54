#include "bspline/fitting/sparse_factors.h"

#include "base/at.h"
#include "base/parallel.h"
#include "bspline/fitting/dense_elimination.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace qm {
namespace {

using Eigen::Index;

/// The matrix's entries in a supernode's columns, and zeros.
DenseFront loaded(const Eigen::SparseMatrix<double>& lower, const Supernode& supernode) {
    const auto size = static_cast<Index>(supernode.rows.size());
    DenseFront dense{Eigen::MatrixXd::Zero(supernode.height(), supernode.columns()),
                     Eigen::MatrixXd::Zero(size, size)};
    for (int column = supernode.begin; column < supernode.end; ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator it(lower, column); it; ++it) {
            const int row = static_cast<int>(it.row());
            const Index place = row < supernode.end
                                    ? row - supernode.begin
                                    : supernode.columns() + (std::ranges::lower_bound(supernode.rows, row) -
                                                             supernode.rows.begin());
            dense.columns(place, column - supernode.begin) += it.value();
        }
    return dense;
}

/// Adds the Schur complement that a child leaves.
void add(const Supernode& child, const Eigen::MatrixXd& complement, DenseFront& dense) {
    const Index columns = dense.columns.cols();
    for (Index j = 0; j < complement.cols(); ++j) {
        const Index column = child.inParent[at(j)];
        auto target = column < columns ? dense.columns.col(column) : dense.rest.col(column - columns);
        const Index shift = column < columns ? 0 : columns;
        for (Index i = j; i < complement.rows(); ++i)
            target[child.inParent[at(i)] - shift] += complement(i, j);
    }
}

} // namespace

SparseFactors::SparseFactors(const Eigen::SparseMatrix<double>& lower, unsigned jobs) : jobs_(jobs) {
    const EliminationTree tree = eliminationTree(lower);
    order_ = tree.order;
    Eigen::SparseMatrix<double> ordered(lower.rows(), lower.cols());
    ordered.selfadjointView<Eigen::Lower>() = lower.selfadjointView<Eigen::Lower>().twistedBy(order_);
    plan_ = planSupernodes(tree, ordered);
    columns_.resize(plan_.nodes.size());
    std::vector<Eigen::MatrixXd> complements(plan_.nodes.size());
    const auto eliminate = [&](int number, unsigned threads) {
        const Supernode& supernode = plan_.nodes[at(number)];
        DenseFront dense = loaded(ordered, supernode);
        for (const int child : supernode.children) {
            add(plan_.nodes[at(child)], complements[at(child)], dense);
            complements[at(child)].resize(0, 0);
        }
        eliminateColumns(dense, threads);
        columns_[at(number)] = std::move(dense.columns);
        complements[at(number)] = std::move(dense.rest);
    };
    parallelFor(plan_.parts.size() - 1, jobs_, [&](std::size_t part) {
        for (const int supernode : plan_.parts[part])
            eliminate(supernode, 1);
    });
    for (const int supernode : plan_.parts.back())
        eliminate(supernode, jobs_);
}

/// \param passedOn  by supernode: what its columns take from its rows on the right-hand side
void SparseFactors::forward(std::size_t number, Eigen::MatrixX3d& x,
                            std::vector<Eigen::MatrixX3d>& passedOn) const {
    const Supernode& supernode = plan_.nodes[number];
    const Eigen::MatrixXd& columns = columns_[number];
    Eigen::MatrixX3d own = Eigen::MatrixX3d::Zero(supernode.height(), 3);
    own.topRows(supernode.columns()) = x.middleRows(supernode.begin, supernode.columns());
    for (const int child : supernode.children) {
        Eigen::MatrixX3d& sums = passedOn[at(child)];
        for (Index row = 0; row < sums.rows(); ++row)
            own.row(plan_.nodes[at(child)].inParent[at(row)]) += sums.row(row);
        sums.resize(0, 3);
    }
    const Index width = columns.cols();
    const Index below = columns.rows() - width;
    // One by one: products of matrices as narrow as three columns would copy the factors first.
    for (Index k = 0; k < 3; ++k) {
        auto top = own.col(k).head(width);
        columns.topRows(width).triangularView<Eigen::UnitLower>().solveInPlace(top);
        own.col(k).tail(below).noalias() -= columns.bottomRows(below) * top;
    }
    x.middleRows(supernode.begin, supernode.columns()) = own.topRows(supernode.columns());
    passedOn[number] = own.bottomRows(own.rows() - supernode.columns());
}

void SparseFactors::backward(std::size_t number, Eigen::MatrixX3d& x) const {
    const Supernode& supernode = plan_.nodes[number];
    const Eigen::MatrixXd& columns = columns_[number];
    Eigen::MatrixX3d own(supernode.height(), 3);
    own.topRows(supernode.columns()) =
        columns.diagonal().cwiseInverse().asDiagonal() * x.middleRows(supernode.begin, supernode.columns());
    for (std::size_t k = 0; k < supernode.rows.size(); ++k)
        own.row(supernode.columns() + static_cast<Index>(k)) = x.row(supernode.rows[k]);
    const Index width = columns.cols();
    const Index below = columns.rows() - width;
    for (Index k = 0; k < 3; ++k) {
        auto top = own.col(k).head(width);
        top.noalias() -= columns.bottomRows(below).transpose() * own.col(k).tail(below);
        columns.topRows(width).transpose().triangularView<Eigen::UnitUpper>().solveInPlace(top);
    }
    x.middleRows(supernode.begin, supernode.columns()) = own.topRows(supernode.columns());
}

Eigen::MatrixX3d SparseFactors::solve(const Eigen::MatrixX3d& rightHandSide) const {
    const std::size_t rest = plan_.parts.size() - 1;
    Eigen::MatrixX3d x = order_ * rightHandSide;
    std::vector<Eigen::MatrixX3d> passedOn(plan_.nodes.size());
    const auto goUp = [&](std::size_t part) {
        for (const int supernode : plan_.parts[part])
            forward(at(supernode), x, passedOn);
    };
    const auto goDown = [&](std::size_t part) {
        const std::vector<int>& supernodes = plan_.parts[part];
        for (std::size_t k = supernodes.size(); k-- > 0;)
            backward(at(supernodes[k]), x);
    };
    parallelFor(rest, jobs_, goUp);
    goUp(rest);
    goDown(rest);
    parallelFor(rest, jobs_, goDown);
    return order_.inverse() * x;
}

} // namespace qm
