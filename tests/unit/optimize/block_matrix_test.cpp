#include "optimize/block_matrix.h"

#include <array>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace planish {
namespace {

using Eigen::MatrixXd;

/// Blocks of 2, 0, 3 and 1 unknowns; 0 meets 1 and 2, and 2 meets 3.
BlockMatrix small_matrix() {
  constexpr std::array<unsigned char, 4> sizes = {2, 0, 3, 1};
  return {sizes, [](const BlockMatrix::VisitPair& visit) {
            visit(2, 0);
            visit(0, 1);
            visit(3, 2);
            visit(0, 2);
            visit(2, 2);
          }};
}

TEST(BlockMatrix, NumbersUnknownsBlockByBlock) {
  const BlockMatrix matrix = small_matrix();
  EXPECT_EQ(matrix.block_count(), 4U);
  EXPECT_EQ(matrix.size(1), 0);
  EXPECT_EQ(matrix.unknown(2, 0), 2);
  EXPECT_EQ(matrix.unknown(3, 0), 5);
  EXPECT_EQ(matrix.lower().rows(), 6);
  // Own lower halves of 3, 0, 6 and 1 entries, and pairs of 6, 0 and 3.
  EXPECT_EQ(matrix.lower().nonZeros(), 10 + 9);
}

TEST(BlockMatrix, FindsPairsInAnyOrder) {
  const BlockMatrix matrix = small_matrix();
  EXPECT_EQ(matrix.pair_of(0, 2), matrix.pair_of(2, 0));
  EXPECT_NE(matrix.pair_of(0, 1), BlockMatrix::k_none);
  EXPECT_EQ(matrix.pair_of(0, 3), BlockMatrix::k_none) << "they do not meet";
  EXPECT_EQ(matrix.pair_of(0, 9), BlockMatrix::k_none) << "there is no such block";
  std::vector<Index> met;
  matrix.for_pairs_of(0, [&](Index second, BlockMatrix::Pair) { met.push_back(second); });
  EXPECT_EQ(met, (std::vector<Index>{1, 2}));
}

/// Symmetric, and different for every two unknowns of any blocks.
double entry_of_blocks(std::size_t a, int i, std::size_t b, int j) {
  const double first = 1.0 + 10.0 * static_cast<double>(a) + i,
               second = 1.0 + 10.0 * static_cast<double>(b) + j;
  return first * second + first + second;
}

TEST(BlockMatrix, AddsWhatADenseMatrixGets) {
  BlockMatrix matrix = small_matrix();
  MatrixXd dense = MatrixXd::Zero(6, 6);
  const auto add = [&](auto blocks) {
    std::vector<BlockMatrix::Pair> pairs;
    matrix.append_pairs(blocks, pairs);
    const auto entry = [&](std::size_t i, int a, std::size_t j, int b) {
      return entry_of_blocks(blocks[i], a, blocks[j], b);
    };
    matrix.add(blocks, pairs.data(), entry);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      for (std::size_t j = 0; j < blocks.size(); ++j) {
        for (int a = 0; a < matrix.size(blocks[i]); ++a) {
          for (int b = 0; b < matrix.size(blocks[j]); ++b)
            dense(matrix.unknown(blocks[i], a), matrix.unknown(blocks[j], b)) += entry(i, a, j, b);
        }
      }
    }
  };
  add(std::array<Index, 3>{2, 0, 1});
  add(std::array<Index, 2>{3, 2});
  const auto both = [&] {
    return MatrixXd(MatrixXd(matrix.lower()).selfadjointView<Eigen::Lower>());
  };
  EXPECT_EQ(both(), dense);
  *matrix.own(3, 0) = 7.0;
  matrix.entries(0, matrix.pair_of(0, 2), 1)[2] = -3.0;
  dense(5, 5) = 7.0;
  dense(4, 1) = dense(1, 4) = -3.0;
  EXPECT_EQ(both(), dense);
  matrix.clear();
  EXPECT_EQ(both(), MatrixXd::Zero(6, 6));
}

}  // namespace
}  // namespace planish
