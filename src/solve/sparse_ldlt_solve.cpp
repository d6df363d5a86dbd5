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
      body(b * block, std::min(block, count - b * block));
  });
}

}  // namespace

template <class T, class Kept>
void BasicLdlt<T, Kept>::solve_forward(std::size_t node, double* x, double* left,
                                       ThreadPool& pool) const {
  constexpr std::size_t block = 512;
  const Panel<Kept> l = below(node);
  const FrontShape<T> shape = shape_of(node);
  const auto corner = static_cast<Index>(FrontShape<T>::padded(shape.columns));
  double* own = x + tree_.first[node];
  double* image = left + tree_.row_start[node];
  std::fill_n(image, shape.rest, 0.0);
  for (Index child = first_child_[node]; child != Supernodes::k_root; child = sibling_[child]) {
    for (std::size_t i = tree_.row_start[child]; i < tree_.row_start[child + 1]; ++i) {
      const Index to = in_parent_[i];
      if (to < corner) own[to] -= left[i];
      if (to >= corner) image[to - corner] += left[i];
    }
  }
  panel_kernel_.solve_unit_lower(triangle(node), own);
  for_blocks(pool, shape.rest, block, shape.columns, [&](std::size_t begin, std::size_t count) {
    panel_kernel_.add_product(l.part(begin, 0, count, shape.columns), own, image + begin);
  });
}

template <class T, class Kept>
void BasicLdlt<T, Kept>::solve_backward(std::size_t node, double* x, double* room,
                                        ThreadPool& pool) const {
  constexpr std::size_t block = 64;
  const Panel<Kept> l = below(node);
  const FrontShape<T> shape = shape_of(node);
  const auto rows = tree_.rows(node);
  for (std::size_t i = 0; i < rows.size(); ++i)
    room[i] = x[rows[i]];
  double* own = x + tree_.first[node];
  for_blocks(pool, shape.columns, block, shape.rest, [&](std::size_t begin, std::size_t count) {
    panel_kernel_.subtract_transposed_product(l.part(0, begin, shape.rest, count), room,
                                              own + begin);
  });
  panel_kernel_.solve_unit_lower_transposed(triangle(node), own);
}

/// Room for what any panel has below its own rows.
template <class T, class Kept>
Buffer<double> BasicLdlt<T, Kept>::workspace_below() const {
  std::size_t most = 0;
  for (std::size_t s = 0; s < tree_.count(); ++s)
    most = std::max(most, tree_.rows(s).size());
  return Buffer<double>(most);
}

template <class T, class Kept>
Eigen::MatrixXd BasicLdlt<T, Kept>::solve(const Eigen::MatrixXd& right) const {
  ThreadPool alone(1);
  return solve(right, alone);
}

template <class T, class Kept>
Eigen::MatrixXd BasicLdlt<T, Kept>::solve(const Eigen::MatrixXd& right, ThreadPool& pool) const {
  Eigen::MatrixXd solution(right.rows(), right.cols());
  Buffer<double> x(place_.size());
  for (Eigen::Index column = 0; column < right.cols(); ++column) {
    for (std::size_t i = 0; i < place_.size(); ++i)
      x.data()[place_[i]] = right(static_cast<Eigen::Index>(i), column);
    solve_in_place(x.data(), pool);
    for (std::size_t i = 0; i < place_.size(); ++i)
      solution(static_cast<Eigen::Index>(i), column) = x.data()[place_[i]];
  }
  return solution;
}

template <class T, class Kept>
void BasicLdlt<T, Kept>::solve_in_place(double* x, ThreadPool& pool) const {
  Buffer<double> left(tree_.row_list.size());
  const auto for_parts = [&](const auto& body) {
    pool.for_ranges(split_.parts.size(), 1, [&](std::size_t begin, std::size_t end) {
      ThreadPool alone(1);
      for (std::size_t part = begin; part < end; ++part)
        body(split_.parts[part], alone);
    });
  };
  for_parts([&](const Subtrees::Range& part, ThreadPool& alone) {
    for (std::size_t s = part.begin; s < part.end; ++s)
      solve_forward(s, x, left.data(), alone);
  });
  for (const Index s : split_.top)
    solve_forward(s, x, left.data(), pool);
  for (std::size_t i = 0; i < place_.size(); ++i)
    x[i] /= static_cast<double>(pivots_[static_cast<Eigen::Index>(i)]);
  Buffer<double> room = workspace_below();
  for (auto s = split_.top.rbegin(); s != split_.top.rend(); ++s)
    solve_backward(*s, x, room.data(), pool);
  for_parts([&](const Subtrees::Range& part, ThreadPool& alone) {
    Buffer<double> own_room = workspace_below();
    for (std::size_t s = part.end; s-- > part.begin;)
      solve_backward(s, x, own_room.data(), alone);
  });
}

template Eigen::MatrixXd BasicLdlt<double>::solve(const Eigen::MatrixXd&) const;
template Eigen::MatrixXd BasicLdlt<double>::solve(const Eigen::MatrixXd&, ThreadPool&) const;
template Eigen::MatrixXd BasicLdlt<double, float>::solve(const Eigen::MatrixXd&, ThreadPool&) const;
template Eigen::MatrixXd BasicLdlt<float>::solve(const Eigen::MatrixXd&, ThreadPool&) const;

}  // namespace planish
