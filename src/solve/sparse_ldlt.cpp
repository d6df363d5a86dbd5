#include "solve/sparse_ldlt.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "solve/front.h"

namespace planish {

namespace {

/// The pattern under another numbering, each row's columns in increasing order.
LowerRows rows_under(const SparseMatrix& lower, std::span<const Index> place) {
  const auto n = static_cast<std::size_t>(lower.cols());
  LowerRows rows;
  rows.start.assign(n + 1, 0);
  const auto for_entries = [&](const auto& visit) {
    for (int j = 0; j < lower.outerSize(); ++j) {
      for (SparseMatrix::InnerIterator entry(lower, j); entry; ++entry) {
        if (entry.row() <= j) continue;
        const auto [column, row] = std::minmax(place[entry.row()], place[j]);
        visit(row, column);
      }
    }
  };
  for_entries([&](Index row, Index) { ++rows.start[row + 1]; });
  for (std::size_t i = 0; i < n; ++i)
    rows.start[i + 1] += rows.start[i];
  rows.columns.resize(rows.start.back());
  std::vector<std::size_t> next(rows.start.begin(), rows.start.end() - 1);
  for_entries([&](Index row, Index column) { rows.columns[next[row]++] = column; });
  for (std::size_t i = 0; i < n; ++i) {
    std::sort(rows.columns.begin() + static_cast<std::ptrdiff_t>(rows.start[i]),
              rows.columns.begin() + static_cast<std::ptrdiff_t>(rows.start[i + 1]));
  }
  return rows;
}

std::vector<Index> places_of(std::span<const Index> order) {
  std::vector<Index> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    place[order[k]] = static_cast<Index>(k);
  return place;
}

std::vector<Index> natural_order(Eigen::Index count) {
  std::vector<Index> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), Index{0});
  return order;
}

/// Where each column of the tree lies: its supernode.
std::vector<Index> nodes_of(const Supernodes& tree) {
  std::vector<Index> node(tree.first.back());
  for (std::size_t s = 0; s < tree.count(); ++s)
    std::fill(node.begin() + tree.first[s], node.begin() + tree.first[s + 1],
              static_cast<Index>(s));
  return node;
}

}  // namespace

SparseLdlt::SparseLdlt(const SparseMatrix& lower, std::span<const Index> order)
    : place_(places_of(order)) {
  {
    // Children right before their parents, so that bundles of columns are contiguous.
    const auto parent = elimination_tree(rows_under(lower, place_));
    const auto later = places_of(postorder(parent));
    for (Index& place : place_)
      place = later[place];
  }
  const LowerRows rows = rows_under(lower, place_);
  tree_ = find_supernodes(rows, elimination_tree(rows));

  panel_start_.push_back(0);
  for (std::size_t s = 0; s < tree_.count(); ++s) {
    const std::size_t size = tree_.width(s) + tree_.rows(s).size();
    panel_start_.push_back(panel_start_.back() + size * tree_.width(s));
  }
  pivots_.resize(lower.cols());

  const std::vector<Index> node = nodes_of(tree_);
  const auto for_entries = [&](const auto& visit) {
    std::size_t value = 0;
    for (int j = 0; j < lower.outerSize(); ++j) {
      for (SparseMatrix::InnerIterator entry(lower, j); entry; ++entry, ++value) {
        if (entry.row() < j) continue;
        const auto [column, row] = std::minmax(place_[entry.row()], place_[j]);
        visit(row, column, value);
      }
    }
  };
  entry_start_.assign(tree_.count() + 1, 0);
  for_entries([&](Index, Index column, std::size_t) { ++entry_start_[node[column] + 1]; });
  for (std::size_t s = 0; s < tree_.count(); ++s)
    entry_start_[s + 1] += entry_start_[s];
  entries_.resize(entry_start_.back());
  std::vector<std::size_t> next(entry_start_.begin(), entry_start_.end() - 1);
  for_entries([&](Index row, Index column, std::size_t value) {
    const Index s = node[column];
    const auto below = tree_.rows(s);
    const Index in_front =
        row < tree_.first[s + 1]
            ? row - tree_.first[s]
            : tree_.width(s) +
                  static_cast<Index>(std::lower_bound(below.begin(), below.end(), row) -
                                     below.begin());
    entries_[next[s]++] = {in_front, column - tree_.first[s], value};
  });
}

SparseLdlt::SparseLdlt(const SparseMatrix& lower)
    : SparseLdlt(lower, natural_order(lower.cols())) {}

