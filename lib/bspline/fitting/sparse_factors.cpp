#include "bspline/fitting/sparse_factors.h"

#include "base/at.h"
#include "base/parallel.h"

#include <Eigen/OrderingMethods>

#include <cstddef>
#include <utility>

namespace qm {
namespace {

/// What the columns of a part do to the rows of the rest, before that is eliminated itself.
struct Contribution {
    std::vector<double> sums; ///< the lower half of a matrix over the outside rows, row by row
    std::vector<std::vector<int>>
        starts; ///< by outside row: columns of the rest that it has entries in for it
};

std::size_t triangle(std::size_t row) {
    return row * (row + 1) / 2;
}

} // namespace

/// Makes rows of the factors over the columns of one part.
class SparseFactors::Elimination {
public:
    Elimination(SparseFactors& factors, const Eigen::SparseMatrix<double>& upper, int part)
        : factors_(factors), plan_(factors.plan_), upper_(upper), part_(part), row_(plan_.part.size()),
          seenAt_(plan_.part.size(), EliminationPlan::none), order_(plan_.part.size()),
          end_(plan_.starts.begin(), plan_.starts.end() - 1) {}

    /// The rows of the part itself.
    void eliminatePart() {
        for (const int k : plan_.columns[at(part_)]) {
            double diagonal = load(k, nullptr);
            finish(k, diagonal, nullptr);
            factors_.diagonal_[at(k)] = diagonal;
        }
        for (const int k : plan_.columns[at(part_)])
            factors_.inside_[at(k)] = end_[at(k)];
    }

    /// The part's columns in the rows of the rest.
    void eliminateOutside(std::vector<int>& outside, Contribution& contribution) {
        for (const int k : plan_.columns.back()) {
            std::vector<int> starts;
            load(k, &starts);
            if (first_ == order_.size()) continue;
            const std::size_t own = outside.size();
            outside.push_back(k);
            contribution.starts.push_back(std::move(starts));
            contribution.sums.resize(triangle(own + 1));
            double* sums = &contribution.sums[triangle(own)];
            finish(static_cast<int>(own), sums[own], sums);
        }
    }

    /// The rest, when all parts are done.
    void eliminateRest(const std::vector<Contribution>& contributions) {
        std::vector<std::size_t> next(contributions.size());
        for (const int k : plan_.columns.back()) {
            double diagonal = load(k, nullptr);
            for (std::size_t part = 0; part < contributions.size(); ++part) {
                const std::vector<int>& rows = factors_.outside_[part];
                const std::size_t own = next[part];
                if (own == rows.size() || rows[own] != k) continue;
                ++next[part];
                for (const int column : contributions[part].starts[own])
                    reach(column, k, nullptr);
                const double* sums = &contributions[part].sums[triangle(own)];
                for (std::size_t i = 0; i < own; ++i)
                    row_[at(rows[i])] += sums[i];
                diagonal += sums[own];
            }
            finish(k, diagonal, nullptr);
            factors_.diagonal_[at(k)] = diagonal;
        }
        for (const int k : plan_.columns.back())
            factors_.inside_[at(k)] = end_[at(k)];
    }

private:
    /// Begins a row with the matrix's entries in the part.
    /// \param starts  gets the columns of the rest that the ways from them come to
    /// \return the entry on the diagonal
    double load(int k, std::vector<int>* starts) {
        first_ = order_.size();
        double diagonal = 0;
        seenAt_[at(k)] = k;
        for (Eigen::SparseMatrix<double>::InnerIterator it(upper_, k); it; ++it) {
            const int column = static_cast<int>(it.row());
            if (column == k) diagonal += it.value();
            if (column == k || plan_.part[at(column)] != part_) continue;
            row_[at(column)] += it.value();
            reach(column, k, starts);
        }
        return diagonal;
    }

    /// Adds the columns from one up to row k that are not there yet; what depends on others comes after them.
    void reach(int column, int k, std::vector<int>* starts) {
        std::size_t count = 0;
        while (seenAt_[at(column)] != k && plan_.part[at(column)] == part_) {
            seenAt_[at(column)] = k;
            order_[count++] = column;
            column = plan_.parent[at(column)];
        }
        if (starts != nullptr && seenAt_[at(column)] != k) {
            seenAt_[at(column)] = k;
            starts->push_back(column);
        }
        while (count > 0)
            order_[--first_] = order_[--count];
    }

