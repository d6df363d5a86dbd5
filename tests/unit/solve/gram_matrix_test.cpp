#include "solve/gram_matrix.h"

#include <gtest/gtest.h>

#include "core/split_mix.h"
#include "solve/sparse_pattern.h"

namespace planish {
namespace {

TEST(GramMatrix, IsTheProductOfTheTransposeAndTheMatrix) {
  constexpr std::size_t rows = 40, columns = 25;
  SplitMix dice(3);
  std::vector<GramMatrix::Entry> entries;
  // Some places get several; the last column none.
  for (int k = 0; k < 300; ++k) {
    const auto row = static_cast<Index>(dice.share() * rows);
    const auto column = static_cast<Index>(dice.share() * (columns - 1));
    entries.push_back({row, column, dice.share() - 0.5});
  }
  const SparseMatrix plain = sparse_matrix(rows, columns, [&](const auto& add) {
    for (const GramMatrix::Entry& entry : entries)
      add(entry.row, entry.column, entry.value);
  });
  const GramMatrix matrix(rows, columns, entries);
  const Eigen::MatrixXd dense(plain), square = dense.transpose() * dense;
  const Eigen::MatrixXd lower = square.triangularView<Eigen::Lower>();
  EXPECT_LT((Eigen::MatrixXd(matrix.lower()) - lower).cwiseAbs().maxCoeff(), 1e-14);

  Eigen::VectorXd x(columns);
  for (double& value : x)
    value = dice.share();
  const std::vector<double> product = matrix.times(x);
  for (std::size_t r = 0; r < rows; ++r)
    EXPECT_NEAR(product[r], (dense * x)[static_cast<Eigen::Index>(r)], 1e-14);
}

}  // namespace
}  // namespace planish
