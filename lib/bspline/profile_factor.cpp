#include "bspline/profile_factor.h"

#include <algorithm>
#include <utility>

namespace qm {

ProfileFactor::ProfileFactor(std::vector<std::size_t> first) : first_(std::move(first)) {
    std::size_t size = 0;
    begin_.reserve(first_.size());
    for (std::size_t row = 0; row < first_.size(); ++row) {
        begin_.push_back(size);
        size += row - first_[row] + 1;
    }
    entries_.assign(size, 0);
}

void ProfileFactor::factorise() {
    for (std::size_t row = 0; row < first_.size(); ++row) {
        // First the row of L D, then that of L.
        for (std::size_t column = first_[row]; column < row; ++column) {
            const std::size_t from = std::max(first_[row], first_[column]);
            if (from < column) at(row, column) -= part(row, from, column).dot(part(column, from, column));
        }
        double& diagonal = at(row, row);
        for (std::size_t column = first_[row]; column < row; ++column) {
            double& entry = at(row, column);
            const double scaled = entry / at(column, column);
            diagonal -= entry * scaled;
            entry = scaled;
        }
    }
}

Eigen::VectorXd ProfileFactor::solve(Eigen::VectorXd right) const {
    const auto entry = [&](std::size_t row) -> double& { return right[static_cast<Eigen::Index>(row)]; };
    const auto segment = [&](std::size_t row) {
        return right.segment(static_cast<Eigen::Index>(first_[row]),
                             static_cast<Eigen::Index>(row - first_[row]));
    };
    for (std::size_t row = 0; row < first_.size(); ++row)
        entry(row) -= part(row, first_[row], row).dot(segment(row));
    for (std::size_t row = 0; row < first_.size(); ++row)
        entry(row) /= part(row, row, row + 1)[0];
    for (std::size_t row = first_.size(); row-- > 0;)
        segment(row) -= entry(row) * part(row, first_[row], row);
    return right;
}

} // namespace qm
