#include "bspline/fitting/elimination_plan.h"

#include "base/at.h"

namespace qm {
namespace {

/// A part has at most this share of the work: small enough for several threads, and large enough to leave
/// little for the rest.
constexpr double maxShare = 0.2;

/// The tree, and how many entries each column of the factor has: row k of it has those columns that lie on
/// the ways from the row's entries in the matrix up to k.
/// \return  by column
std::vector<int> countEntries(const Eigen::SparseMatrix<double>& upper, std::vector<int>& parent) {
    const auto size = at(upper.cols());
    std::vector<int> count(size);
    std::vector<int> seenAt(size, EliminationPlan::none);
    parent.assign(size, EliminationPlan::none);
    for (int k = 0; k < static_cast<int>(size); ++k) {
        seenAt[at(k)] = k;
        for (Eigen::SparseMatrix<double>::InnerIterator it(upper, k); it; ++it)
            for (int i = static_cast<int>(it.row()); seenAt[at(i)] != k; i = parent[at(i)]) {
                if (parent[at(i)] == EliminationPlan::none) parent[at(i)] = k;
                ++count[at(i)];
                seenAt[at(i)] = k;
            }
    }
    return count;
}

/// Puts the largest subtrees that do not have too much work together to parts, as many as fit.
void divide(const std::vector<int>& count, EliminationPlan& plan) {
    const std::size_t size = count.size();
    std::vector<double> work(size); // of the subtree below each column
    double total = 0;
    for (std::size_t k = 0; k < size; ++k) {
        const double own = static_cast<double>(count[k]) * count[k];
        total += own;
        work[k] += own;
        if (plan.parent[k] != EliminationPlan::none) work[at(plan.parent[k])] += work[k];
    }
    const double limit = maxShare * total;

    constexpr int inRest = -2;
    plan.part.assign(size, inRest);
    int parts = 0;
    double filled = 0;
    for (std::size_t k = size; k-- > 0;) {
        if (work[k] > limit) continue;
        const int parent = plan.parent[k];
        if (parent != EliminationPlan::none && plan.part[at(parent)] != inRest) {
            plan.part[k] = plan.part[at(parent)];
            continue;
        }
        if (parts == 0 || filled + work[k] > limit) {
            filled = 0;
            ++parts;
        }
        filled += work[k];
        plan.part[k] = parts - 1;
    }
    plan.columns.resize(at(parts) + 1);
    for (std::size_t k = 0; k < size; ++k) {
        if (plan.part[k] == inRest) plan.part[k] = parts;
        plan.columns[at(plan.part[k])].push_back(static_cast<int>(k));
    }
}

} // namespace

EliminationPlan planElimination(const Eigen::SparseMatrix<double>& upper) {
    EliminationPlan plan;
    const std::vector<int> count = countEntries(upper, plan.parent);
    plan.starts.assign(1, 0);
    for (const int entries : count)
        plan.starts.push_back(plan.starts.back() + at(entries));
    divide(count, plan);
    return plan;
}

} // namespace qm
