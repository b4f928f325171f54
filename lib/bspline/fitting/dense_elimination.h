/// \file Elimination of the first columns of a dense symmetric matrix.
#pragma once

#include <Eigen/Core>

namespace qm {

/// A symmetric matrix in two pieces, of which the lower halves count: its first columns, and what is below
/// and to the right of them.
struct DenseFront {
    Eigen::MatrixXd columns; ///< as high as the whole matrix
    Eigen::MatrixXd rest;    ///< square
};

/// Makes the first columns those of the factors L and D of L D L': the diagonal holds D, and L has ones
/// there. The rest becomes the Schur complement. Every leading minor of the first columns must be regular.
/// \param jobs  threads, if the matrix is large; the result does not depend on them
void eliminateColumns(DenseFront& front, unsigned jobs);

} // namespace qm
