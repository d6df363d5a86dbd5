#include "optimize/block_matrix.h"

#include <algorithm>

namespace planish {

BlockMatrix::BlockMatrix(std::span<const unsigned char> sizes, const ForPairs& for_pairs) {
  for (const unsigned char size : sizes)
    first_.push_back(first_.back() + size);
  find_pairs(for_pairs);
  lay_out();
}

void BlockMatrix::find_pairs(const ForPairs& for_pairs) {
  const Index count = block_count();
  std::vector<std::size_t> start(count + 1, 0);
  for_pairs([&](Index a, Index b) {
    if (a != b) ++start[std::min(a, b) + 1];
  });
  for (Index a = 0; a < count; ++a)
    start[a + 1] += start[a];
  std::vector<Index> partners(start.back());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for_pairs([&](Index a, Index b) {
    if (a != b) partners[next[std::min(a, b)]++] = std::max(a, b);
  });
  pair_start_.assign(count + 1, 0);
  for (Index a = 0; a < count; ++a) {
    const auto begin = partners.begin() + static_cast<std::ptrdiff_t>(start[a]);
    const auto end = partners.begin() + static_cast<std::ptrdiff_t>(start[a + 1]);
    std::sort(begin, end);
    for (auto b = begin; b != end; ++b) {
      if (b == begin || *b != *(b - 1)) pairs_.push_back({*b, 0});
    }
    pair_start_[a + 1] = pairs_.size();
  }
  pairs_.shrink_to_fit();
}

void BlockMatrix::lay_out() {
  std::vector<int> starts = {0}, rows;
  for (Index a = 0; a < block_count(); ++a) {
    for (int column = 0; column < size(a); ++column) {
      for (int row = column; row < size(a); ++row)
        rows.push_back(unknown(a, row));
      for (std::size_t p = pair_start_[a]; p < pair_start_[a + 1]; ++p) {
        if (column == 0) pairs_[p].start = static_cast<std::uint32_t>(rows.size());
        for (int row = 0; row < size(pairs_[p].second); ++row)
          rows.push_back(unknown(pairs_[p].second, row));
      }
      starts.push_back(static_cast<int>(rows.size()));
    }
  }
  const auto count = static_cast<int>(starts.size()) - 1;
  const std::vector<double> values(rows.size(), 0.0);
  lower_ = Eigen::Map<const SparseMatrix>(count, count, static_cast<int>(rows.size()),
                                          starts.data(), rows.data(), values.data());
}

void BlockMatrix::clear() {
  std::fill_n(lower_.valuePtr(), lower_.nonZeros(), 0.0);
}

BlockMatrix::Pair BlockMatrix::pair_of(Index a, Index b) const {
  const auto [first, second] = std::minmax(a, b);
  if (second >= block_count()) return k_none;
  const auto begin = pairs_.begin() + static_cast<std::ptrdiff_t>(pair_start_[first]);
  const auto end = pairs_.begin() + static_cast<std::ptrdiff_t>(pair_start_[first + 1]);
  const auto found = std::lower_bound(begin, end, second, [](const Entries& entries, Index block) {
    return entries.second < block;
  });
  return found != end && found->second == second ? static_cast<Pair>(found - pairs_.begin())
                                                 : k_none;
}

}  // namespace planish