    /// Eliminates the columns of a row.
    /// \param name  of the row in the entries
    /// \param sums  gets what the columns do outside the part, for a row of the rest
    void finish(int name, double& diagonal, double* sums) {
        for (std::size_t i = first_; i < order_.size(); ++i) {
            const int column = order_[i];
            const double known = row_[at(column)];
            row_[at(column)] = 0;
            const std::size_t begin = plan_.starts[at(column)];
            const std::size_t end = end_[at(column)];
            const std::size_t inside = sums == nullptr ? end : factors_.inside_[at(column)];
            for (std::size_t entry = begin; entry < inside; ++entry)
                row_[at(factors_.rows_[entry])] -= factors_.values_[entry] * known;
            for (std::size_t entry = inside; entry < end; ++entry)
                sums[factors_.rows_[entry]] -= factors_.values_[entry] * known;
            const double value = known / factors_.diagonal_[at(column)];
            diagonal -= value * known;
            factors_.rows_[end] = name;
            factors_.values_[end] = value;
            ++end_[at(column)];
        }
    }

    SparseFactors& factors_;
    const EliminationPlan& plan_;
    const Eigen::SparseMatrix<double>& upper_;
    int part_;
    std::vector<double> row_; ///< by column; zero but for the row that is made
    std::vector<int> seenAt_; ///< by column: in the order of this row
    std::vector<int> order_;  ///< of elimination, from first_ on
    std::size_t first_ = 0;
    std::vector<std::size_t> end_; ///< by column: of the entries that it has
};

SparseFactors::SparseFactors(Eigen::SparseMatrix<double> lower, unsigned jobs) : jobs_(jobs) {
    // Eigen's orderings give the inverse.
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> inverse;
    Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), inverse);
    order_ = inverse.inverse();
    Eigen::SparseMatrix<double> upper(lower.rows(), lower.cols());
    upper.selfadjointView<Eigen::Upper>() = lower.selfadjointView<Eigen::Lower>().twistedBy(order_);
    lower = Eigen::SparseMatrix<double>(); // gives the memory back
    plan_ = planElimination(upper);
    diagonal_.resize(plan_.part.size());
    inside_.resize(plan_.part.size());
    rows_.resize(plan_.starts.back());
    values_.resize(plan_.starts.back());
    outside_.resize(plan_.columns.size());
    std::vector<Contribution> contributions(at(plan_.rest()));
    parallelFor(contributions.size(), jobs_, [&](std::size_t part) {
        Elimination elimination(*this, upper, static_cast<int>(part));
        elimination.eliminatePart();
        elimination.eliminateOutside(outside_[part], contributions[part]);
    });
    Elimination(*this, upper, plan_.rest()).eliminateRest(contributions);
}

/// \param sums  gets what is to be added to the outside rows
void SparseFactors::forward(std::size_t part, Rows& x, Rows& sums) const {
    for (const int column : plan_.columns[part]) {
        const Eigen::RowVector3d known = x.row(column);
        std::size_t entry = plan_.starts[at(column)];
        for (; entry < inside_[at(column)]; ++entry)
            x.row(rows_[entry]) -= values_[entry] * known;
        for (; entry < plan_.starts[at(column) + 1]; ++entry)
            sums.row(rows_[entry]) -= values_[entry] * known;
        x.row(column) = known / diagonal_[at(column)];
    }
}

void SparseFactors::backward(std::size_t part, Rows& x) const {
    const std::vector<int>& columns = plan_.columns[part];
    for (std::size_t k = columns.size(); k-- > 0;) {
        const int column = columns[k];
        Eigen::RowVector3d sum = x.row(column);
        std::size_t entry = plan_.starts[at(column)];
        for (; entry < inside_[at(column)]; ++entry)
            sum -= values_[entry] * x.row(rows_[entry]);
        for (; entry < plan_.starts[at(column) + 1]; ++entry)
            sum -= values_[entry] * x.row(outside_[part][at(rows_[entry])]);
        x.row(column) = sum;
    }
}

/// The factors are read once for all three columns, which takes most of the time.
Eigen::MatrixX3d SparseFactors::solve(const Eigen::MatrixX3d& rightHandSide) const {
    const std::size_t rest = outside_.size() - 1;
    Rows x = order_ * rightHandSide;
    std::vector<Rows> sums(outside_.size());
    parallelFor(rest, jobs_, [&](std::size_t part) {
        sums[part].setZero(static_cast<Eigen::Index>(outside_[part].size()), 3);
        forward(part, x, sums[part]);
    });
    for (std::size_t part = 0; part < rest; ++part)
        for (std::size_t k = 0; k < outside_[part].size(); ++k)
            x.row(outside_[part][k]) += sums[part].row(static_cast<Eigen::Index>(k));
    forward(rest, x, sums[rest]);
    backward(rest, x);
    parallelFor(rest, jobs_, [&](std::size_t part) { backward(part, x); });
    return order_.inverse() * Eigen::MatrixX3d(x);
}

} // namespace qm
