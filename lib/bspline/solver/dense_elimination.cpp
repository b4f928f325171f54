#include "bspline/solver/dense_elimination.h"

#include "base/parallel.h"

#include <algorithm>
#include <cstddef>

namespace qm {
namespace {

using Eigen::Index;

/// Width of the blocks of columns that are eliminated before all later columns are updated at once.
constexpr Index blockWidth = 32;
/// Number of columns of the rest that one thread updates.
constexpr Index stripWidth = 128;

/// Eliminates columns begin ... end - 1; all earlier columns are eliminated and applied already.
void eliminateBlock(Index begin, Index end, Eigen::MatrixXd& columns) {
    const Index height = columns.rows();
    for (Index k = begin; k < end; ++k) {
        const double pivot = columns(k, k);
        for (Index j = k + 1; j < end; ++j)
            columns.col(j).segment(j, height - j) -=
                (columns(j, k) / pivot) * columns.col(k).segment(j, height - j);
        columns.col(k).tail(height - k - 1) /= pivot;
    }
}

} // namespace

void eliminateColumns(DenseFront& front, unsigned jobs) {
    Eigen::MatrixXd& columns = front.columns;
    const Index width = columns.cols();
    const Index height = columns.rows();
    for (Index begin = 0; begin < width; begin += blockWidth) {
        const Index end = std::min(begin + blockWidth, width);
        eliminateBlock(begin, end, columns);
        if (end == width) break;
        const auto block = columns.block(end, begin, height - end, end - begin);
        const Eigen::MatrixXd scaled =
            block.topRows(width - end) * columns.diagonal().segment(begin, end - begin).asDiagonal();
        columns.bottomRightCorner(height - end, width - end).noalias() -= block * scaled.transpose();
    }

    const Index size = front.rest.rows();
    const auto below = columns.bottomRows(size);
    const Eigen::MatrixXd scaled = below * columns.diagonal().asDiagonal();
    parallelFor(static_cast<std::size_t>((size + stripWidth - 1) / stripWidth), jobs, [&](std::size_t strip) {
        const Index begin = static_cast<Index>(strip) * stripWidth;
        const Index strips = std::min(stripWidth, size - begin);
        front.rest.block(begin, begin, strips, strips).triangularView<Eigen::Lower>() -=
            below.middleRows(begin, strips) * scaled.middleRows(begin, strips).transpose();
        const Index left = size - begin - strips;
        front.rest.block(begin + strips, begin, left, strips).noalias() -=
            below.bottomRows(left) * scaled.middleRows(begin, strips).transpose();
    });
}

} // namespace qm
