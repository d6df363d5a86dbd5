#include "solve/sparse_ldlt.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <new>
#include <numeric>
#include <utility>

#include "solve/front.h"

namespace planish {

namespace {

/// The pattern under another numbering.
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
  return rows;
}

std::vector<Index> rank_of(std::span<const Index> order) {
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

/// Where row 0 of column j would be among the numbers of lower_half().
std::size_t start_in_half(std::size_t j, std::size_t rows) {
  return j * rows - j * (j + 1) / 2;
}

/// Column after column from the diagonal on.
template <class T>
Buffer<T> lower_half(const T* matrix, std::size_t rows, std::size_t stride) {
  Buffer<T> half(rows * (rows + 1) / 2);
  for (std::size_t j = 0; j < rows; ++j)
    std::copy(matrix + j * stride + j, matrix + j * stride + rows,
              half.data() + start_in_half(j, rows) + j);
  return half;
}

}  // namespace

template <class T, class Kept>
BasicLdlt<T, Kept>::BasicLdlt(const SparseMatrix& lower, std::span<const Index> order,
                              const ThreadPool* pool)
    : place_(rank_of(order)) {
  const auto stop_if_cancelled = [&] {
    if (pool != nullptr) pool->stop_if_cancelled();
  };
  stop_if_cancelled();
  {
    // Children right before their parents, so that bundles of columns are contiguous.
    const auto parent = elimination_tree(rows_under(lower, place_));
    const auto later = rank_of(postorder(parent));
    for (Index& place : place_)
      place = later[place];
  }
  stop_if_cancelled();
  const LowerRows rows = rows_under(lower, place_);
  tree_ = find_supernodes(rows, elimination_tree(rows));

  stop_if_cancelled();
  panel_start_.push_back(0);
  for (std::size_t s = 0; s < tree_.count(); ++s) {
    const std::size_t width = tree_.width(s),
                      of_triangle = TrianglePanel<Kept>::start(width, width);
    panel_start_.push_back(panel_start_.back() + of_triangle + width * tree_.rows(s).size());
  }
  pivots_.resize(lower.cols());

  link_fronts();
  for (std::size_t s = 0; s < tree_.count(); ++s) {
    // Of a front with more numbers the places would not fit; nor would it into any memory.
    if (shape_of(s).panel_size() > std::numeric_limits<std::uint32_t>::max())
      throw std::bad_alloc();
  }
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
    const std::size_t stride = shape_of(s).stride();
    entries_[next[s]++] = {
        static_cast<std::uint32_t>((column - tree_.first[s]) * stride + place_in_front(s, row)),
        static_cast<std::uint32_t>(value)};
  });
}

template <class T, class Kept>
BasicLdlt<T, Kept>::BasicLdlt(const SparseMatrix& lower, const ThreadPool* pool)
    : BasicLdlt(lower, natural_order(lower.cols()), pool) {}

template <class T, class Kept>
Index BasicLdlt<T, Kept>::place_in_front(std::size_t node, Index row) const {
  if (row < tree_.first[node + 1]) return row - tree_.first[node];
  const auto below = tree_.rows(node);
  const auto found = std::lower_bound(below.begin(), below.end(), row) - below.begin();
  return static_cast<Index>(shape_of(node).place(tree_.width(node) + static_cast<Index>(found)));
}

template <class T, class Kept>
void BasicLdlt<T, Kept>::link_fronts() {
  first_child_.assign(tree_.count(), Supernodes::k_root);
  sibling_.assign(tree_.count(), Supernodes::k_root);
  in_parent_.resize(tree_.row_list.size());
  for (std::size_t s = tree_.count(); s-- > 0;) {
    const Index up = tree_.parent[s];
    if (up == Supernodes::k_root) continue;
    sibling_[s] = first_child_[up];
    first_child_[up] = static_cast<Index>(s);
    for (std::size_t i = tree_.row_start[s]; i < tree_.row_start[s + 1]; ++i)
      in_parent_[i] = place_in_front(up, tree_.row_list[i]);
  }
}

template <class T, class Kept>
TrianglePanel<Kept> BasicLdlt<T, Kept>::triangle(std::size_t node) const {
  return {panels_.data() + panel_start_[node], tree_.width(node)};
}

template <class T, class Kept>
Panel<Kept> BasicLdlt<T, Kept>::below(std::size_t node) const {
  const std::size_t rows = tree_.rows(node).size(), width = tree_.width(node);
  return {panels_.data() + panel_start_[node + 1] - rows * width, rows, width, rows};
}

template <class T, class Kept>
FrontShape<T> BasicLdlt<T, Kept>::shape_of(std::size_t node) const {
  return {tree_.width(node), tree_.rows(node).size()};
}

template <class T, class Kept>
void BasicLdlt<T, Kept>::assemble(const Matrix& matrix, std::size_t node, T* panel) const {
  const std::span<const Entry> entries(entries_.data() + entry_start_[node],
                                       entry_start_[node + 1] - entry_start_[node]);
  if (matrix.scale.empty()) {
    for (const Entry& entry : entries)
      panel[entry.place] += static_cast<T>(matrix.values[entry.value]);
    return;
  }
  const FrontShape<T> shape = shape_of(node);
  const auto stride = static_cast<std::uint32_t>(shape.stride()),
             corner = static_cast<std::uint32_t>(FrontShape<T>::padded(shape.columns));
  const double* own = matrix.scale.data() + tree_.first[node];
  const auto below = tree_.rows(node);
  for (const Entry& entry : entries) {
    const std::uint32_t column = entry.place / stride, row = entry.place % stride;
    const double row_scale = row < corner ? own[row] : matrix.scale[below[row - corner]];
    panel[entry.place] += static_cast<T>(row_scale * own[column] * matrix.values[entry.value]);
  }
}

