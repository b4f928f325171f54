#include "bspline/solver/sparse_factors.h"

#include "base/at.h"
#include "base/parallel.h"
#include "bspline/solver/dense_elimination.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

namespace qm {
namespace {

using Eigen::Index;

/// A front with the matrix's entries in a supernode's columns, zero elsewhere.
DenseFront loaded(const Eigen::SparseMatrix<double>& lower, const Supernode& supernode,
                  std::span<const int> rows) {
    const auto size = static_cast<Index>(rows.size());
    DenseFront dense{Eigen::MatrixXd::Zero(supernode.height(), supernode.columns()),
                     Eigen::MatrixXd::Zero(size, size)};
    for (int column = supernode.begin; column < supernode.end; ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator it(lower, column); it; ++it) {
            const int row = static_cast<int>(it.row());
            const Index place =
                row < supernode.end
                    ? row - supernode.begin
                    : supernode.columns() + (std::ranges::lower_bound(rows, row) - rows.begin());
            dense.columns(place, column - supernode.begin) += it.value();
        }
    return dense;
}

/// Adds the Schur complement of a child.
/// \param places  by row of the complement: its row in the front
void add(std::span<const int> places, const Eigen::MatrixXd& complement, DenseFront& dense) {
    const Index columns = dense.columns.cols();
    for (Index j = 0; j < complement.cols(); ++j) {
        const Index column = places[at(j)];
        auto target = column < columns ? dense.columns.col(column) : dense.rest.col(column - columns);
        const Index shift = column < columns ? 0 : columns;
        for (Index i = j; i < complement.rows(); ++i)
            target[places[at(i)] - shift] += complement(i, j);
    }
}

} // namespace

SparseFactors::SparseFactors(const Eigen::SparseMatrix<double>& lower, unsigned jobs) : jobs_(jobs) {
    const EliminationTree tree = eliminationTree(lower);
    order_ = tree.order;
    Eigen::SparseMatrix<double> ordered(lower.rows(), lower.cols());
    ordered.selfadjointView<Eigen::Lower>() = lower.selfadjointView<Eigen::Lower>().twistedBy(order_);
    plan_ = planSupernodes(tree, ordered);
    starts_.assign(1, 0);
    for (const Supernode& node : plan_.nodes) {
        starts_.push_back(starts_.back() + at(node.height()) * at(node.columns()));
        maxHeight_ = std::max<Index>(maxHeight_, node.height());
    }
    values_.resize(static_cast<Index>(starts_.back()));
    std::vector<Eigen::MatrixXd> complements(plan_.nodes.size());
    const auto eliminate = [&](int number, unsigned threads) {
        const Supernode& supernode = plan_.nodes[at(number)];
        DenseFront dense = loaded(ordered, supernode, plan_.rowsOf(supernode));
        for (const int child : supernode.children) {
            add(plan_.placesOf(plan_.nodes[at(child)]), complements[at(child)], dense);
            complements[at(child)].resize(0, 0);
        }
        eliminateColumns(dense, threads);
        values_.segment(static_cast<Index>(starts_[at(number)]), dense.columns.size()) =
            dense.columns.reshaped();
        complements[at(number)] = std::move(dense.rest);
    };
    parallelFor(plan_.parts.size() - 1, jobs_, [&](std::size_t part) {
        for (const int supernode : plan_.parts[part])
            eliminate(supernode, 1);
    });
    for (const int supernode : plan_.parts.back())
        eliminate(supernode, jobs_);
}

/// Forward substitution with the columns of one supernode.
/// \param own       scratch, at least as high as the supernode
/// \param passedOn  by supernode: what its columns subtract from its rows, one after another
void SparseFactors::forward(std::size_t number, Rows& x, Columns& own, Rows& passedOn) const {
    const Supernode& supernode = plan_.nodes[number];
    const auto columns = columnsOf(number);
    const Index width = columns.cols();
    const Index height = columns.rows();
    own.topRows(width) = x.middleRows(supernode.begin, width);
    own.middleRows(width, height - width).setZero();
    for (const int child : supernode.children) {
        Index row = plan_.nodes[at(child)].firstRow;
        for (const int place : plan_.placesOf(plan_.nodes[at(child)]))
            own.row(place) += passedOn.row(row++);
    }
    for (Index k = 0; k < width; ++k)
        for (Index i = 0; i < 3; ++i)
            own.col(i).segment(k + 1, height - k - 1) -= columns.col(k).tail(height - k - 1) * own(k, i);
    x.middleRows(supernode.begin, width) = own.topRows(width);
    passedOn.middleRows(supernode.firstRow, height - width) = own.middleRows(width, height - width);
}

void SparseFactors::backward(std::size_t number, Rows& x, Columns& own) const {
    const Supernode& supernode = plan_.nodes[number];
    const auto columns = columnsOf(number);
    const Index width = columns.cols();
    const Index height = columns.rows();
    Index next = width;
    for (const int row : plan_.rowsOf(supernode))
        own.row(next++) = x.row(row);
    for (Index k = width; k-- > 0;)
        for (Index i = 0; i < 3; ++i)
            own(k, i) = x(supernode.begin + k, i) / columns(k, k) -
                        columns.col(k).tail(height - k - 1).dot(own.col(i).segment(k + 1, height - k - 1));
    x.middleRows(supernode.begin, width) = own.topRows(width);
}

Eigen::MatrixX3d SparseFactors::solve(const Eigen::MatrixX3d& rightHandSide) const {
    const std::size_t rest = plan_.parts.size() - 1;
    Rows x = order_ * rightHandSide;
    Rows passedOn(static_cast<Index>(plan_.rows.size()), 3);
    const auto goUp = [&](std::size_t part) {
        Columns own(maxHeight_, 3);
        for (const int supernode : plan_.parts[part])
            forward(at(supernode), x, own, passedOn);
    };
    const auto goDown = [&](std::size_t part) {
        Columns own(maxHeight_, 3);
        const std::vector<int>& supernodes = plan_.parts[part];
        for (std::size_t k = supernodes.size(); k-- > 0;)
            backward(at(supernodes[k]), x, own);
    };
    parallelFor(rest, jobs_, goUp);
    goUp(rest);
    goDown(rest);
    parallelFor(rest, jobs_, goDown);
    return order_.inverse() * Eigen::MatrixX3d(x);
}

} // namespace qm
