// How a factor solves: from the leaves of the tree of supernodes to its roots and back.

#include <algorithm>

#include "solve/sparse_ldlt.h"

namespace planish {

namespace {

/// Calls body(begin, end) for blocks of [0, count), which are the same for every number of threads:
/// how numbers are summed follows from them.
void for_blocks(ThreadPool& pool, std::size_t count, std::size_t block, std::size_t work_of_one,
                const auto& body) {
  constexpr std::size_t enough = 200'000;  // multiplications; waking takes some 60 us
  const std::size_t grain = 1 + enough / (1 + block * work_of_one);
  pool.for_ranges((count + block - 1) / block, grain, [&](std::size_t from, std::size_t to) {
    for (std::size_t b = from; b < to; ++b)
      body(static_cast<Eigen::Index>(b * block),
           static_cast<Eigen::Index>(std::min(block, count - b * block)));
  });
}

}  // namespace

void SparseLdlt::solve_forward(std::size_t node, Eigen::MatrixXd& x,
                               Eigen::Map<Eigen::MatrixXd>& left, ThreadPool& pool) const {
  constexpr std::size_t block = 512;
  const auto l = panel(node);
  const FrontShape shape = shape_of(node);
  const auto corner = static_cast<Index>(FrontShape::padded(shape.columns));
  const auto left_of = [&](std::size_t s) {
    return left.middleRows(static_cast<Eigen::Index>(tree_.row_start[s]),
                           static_cast<Eigen::Index>(tree_.rows(s).size()));
  };
  auto own = x.middleRows(tree_.first[node], l.cols());
  auto image = left_of(node);
  image.setZero();
  for (Index child = first_child_[node]; child != Supernodes::k_root; child = sibling_[child]) {
    const auto from = left_of(child);
    const Index* to = in_parent_.data() + tree_.row_start[child];
    for (Eigen::Index i = 0; i < from.rows(); ++i) {
      if (to[i] < corner) own.row(to[i]) -= from.row(i);
      if (to[i] >= corner) image.row(to[i] - corner) += from.row(i);
    }
  }
  l.topRows(l.cols()).triangularView<Eigen::UnitLower>().solveInPlace(own);
  for_blocks(pool, shape.rest, block, shape.columns, [&](Eigen::Index begin, Eigen::Index count) {
    image.middleRows(begin, count).noalias() += l.middleRows(l.cols() + begin, count) * own;
  });
}

void SparseLdlt::solve_backward(std::size_t node, Eigen::MatrixXd& x, Eigen::MatrixXd& room,
                                ThreadPool& pool) const {
  constexpr std::size_t block = 64;
  const auto l = panel(node);
  const FrontShape shape = shape_of(node);
  const auto rows = tree_.rows(node);
  auto below = room.topRows(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    below.row(static_cast<Eigen::Index>(i)) = x.row(rows[i]);
  auto own = x.middleRows(tree_.first[node], l.cols());
  for_blocks(pool, shape.columns, block, shape.rest, [&](Eigen::Index begin, Eigen::Index count) {
    const auto beside = l.bottomRows(l.rows() - l.cols()).middleCols(begin, count);
    own.middleRows(begin, count).noalias() -= beside.transpose() * below;
  });
  l.topRows(l.cols()).transpose().triangularView<Eigen::UnitUpper>().solveInPlace(own);
}

/// Room for what any panel has below its own rows. Taken once: where memory ends while an Eigen
/// matrix is resized, the old elements are freed twice.
Eigen::MatrixXd SparseLdlt::room_below(Eigen::Index columns) const {
  std::size_t most = 0;
  for (std::size_t s = 0; s < tree_.count(); ++s)
    most = std::max(most, tree_.rows(s).size());
  return {static_cast<Eigen::Index>(most), columns};
}

Eigen::MatrixXd SparseLdlt::solve(const Eigen::MatrixXd& right) const {
  ThreadPool alone(1);
  return solve(right, alone);
}

Eigen::MatrixXd SparseLdlt::solve(const Eigen::MatrixXd& right, ThreadPool& pool) const {
  Eigen::MatrixXd x(right.rows(), right.cols());
  for (Eigen::Index i = 0; i < right.rows(); ++i)
    x.row(place_[i]) = right.row(i);
  const auto left_rows = static_cast<Eigen::Index>(tree_.row_list.size());
  Buffer<double> left_room(tree_.row_list.size() * static_cast<std::size_t>(right.cols()));
  Eigen::Map<Eigen::MatrixXd> left(left_room.data(), left_rows, right.cols());
  const auto for_parts = [&](const auto& body) {
    pool.for_ranges(split_.parts.size(), 1, [&](std::size_t begin, std::size_t end) {
      ThreadPool alone(1);
      for (std::size_t part = begin; part < end; ++part)
        body(split_.parts[part], alone);
    });
  };
  for_parts([&](const Subtrees::Range& part, ThreadPool& alone) {
    for (std::size_t s = part.begin; s < part.end; ++s)
      solve_forward(s, x, left, alone);
  });
  for (const Index s : split_.top)
    solve_forward(s, x, left, pool);
  x.array().colwise() /= pivots_.array();
  Eigen::MatrixXd room = room_below(x.cols());
  for (auto s = split_.top.rbegin(); s != split_.top.rend(); ++s)
    solve_backward(*s, x, room, pool);
  for_parts([&](const Subtrees::Range& part, ThreadPool& alone) {
    Eigen::MatrixXd own_room = room_below(x.cols());
    for (std::size_t s = part.end; s-- > part.begin;)
      solve_backward(s, x, own_room, alone);
  });
  Eigen::MatrixXd solution(right.rows(), right.cols());
  for (Eigen::Index i = 0; i < right.rows(); ++i)
    solution.row(i) = x.row(place_[i]);
  return solution;
}

}  // namespace planish
