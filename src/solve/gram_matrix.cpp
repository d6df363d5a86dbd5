#include "solve/gram_matrix.h"

#include <algorithm>

namespace planish {

GramMatrix::GramMatrix(std::size_t rows, std::size_t columns, std::span<const Entry> entries) {
  std::vector<std::size_t> next(rows + 1, 0);
  for (const Entry& entry : entries)
    ++next[entry.row + 1];
  for (std::size_t r = 0; r < rows; ++r)
    next[r + 1] += next[r];
  std::vector<Term> all(entries.size());
  const std::vector<std::size_t> begin = next;
  for (const Entry& entry : entries)
    all[next[entry.row]++] = {entry.column, entry.value};
  // Those of one place summed; rows are short.
  rows_.start.push_back(0);
  columns_.start.assign(columns + 1, 0);
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t k = begin[r]; k < begin[r + 1]; ++k) {
      std::size_t at = rows_.start.back();
      while (at < rows_.terms.size() && rows_.terms[at].other != all[k].other)
        ++at;
      if (at < rows_.terms.size()) {
        rows_.terms[at].value += all[k].value;
      } else {
        rows_.terms.push_back(all[k]);
        ++columns_.start[all[k].other + 1];
      }
    }
    rows_.start.push_back(rows_.terms.size());
  }
  for (std::size_t c = 0; c < columns; ++c)
    columns_.start[c + 1] += columns_.start[c];
  columns_.terms.resize(rows_.terms.size());
  std::vector<std::size_t> place(columns_.start.begin(), columns_.start.end());
  for (Index r = 0; r < rows; ++r) {
    for (const Term& term : rows_.of(r))
      columns_.terms[place[term.other]++] = {r, term.value};
  }
}

SparseMatrix GramMatrix::lower() const {
  const std::size_t n = columns_.start.size() - 1;
  constexpr Index k_never = static_cast<Index>(-1);
  std::vector<int> start(1, 0), row_of;
  std::vector<double> values, sum(n, 0.0);
  std::vector<Index> seen_in(n, k_never);
  for (Index c = 0; c < n; ++c) {
    const std::size_t first = row_of.size();
    for (const Term& in_column : columns_.of(c)) {
      for (const Term& in_row : rows_.of(in_column.other)) {
        const Index r = in_row.other;
        if (r < c) continue;
        if (seen_in[r] != c) {
          seen_in[r] = c;
          sum[r] = 0.0;
          row_of.push_back(static_cast<int>(r));
        }
        sum[r] += in_column.value * in_row.value;
      }
    }
    std::sort(row_of.begin() + static_cast<std::ptrdiff_t>(first), row_of.end());
    for (std::size_t k = first; k < row_of.size(); ++k)
      values.push_back(sum[static_cast<std::size_t>(row_of[k])]);
    start.push_back(static_cast<int>(row_of.size()));
  }
  const auto size = static_cast<Eigen::Index>(n);
  return Eigen::Map<const SparseMatrix>(size, size, start.back(), start.data(), row_of.data(),
                                        values.data());
}

std::vector<double> GramMatrix::times(const Eigen::VectorXd& x) const {
  std::vector<double> product(rows_.start.size() - 1, 0.0);
  for (std::size_t r = 0; r < product.size(); ++r) {
    for (const Term& term : rows_.of(r))
      product[r] += term.value * x[static_cast<Eigen::Index>(term.other)];
  }
  return product;
}

}  // namespace planish
