#include "solve/supernodes.h"

#include <algorithm>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace planish {
namespace {

LowerRows rows_of(const std::vector<std::set<Index>>& columns_of_rows) {
  LowerRows rows;
  for (const std::set<Index>& columns : columns_of_rows) {
    rows.columns.insert(rows.columns.end(), columns.begin(), columns.end());
    rows.start.push_back(rows.columns.size());
  }
  return rows;
}

/// A random pattern, numbered so that its elimination tree is in postorder.
LowerRows random_pattern(Index count, double entries_per_row, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::pair<Index, Index>> entries;
  for (int k = 0; k < static_cast<int>(entries_per_row * count); ++k)
    entries.emplace_back(random() % count, random() % count);
  const auto numbered = [&](const std::vector<Index>& number) {
    std::vector<std::set<Index>> rows(count);
    for (const auto& [a, b] : entries) {
      if (a != b) rows[std::max(number[a], number[b])].insert(std::min(number[a], number[b]));
    }
    return rows_of(rows);
  };
  std::vector<Index> number(count);
  for (Index v = 0; v < count; ++v)
    number[v] = v;
  const std::vector<Index> order = postorder(elimination_tree(numbered(number)));
  for (Index k = 0; k < count; ++k)
    number[order[k]] = k;
  return numbered(number);
}

/// By elimination: the rows below a pivot become neighbours.
std::vector<Index> counts_by_elimination(const LowerRows& rows) {
  std::vector<std::set<Index>> below(rows.count());
  for (Index i = 0; i < rows.count(); ++i) {
    for (const Index k : rows.of(i))
      below[k].insert(i);
  }
  std::vector<Index> counts;
  for (Index k = 0; k < rows.count(); ++k) {
    counts.push_back(static_cast<Index>(1 + below[k].size()));
    if (below[k].empty()) continue;
    const Index parent = *below[k].begin();
    below[parent].insert(std::next(below[k].begin()), below[k].end());
  }
  return counts;
}

TEST(Supernodes, CountTheEntriesOfColumnsAsEliminationDoes) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const LowerRows rows = random_pattern(1 + seed % 40, 0.5 + 0.01 * seed, seed);
    EXPECT_EQ(column_counts(rows, elimination_tree(rows)), counts_by_elimination(rows)) << seed;
  }
}

TEST(Supernodes, HoldTheRowsOfEachColumn) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const LowerRows rows = random_pattern(60, 1.5, seed);
    const auto parent = elimination_tree(rows);
    const auto counts = counts_by_elimination(rows);
    const Supernodes tree = find_supernodes(rows, parent);
    for (std::size_t s = 0; s < tree.count(); ++s) {
      const auto below = tree.rows(s);
      EXPECT_TRUE(std::is_sorted(below.begin(), below.end()));
      EXPECT_EQ(std::adjacent_find(below.begin(), below.end()), below.end());
      // The last column has no zeros below it: its count is that of the bundle.
      EXPECT_EQ(1 + below.size(), counts[tree.first[s + 1] - 1]) << seed;
    }
  }
}

}  // namespace
}  // namespace planish
