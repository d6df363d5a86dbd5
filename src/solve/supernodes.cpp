#include "solve/supernodes.h"

#include <algorithm>
#include <array>

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

/// Entries of each column of the factor, the diagonal among them.
std::vector<Index> column_counts(const LowerRows& rows, std::span<const Index> parent) {
  std::vector<Index> count(rows.count(), 1), seen(rows.count(), Supernodes::k_root);
  for (std::size_t i = 0; i < rows.count(); ++i) {
    const auto row = static_cast<Index>(i);
    seen[i] = row;
    for (Index k : rows.of(i)) {
      for (; seen[k] != row; k = parent[k]) {
        ++count[k];
        seen[k] = row;
      }
    }
  }
  return count;
}

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

  // Who holds something below each bundle: the matrix itself, and the bundle's children.
  std::vector<std::vector<Index>> below(bundles.size());
  for (std::size_t i = 0; i < rows.count(); ++i) {
    for (const Index k : rows.of(i)) {
      const Index s = node_of[k];
      const auto row = static_cast<Index>(i);
      if (row > bundles[s].last && (below[s].empty() || below[s].back() != row))
        below[s].push_back(row);
    }
  }
  tree.row_start.push_back(0);
  for (std::size_t s = 0; s < bundles.size(); ++s) {
    std::vector<Index>& list = below[s];
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    const Index up = list.empty() ? Supernodes::k_root : node_of[list.front()];
    tree.parent.push_back(up);
    if (up != Supernodes::k_root) {
      const auto beyond = std::upper_bound(list.begin(), list.end(), bundles[up].last);
      below[up].insert(below[up].end(), beyond, list.end());
    }
    tree.row_list.insert(tree.row_list.end(), list.begin(), list.end());
    tree.row_start.push_back(tree.row_list.size());
    list = {};
  }
  return tree;
}

}  // namespace planish