template <class T, class Kept>
bool BasicLdlt<T, Kept>::factor_node(const Matrix& matrix, std::size_t node, FrontSpace<T>& space,
                                     std::vector<Buffer<T>>& updates, ThreadPool& pool) {
  const FrontShape<T> shape = shape_of(node);
  const std::size_t stride = shape.stride(), corner = FrontShape<T>::padded(shape.columns);
  T* panel = space.panel.data();
  std::fill_n(panel, shape.panel_size(), T{});
  assemble(matrix, node, panel);
  const auto for_children = [&](const auto& visit) {
    for (Index child = first_child_[node]; child != Supernodes::k_root; child = sibling_[child]) {
      const std::span<const Index> to(in_parent_.data() + tree_.row_start[child],
                                      tree_.rows(child).size());
      const auto inside = std::lower_bound(to.begin(), to.end(), corner) - to.begin();
      visit(child, to, static_cast<std::size_t>(inside));
    }
  };
  for_children([&](Index child, std::span<const Index> to, std::size_t inside) {
    for (std::size_t j = 0; j < inside; ++j) {
      const T* source = updates[child].data() + start_in_half(j, to.size());
      T* column = panel + to[j] * stride;
      for (std::size_t i = j; i < to.size(); ++i)
        column[to[i]] += source[i];
    }
  });
  FrontBuffer<T> own(shape.rest_size());
  T* rest = own.data();
  if (!factor_front(shape, kernel_, space, pivots_.data() + tree_.first[node], rest, pool))
    return false;
  for_children([&](Index child, std::span<const Index> to, std::size_t inside) {
    for (std::size_t j = inside; j < to.size(); ++j) {
      const T* source = updates[child].data() + start_in_half(j, to.size());
      T* column = rest + (to[j] - corner) * shape.rest_stride();
      for (std::size_t i = j; i < to.size(); ++i)
        column[to[i] - corner] += source[i];
    }
    updates[child] = {};
  });
  updates[node] = lower_half(rest, shape.rest, shape.rest_stride());
  Kept* kept = panels_.data() + panel_start_[node];
  const auto keep = [&](const T* from, std::size_t count) {
    kept = std::transform(from, from + count, kept, [](T x) { return static_cast<Kept>(x); });
  };
  for (std::size_t k = 0; k < shape.columns; ++k) {
    const std::size_t first = TrianglePanel<Kept>::first_row(k);
    keep(panel + k * stride + first, shape.columns - first);
  }
  for (std::size_t k = 0; k < shape.columns; ++k)
    keep(panel + k * stride + corner, shape.rest);
  return true;
}

template <class T, class Kept>
FrontSpace<T> BasicLdlt<T, Kept>::space_for(std::span<const Index> nodes) const {
  std::size_t panel = 0, beside = 0;
  for (const Index s : nodes) {
    panel = std::max(panel, shape_of(s).panel_size());
    beside = std::max(beside, shape_of(s).beside_size());
  }
  return {FrontBuffer<T>(panel), FrontBuffer<T>(beside), FrontBuffer<T>(beside)};
}

template <class T, class Kept>
bool BasicLdlt<T, Kept>::factor(const double* values, std::span<const double> scale,
                                ThreadPool& pool) {
  if (panels_.size() == 0) panels_ = Buffer<Kept>(panel_start_.back());
  Matrix matrix{values, std::vector<double>(scale.size())};
  for (std::size_t i = 0; i < scale.size(); ++i)
    matrix.scale[place_[i]] = scale[i];
  std::vector<Buffer<T>> updates(tree_.count());  // what children leave to their parents
  split_ = split_tree(tree_, pool.size());
  std::atomic<bool> sound = true;
  const auto factor_part = [&](const Subtrees::Range& part) {
    ThreadPool alone(1);
    std::vector<Index> nodes(part.end - part.begin);
    std::iota(nodes.begin(), nodes.end(), static_cast<Index>(part.begin));
    FrontSpace<T> own = space_for(nodes);
    for (const Index s : nodes) {
      if (!sound) return;
      if (!factor_node(matrix, s, own, updates, alone)) sound = false;
    }
  };
  Subtrees::Stage done = {};
  for (const Subtrees::Stage& stage : split_.stages) {
    const auto parts =
        std::span(split_.parts).subspan(done.parts_end, stage.parts_end - done.parts_end);
    pool.for_ranges(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
      std::for_each(parts.begin() + begin, parts.begin() + end, factor_part);
    });
    const auto top = std::span(split_.top).subspan(done.top_end, stage.top_end - done.top_end);
    FrontSpace<T> own = space_for(top);
    for (const Index s : top) {
      pool.stop_if_cancelled();
      if (!sound || !factor_node(matrix, s, own, updates, pool)) return false;
    }
    done = stage;
  }
  return sound;
}

template class BasicLdlt<double>;
template class BasicLdlt<double, float>;
template class BasicLdlt<float>;

}  // namespace planish
