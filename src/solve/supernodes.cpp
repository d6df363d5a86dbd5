#include "solve/supernodes.h"

#include <algorithm>
#include <array>
#include <utility>

namespace planish {

std::vector<Index> elimination_tree(const LowerRows& rows) {
  constexpr Index none = Supernodes::k_root;
  std::vector<Index> parent(rows.count(), none), ancestor(rows.count(), none);
  for (std::size_t i = 0; i < rows.count(); ++i) {
    const auto row = static_cast<Index>(i);
    for (Index k : rows.of(i)) {
      // Up to the root of the tree so far, shortening the way for those who come after.
      while (k != none && k != row) {
        const Index next = ancestor[k];
        ancestor[k] = row;
        if (next == none) parent[k] = row;
        k = next;
      }
    }
  }
  return parent;
}

std::vector<Index> postorder(std::span<const Index> parent) {
  constexpr Index none = Supernodes::k_root;
  std::vector<Index> child(parent.size(), none), sibling(parent.size(), none), order, open;
  std::vector<Index> roots;
  for (std::size_t i = parent.size(); i-- > 0;) {
    const auto v = static_cast<Index>(i);
    if (parent[i] == none) {
      roots.push_back(v);
      continue;
    }
    sibling[i] = child[parent[i]];
    child[parent[i]] = v;
  }
  order.reserve(parent.size());
  for (auto root = roots.rbegin(); root != roots.rend(); ++root) {
    open.push_back(*root);
    while (!open.empty()) {
      const Index v = open.back();
      if (child[v] != none) {
        open.push_back(child[v]);
        child[v] = sibling[child[v]];  // its brothers are left
      } else {
        order.push_back(v);
        open.pop_back();
      }
    }
  }
  return order;
}

namespace {

/// Rows of each column, the other way round.
LowerRows transposed(const LowerRows& rows) {
  LowerRows columns;
  columns.start.assign(rows.count() + 1, 0);
  for (const Index k : rows.columns)
    ++columns.start[k + 1];
  for (std::size_t i = 0; i < rows.count(); ++i)
    columns.start[i + 1] += columns.start[i];
  columns.columns.resize(rows.columns.size());
  std::vector<std::size_t> next(columns.start.begin(), columns.start.end() - 1);
  for (std::size_t i = 0; i < rows.count(); ++i) {
    for (const Index k : rows.of(i))
      columns.columns[next[k]++] = static_cast<Index>(i);
  }
  return columns;
}

}  // namespace

/// A row of the factor is a subtree of the elimination tree: each of its leaves adds one to all
/// columns from there to the root, and where the paths of two leaves meet, one is taken away again.
std::vector<Index> column_counts(const LowerRows& rows, std::span<const Index> parent) {
  constexpr Index none = Supernodes::k_root;
  const std::size_t n = rows.count();
  const LowerRows columns = transposed(rows);
  std::vector<Index> first(n), ancestor(n), count(n, 0);
  for (std::size_t j = 0; j < n; ++j)
    first[j] = ancestor[j] = static_cast<Index>(j);
  for (std::size_t j = 0; j < n; ++j) {
    if (first[j] == j) ++count[j];  // a leaf of the tree
    if (parent[j] == none) continue;
    first[parent[j]] = std::min(first[parent[j]], first[j]);
    --count[parent[j]];  // wraps around, as do the sums: in the end all are right
  }
  const auto root_of = [&](Index v) {
    Index root = v;
    while (ancestor[root] != root)
      root = ancestor[root];
    while (v != root)
      v = std::exchange(ancestor[v], root);
    return root;
  };
  std::vector<Index> last_leaf(n, none);  // of each row's subtree
  for (std::size_t i = 0; i < n; ++i) {
    const auto j = static_cast<Index>(i);
    for (const Index row : columns.of(i)) {
      const Index before = last_leaf[row];
      if (before != none && first[j] <= before) continue;  // an ancestor of that leaf
      last_leaf[row] = j;
      ++count[j];
      if (before != none) --count[root_of(before)];
    }
    if (parent[j] != none) ancestor[j] = parent[j];
  }
  for (std::size_t j = 0; j < n; ++j) {
    if (parent[j] != none) count[parent[j]] += count[j];
  }
  return count;
}

namespace {

/// Columns that are being bundled.
struct Bundle {
  Index first, last;
  std::size_t below;   // rows below the columns
  double zeros = 0.0;  // entries held though the factor has none there

