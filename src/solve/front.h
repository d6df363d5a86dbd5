#pragma once

#include <Eigen/Core>

namespace planish {

/// Factors the first columns of a dense symmetric matrix, of which the lower half is read and
/// written: below their diagonal the unit lower triangular L appears, in the rest of the matrix
/// the Schur complement, and what is above the diagonal loses its meaning.
/// @param pivots as many as columns to factor; D is written there
/// @return false where a pivot is zero or not a number
bool factor_front(Eigen::Ref<Eigen::MatrixXd> front, Eigen::Ref<Eigen::VectorXd> pivots);

}  // namespace planish
