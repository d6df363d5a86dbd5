#include "energy/angle_jacobian.h"

#include <limits>
#include <new>
#include <utility>

namespace planish {

AngleJacobian::AngleJacobian(std::vector<std::span<const Index>> rings,
                             std::vector<unsigned char> movable, std::vector<HoleBorder> holes)
    : AngleJacobian(std::move(rings), std::move(movable), std::move(holes), {}) {}

AngleJacobian::AngleJacobian(std::vector<std::span<const Index>> rings,
                             std::vector<unsigned char> movable, std::vector<HoleBorder> holes,
                             std::vector<Index> vertices)
    : vertex_of_(std::move(vertices)),
      rings_(std::move(rings)),
      movable_(std::move(movable)),
      holes_(std::move(holes)) {
  row_start_.push_back(0);
  for (const auto& ring : rings_)
    row_start_.push_back(row_start_.back() + 1 + ring.size());
  for (const HoleBorder& hole : holes_) {
    for (int row = 0; row < 3; ++row)
      row_start_.push_back(row_start_.back() + hole.around.size());
  }
  if (row_start_.back() > std::numeric_limits<std::uint32_t>::max()) throw std::bad_alloc();
  gradients_.resize(row_start_.back());
  find_columns();
}

AngleJacobian AngleJacobian::part(std::span<const Index> rows,
                                  std::span<const unsigned char> movable) const {
  std::vector<std::span<const Index>> rings;
  for (const Index v : rows)
    rings.push_back(rings_[v]);
  return {std::move(rings), {movable.begin(), movable.end()}, {}, {rows.begin(), rows.end()}};
}

/// Minus the factors times the gradient.
void AngleJacobian::add_to_hole_rows(std::size_t hole, Index v,
                                     const std::array<double, 3>& factors, Vec3 gradient) {
  if (!is_movable(v)) return;
  const std::vector<Index>& around = holes_[hole].around;
  const auto place = std::lower_bound(around.begin(), around.end(), v) - around.begin();
  for (std::size_t row = 0; row < 3; ++row)
    gradients_[row_start_[angle_count() + 3 * hole + row] + static_cast<std::size_t>(place)] +=
        -factors[row] * gradient;
}

void AngleJacobian::find_columns() {
  column_start_.assign(column_count() + 1, 0);
  const auto for_entries = [&](const auto& visit) {
    for (Index row = 0; row < rings_.size(); ++row) {
      std::size_t entry = row_start_[row];
      if (const Index v = vertex_of(row); is_movable(v)) visit(row, v, entry);
      for (const Index w : rings_[row]) {
        ++entry;
        if (is_movable(w)) visit(row, w, entry);
      }
    }
    for (std::size_t row = rings_.size(); row < row_count(); ++row) {
      std::size_t entry = row_start_[row];
      for (const Index v : holes_[(row - rings_.size()) / 3].around) {
        if (is_movable(v)) visit(static_cast<Index>(row), v, entry);
        ++entry;
      }
    }
  };
  for_entries([&](Index, Index v, std::size_t) { ++column_start_[v + 1]; });
  for (std::size_t v = 0; v < column_count(); ++v)
    column_start_[v + 1] += column_start_[v];
  columns_.resize(column_start_.back());
  std::vector<std::size_t> next(column_start_.begin(), column_start_.end() - 1);
  for_entries([&](Index row, Index v, std::size_t entry) {
    columns_[next[v]++] = {row, static_cast<std::uint32_t>(entry)};
  });
}

Eigen::VectorXd AngleJacobian::times(std::span<const Vec3> dx) const {
  Eigen::VectorXd product = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(row_count()));
  for (Index v = 0; v < column_count(); ++v) {
    for (const Entry& entry : column(v))
      product[entry.row] += dot(gradients_[entry.entry], dx[v]);
  }
  return product;
}

std::vector<Vec3> AngleJacobian::transposed_times(const Eigen::VectorXd& y,
                                                  ThreadPool& pool) const {
  std::vector<Vec3> product(column_count());
  pool.for_ranges(column_count(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      for (const Entry& entry : column(static_cast<Index>(v)))
        product[v] += y[entry.row] * gradients_[entry.entry];
    }
  });
  return product;
}

}  // namespace planish
