#include "bspline/solver/supernodes.h"

#include "base/at.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>

namespace qm {
namespace {

/// A part has at most this share of the work: small enough to occupy several threads, and large enough to
/// leave little for the top of the tree.
constexpr double maxShare = 0.2;

/// The columns of a growing supernode.
struct Run {
    int begin;
    int end;
    double entries; ///< number of the factor's entries in its columns, diagonal included
};

/// Dense kernels are fast enough to pay for some zeros, the more so the smaller a supernode is
/// (docs/METHOD.md#ashcraft-1989).
bool isWorthZeros(double columns, double shareOfZeros) {
    struct Limit {
        double columns;
        double share;
    };
    constexpr std::array limits{Limit{4, 0.5}, Limit{16, 0.3}, Limit{48, 0.1}};
    for (const auto& [maxColumns, maxZeros] : limits)
        if (columns <= maxColumns) return shareOfZeros <= maxZeros;
    return shareOfZeros <= 0.05;
}

/// Joins columns that have the same rows, then each run to its last child as long as that is worth its zeros.
std::vector<Run> mergedColumns(const EliminationTree& tree) {
    const auto rowsBelow = [&](const Run& run) { return tree.entries[at(run.end - 1)]; };
    std::vector<Run> runs;
    const int size = static_cast<int>(tree.parent.size());
    for (int begin = 0, end = 0; begin < size; begin = end) {
        Run run{begin, begin, 0};
        do {
            run.entries += 1 + tree.entries[at(end)];
            run.end = ++end;
        } while (end < size && tree.parent[at(end - 1)] == end &&
                 tree.entries[at(end - 1)] == tree.entries[at(end)] + 1);
        while (!runs.empty()) {
            const Run& child = runs.back();
            const int parent = tree.parent[at(child.end - 1)];
            if (parent == EliminationTree::none || parent >= run.end) break;
            const double columns = run.end - child.begin;
            const double dense = columns * (columns + 1) / 2 + columns * rowsBelow(run);
            const double entries = run.entries + child.entries;
            if (!isWorthZeros(columns, 1 - entries / dense)) break;
            run.begin = child.begin;
            run.entries = entries;
            runs.pop_back();
        }
        runs.push_back(run);
    }
    return runs;
}

/// Appends the rows below a supernode's columns, which come from the matrix and from its children.
void appendRows(const Eigen::SparseMatrix<double>& lower, Supernode& node, Supernodes& plan) {
    std::vector<int> rows;
    for (int column = node.begin; column < node.end; ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator it(lower, column); it; ++it)
            if (it.row() >= node.end) rows.push_back(static_cast<int>(it.row()));
    for (const int child : node.children)
        std::ranges::copy_if(plan.rowsOf(plan.nodes[at(child)]), std::back_inserter(rows),
                             [&](int row) { return row >= node.end; });
    std::ranges::sort(rows);
    node.firstRow = static_cast<int>(plan.rows.size());
    std::ranges::unique_copy(rows, std::back_inserter(plan.rows));
    node.rowEnd = static_cast<int>(plan.rows.size());
}

void appendPlaces(const Supernode& node, Supernodes& plan) {
    if (node.parent == EliminationTree::none) return;
    const Supernode& parent = plan.nodes[at(node.parent)];
    auto next = plan.rowsOf(parent).begin();
    int place = parent.columns();
    for (const int row : plan.rowsOf(node)) {
        if (row < parent.end) {
            plan.inParent.push_back(row - parent.begin);
            continue;
        }
        for (; *next != row; ++next)
            ++place;
        plan.inParent.push_back(place);
    }
}

/// Collects the largest subtrees with less work than the limit into parts, as many in each as fit.
std::vector<std::vector<int>> divided(const std::vector<Supernode>& supernodes) {
    std::vector<double> work(supernodes.size()); // work of the subtree below each supernode
    double total = 0;
    for (std::size_t k = 0; k < supernodes.size(); ++k) {
        const double height = supernodes[k].height();
        const double own = supernodes[k].columns() * height * height;
        total += own;
        work[k] += own;
        if (supernodes[k].parent != EliminationTree::none) work[at(supernodes[k].parent)] += work[k];
    }
    const double limit = maxShare * total;

    constexpr int inRest = -1;
    std::vector<int> part(supernodes.size(), inRest);
    int parts = 0;
    double filled = 0;
    for (std::size_t k = supernodes.size(); k-- > 0;) {
        if (work[k] > limit) continue;
        const int parent = supernodes[k].parent;
        if (parent != EliminationTree::none && part[at(parent)] != inRest) {
            part[k] = part[at(parent)];
            continue;
        }
        if (parts == 0 || filled + work[k] > limit) {
            filled = 0;
            ++parts;
        }
        filled += work[k];
        part[k] = parts - 1;
    }
    std::vector<std::vector<int>> result(at(parts) + 1);
    for (std::size_t k = 0; k < supernodes.size(); ++k)
        result[at(part[k] == inRest ? parts : part[k])].push_back(static_cast<int>(k));
    return result;
}

} // namespace

Supernodes planSupernodes(const EliminationTree& tree, const Eigen::SparseMatrix<double>& lower) {
    Supernodes plan;
    std::vector<int> supernodeOf(tree.parent.size());
    for (const Run& run : mergedColumns(tree)) {
        Supernode supernode;
        supernode.begin = run.begin;
        supernode.end = run.end;
        std::fill(supernodeOf.begin() + run.begin, supernodeOf.begin() + run.end,
                  static_cast<int>(plan.nodes.size()));
        plan.nodes.push_back(std::move(supernode));
    }
    for (std::size_t k = 0; k < plan.nodes.size(); ++k) {
        Supernode& node = plan.nodes[k];
        appendRows(lower, node, plan);
        if (plan.rowsOf(node).empty()) continue;
        node.parent = supernodeOf[at(plan.rowsOf(node).front())];
        plan.nodes[at(node.parent)].children.push_back(static_cast<int>(k));
    }
    plan.inParent.reserve(plan.rows.size());
    for (const Supernode& node : plan.nodes)
        appendPlaces(node, plan);
    plan.parts = divided(plan.nodes);
    return plan;
}

} // namespace qm