Eigen::Map<const Eigen::MatrixXd> SparseLdlt::panel(std::size_t node) const {
  const auto size = static_cast<Eigen::Index>(tree_.width(node) + tree_.rows(node).size());
  return {panels_.data() + panel_start_[node], size, static_cast<Eigen::Index>(tree_.width(node))};
}

void SparseLdlt::assemble(const SparseMatrix& lower, std::size_t node,
                          Eigen::MatrixXd& front) const {
  for (std::size_t e = entry_start_[node]; e < entry_start_[node + 1]; ++e) {
    const Entry& entry = entries_[e];
    front(entry.row, entry.column) += lower.valuePtr()[entry.value];
  }
}

bool SparseLdlt::factor(const SparseMatrix& lower) {
  panels_.resize(panel_start_.back());
  // What children leave to their parents; those of the open subtrees lie on the stack.
  struct Update {
    std::size_t node;
    Eigen::MatrixXd matrix;
  };
  std::vector<Update> open;
  std::vector<Index> in_front(place_.size());
  for (std::size_t s = 0; s < tree_.count(); ++s) {
    const auto rows = tree_.rows(s);
    const auto width = static_cast<Eigen::Index>(tree_.width(s));
    const Eigen::Index size = width + static_cast<Eigen::Index>(rows.size());
    Eigen::MatrixXd front = Eigen::MatrixXd::Zero(size, size);
    assemble(lower, s, front);
    for (Index column = tree_.first[s]; column < tree_.first[s + 1]; ++column)
      in_front[column] = column - tree_.first[s];
    for (std::size_t i = 0; i < rows.size(); ++i)
      in_front[rows[i]] = tree_.width(s) + static_cast<Index>(i);
    for (; !open.empty() && tree_.parent[open.back().node] == s; open.pop_back()) {
      const auto from = tree_.rows(open.back().node);
      const Eigen::MatrixXd& update = open.back().matrix;
      for (std::size_t j = 0; j < from.size(); ++j) {
        double* column = front.col(in_front[from[j]]).data();
        const double* source = update.col(static_cast<Eigen::Index>(j)).data();
        for (std::size_t i = j; i < from.size(); ++i)
          column[in_front[from[i]]] += source[i];
      }
    }
    if (!factor_front(front, pivots_.segment(tree_.first[s], width))) return false;
    std::copy_n(front.data(), size * width, panels_.data() + panel_start_[s]);
    if (!rows.empty()) {
      const auto left = static_cast<Eigen::Index>(rows.size());
      open.push_back({s, front.bottomRightCorner(left, left)});
    }
  }
  return true;
}

void SparseLdlt::solve_forward(Eigen::MatrixXd& x) const {
  Eigen::MatrixXd image;
  for (std::size_t s = 0; s < tree_.count(); ++s) {
    const auto l = panel(s);
    const auto rows = tree_.rows(s);
    auto own = x.middleRows(tree_.first[s], l.cols());
    l.topRows(l.cols()).triangularView<Eigen::UnitLower>().solveInPlace(own);
    image.noalias() = l.bottomRows(l.rows() - l.cols()) * own;
    for (std::size_t i = 0; i < rows.size(); ++i)
      x.row(rows[i]) -= image.row(static_cast<Eigen::Index>(i));
  }
}

void SparseLdlt::solve_backward(Eigen::MatrixXd& x) const {
  Eigen::MatrixXd below;
  for (std::size_t s = tree_.count(); s-- > 0;) {
    const auto l = panel(s);
    const auto rows = tree_.rows(s);
    below.resize(static_cast<Eigen::Index>(rows.size()), x.cols());
    for (std::size_t i = 0; i < rows.size(); ++i)
      below.row(static_cast<Eigen::Index>(i)) = x.row(rows[i]);
    auto own = x.middleRows(tree_.first[s], l.cols());
    own.noalias() -= l.bottomRows(l.rows() - l.cols()).transpose() * below;
    l.topRows(l.cols()).transpose().triangularView<Eigen::UnitUpper>().solveInPlace(own);
  }
}

Eigen::MatrixXd SparseLdlt::solve(const Eigen::MatrixXd& right) const {
  Eigen::MatrixXd x(right.rows(), right.cols());
  for (Eigen::Index i = 0; i < right.rows(); ++i)
    x.row(place_[i]) = right.row(i);
  solve_forward(x);
  x.array().colwise() /= pivots_.array();
  solve_backward(x);
  Eigen::MatrixXd solution(right.rows(), right.cols());
  for (Eigen::Index i = 0; i < right.rows(); ++i)
    solution.row(i) = x.row(place_[i]);
  return solution;
}

}  // namespace planish