  double columns() const { return static_cast<double>(last - first + 1); }
  double size() const { return columns() * (0.5 * (columns() + 1.0) + static_cast<double>(below)); }
};

/// Whether holding the child's columns and the parent's together wastes little: much is allowed
/// for narrow bundles, whose fronts cost more than their arithmetic.
bool worth_merging(const Bundle& merged) {
  struct Limit {
    double columns, share;
  };
  constexpr std::array limits = {Limit{8, 0.6}, Limit{24, 0.25}, Limit{64, 0.1}};
  const double share = merged.zeros / merged.size();
  return share < 0.03 || std::any_of(limits.begin(), limits.end(), [&](Limit limit) {
           return merged.columns() <= limit.columns && share < limit.share;
         });
}

std::vector<Bundle> bundle_columns(std::span<const Index> parent, std::span<const Index> count) {
  std::vector<Bundle> done;
  for (std::size_t i = 0; i < parent.size(); ++i) {
    const auto column = static_cast<Index>(i);
    Bundle bundle{column, column, count[i] - std::size_t{1}};
    // The bundle that ends just before may be a child, and so may the one that then ends there.
    while (!done.empty()) {
      const Bundle& child = done.back();
      if (parent[child.last] != bundle.first) break;
      Bundle merged{child.first, bundle.last, bundle.below};
      merged.zeros = child.zeros + bundle.zeros + (merged.size() - child.size() - bundle.size());
      if (!worth_merging(merged)) break;
      bundle = merged;
      done.pop_back();
    }
    done.push_back(bundle);
  }
  return done;
}

}  // namespace

Supernodes find_supernodes(const LowerRows& rows, std::span<const Index> parent) {
  const auto bundles = bundle_columns(parent, column_counts(rows, parent));
  Supernodes tree;
  std::vector<Index> node_of(rows.count());
  for (std::size_t s = 0; s < bundles.size(); ++s) {
    tree.first.push_back(bundles[s].first);
    std::fill(node_of.begin() + bundles[s].first, node_of.begin() + bundles[s].last + 1,
              static_cast<Index>(s));
  }
  tree.first.push_back(static_cast<Index>(rows.count()));

  // Of each bundle the rows below it that the matrix itself has, each once.
  std::vector<std::size_t> start(bundles.size() + 1, 0);
  const auto for_own_rows = [&](const auto& visit) {
    std::vector<Index> last(bundles.size(), Supernodes::k_root);
    for (std::size_t i = 0; i < rows.count(); ++i) {
      const auto row = static_cast<Index>(i);
      for (const Index k : rows.of(i)) {
        const Index s = node_of[k];
        if (row > bundles[s].last && std::exchange(last[s], row) != row) visit(s, row);
      }
    }
  };
  for_own_rows([&](Index s, Index) { ++start[s + 1]; });
  for (std::size_t s = 0; s < bundles.size(); ++s)
    start[s + 1] += start[s];
  std::vector<Index> own(start.back());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for_own_rows([&](Index s, Index row) { own[next[s]++] = row; });

  // And those that its children have there.
  std::vector<Index> child(bundles.size(), Supernodes::k_root), sibling = child;
  std::vector<Index> seen(rows.count(), Supernodes::k_root), list;
  tree.row_start.push_back(0);
  for (std::size_t i = 0; i < bundles.size(); ++i) {
    const auto s = static_cast<Index>(i);
    list.clear();
    const auto add = [&](Index row) {
      if (row > bundles[i].last && std::exchange(seen[row], s) != s) list.push_back(row);
    };
    std::for_each(own.begin() + static_cast<std::ptrdiff_t>(start[i]),
                  own.begin() + static_cast<std::ptrdiff_t>(start[i + 1]), add);
    for (Index c = child[i]; c != Supernodes::k_root; c = sibling[c]) {
      for (const Index row : tree.rows(c))
        add(row);
    }
    std::sort(list.begin(), list.end());
    const Index up = list.empty() ? Supernodes::k_root : node_of[list.front()];
    tree.parent.push_back(up);
    if (up != Supernodes::k_root) sibling[i] = std::exchange(child[up], s);
    tree.row_list.insert(tree.row_list.end(), list.begin(), list.end());
    tree.row_start.push_back(tree.row_list.size());
  }
  tree.row_list.shrink_to_fit();
  return tree;
}

}  // namespace planish
