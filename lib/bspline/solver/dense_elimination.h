/// \file Eliminates the first columns of a dense symmetric matrix.
#pragma once

#include <Eigen/Core>

namespace qm {

/// A symmetric matrix in two pieces: its first columns, and the rest below and to the right of them. Only the
/// lower halves are used.
struct DenseFront {
    Eigen::MatrixXd columns; ///< as high as the whole matrix
    Eigen::MatrixXd rest;    ///< square
};

/// Replaces the first columns by those of the factors L and D of L D L', with D on the diagonal, where L has
/// ones, and the rest by the Schur complement. Every leading minor of the first columns must be regular.
/// \param jobs  threads, used if the matrix is large; the result does not depend on their number
void eliminateColumns(DenseFront& front, unsigned jobs);

} // namespace qm
