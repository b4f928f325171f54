#include "bspline/solver/elimination_tree.h"

#include "base/at.h"

#include <suitesparse/amd.h>

#include <algorithm>
#include <cstddef>
#include <new>
#include <stdexcept>

namespace qm {
namespace {

/// Sets the parents and the number of entries in every column of the factor: row k has entries in the columns
/// on the paths from the row's entries in the matrix up to k.
void growTree(const Eigen::SparseMatrix<double>& upper, EliminationTree& tree) {
    const auto size = at(upper.cols());
    tree.parent.assign(size, EliminationTree::none);
    tree.entries.assign(size, 0);
    std::vector<int> seenAt(size, EliminationTree::none);
    for (int k = 0; k < static_cast<int>(size); ++k) {
        seenAt[at(k)] = k;
        for (Eigen::SparseMatrix<double>::InnerIterator it(upper, k); it; ++it)
            for (int i = static_cast<int>(it.row()); seenAt[at(i)] != k; i = tree.parent[at(i)]) {
                if (tree.parent[at(i)] == EliminationTree::none) tree.parent[at(i)] = k;
                ++tree.entries[at(i)];
                seenAt[at(i)] = k;
            }
    }
}

/// New numbers of the columns: each child directly before its parent, the child with the most entries last.
std::vector<int> postorder(const EliminationTree& tree) {
    const std::size_t size = tree.parent.size();
    std::vector<int> subtree(size, 1); // number of columns in the subtree
    std::vector<int> largest(size, EliminationTree::none);
    for (std::size_t k = 0; k < size; ++k) {
        if (tree.parent[k] == EliminationTree::none) continue;
        const std::size_t parent = at(tree.parent[k]);
        subtree[parent] += subtree[k];
        int& child = largest[parent];
        if (child == EliminationTree::none || tree.entries[k] >= tree.entries[at(child)])
            child = static_cast<int>(k);
    }
    // From the root down, every subtree gets a range of numbers; `begin` is the first number that is still
    // free.
    std::vector<int> number(size);
    std::vector<int> begin(size);
    int next = 0;
    for (std::size_t k = size; k-- > 0;) {
        const int parent = tree.parent[k];
        if (parent == EliminationTree::none) {
            begin[k] = next;
            next += subtree[k];
        } else if (largest[at(parent)] == static_cast<int>(k)) {
            begin[k] = number[at(parent)] - subtree[k];
        } else {
            begin[k] = begin[at(parent)];
            begin[at(parent)] += subtree[k];
        }
        number[k] = begin[k] + subtree[k] - 1;
    }
    return number;
}

Permutation minDegreeOrder(const Eigen::SparseMatrix<double>& lower) {
    Permutation order(lower.cols());
    order.setIdentity();
    if (lower.nonZeros() == 0) return order;
    // Its entries are the columns in the order of elimination.
    const int status = amd_order(static_cast<int>(lower.cols()), lower.outerIndexPtr(), lower.innerIndexPtr(),
                                 order.indices().data(), nullptr, nullptr);
    if (status == AMD_OUT_OF_MEMORY) throw std::bad_alloc();
    if (status == AMD_INVALID) throw std::invalid_argument("The matrix is not compressed");
    return order.inverse();
}

} // namespace

EliminationTree eliminationTree(const Eigen::SparseMatrix<double>& lower) {
    EliminationTree found;
    found.order = minDegreeOrder(lower);
    Eigen::SparseMatrix<double> upper(lower.rows(), lower.cols());
    upper.selfadjointView<Eigen::Upper>() = lower.selfadjointView<Eigen::Lower>().twistedBy(found.order);
    growTree(upper, found);

    const std::vector<int> number = postorder(found);
    EliminationTree tree;
    tree.order.resize(lower.rows());
    tree.parent.resize(number.size());
    tree.entries.resize(number.size());
    for (std::size_t k = 0; k < number.size(); ++k) {
        const int parent = found.parent[k];
        tree.parent[at(number[k])] = parent == EliminationTree::none ? parent : number[at(parent)];
        tree.entries[at(number[k])] = found.entries[k];
    }
    std::ranges::transform(found.order.indices(), tree.order.indices().begin(),
                           [&](int column) { return number[at(column)]; });
    return tree;
}

} // namespace qm
