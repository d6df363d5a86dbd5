#include "solve/front.h"

#include <algorithm>
#include <cmath>

namespace planish {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index k_block = 48;  // columns that are factored before the rest hears of it

/// Column by column; for what fits into the first-level cache.
bool factor_block(Eigen::Ref<MatrixXd> block, Eigen::Ref<Eigen::VectorXd> pivots) {
  const Index n = block.cols();
  for (Index k = 0; k < n; ++k) {
    const double pivot = block(k, k);
    if (!(std::abs(pivot) > 0.0) || !std::isfinite(pivot)) return false;
    pivots[k] = pivot;
    const Index below = n - k - 1;
    if (below == 0) break;
    auto column = block.col(k).tail(below);
    for (Index j = 0; j < below; ++j) {
      const double factor = column[j] / pivot;
      block.col(k + 1 + j).tail(below - j) -= factor * column.tail(below - j);
    }
    column /= pivot;
  }
  return true;
}

}  // namespace

bool factor_front(Eigen::Ref<MatrixXd> front, Eigen::Ref<Eigen::VectorXd> pivots) {
  const Index size = front.rows(), columns = pivots.size();
  MatrixXd scaled(size, std::min(columns, k_block));  // L D of a block
  for (Index k = 0; k < columns; k += k_block) {
    const Index width = std::min(k_block, columns - k), below = size - k - width;
    auto diagonal = front.block(k, k, width, width);
    if (!factor_block(diagonal, pivots.segment(k, width))) return false;
    if (below == 0) break;
    auto panel = front.block(k + width, k, below, width);
    diagonal.transpose().triangularView<Eigen::UnitUpper>().solveInPlace<Eigen::OnTheRight>(panel);
    auto image = scaled.topLeftCorner(below, width);
    image = panel;
    panel *= pivots.segment(k, width).cwiseInverse().asDiagonal();
    // The rest of the columns now, what is behind them all at once below.
    const Index left = columns - k - width;
    front.block(k + width, k + width, below, left).noalias() -=
        panel * image.topRows(left).transpose();
  }
  const Index rest = size - columns;
  if (rest == 0) return true;
  const auto lower = front.bottomLeftCorner(rest, columns);
  front.bottomRightCorner(rest, rest).triangularView<Eigen::Lower>() -=
      lower * (lower * pivots.asDiagonal()).transpose();
  return true;
}

}  // namespace planish
