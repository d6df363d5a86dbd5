#include "evolve/systems/angle_jacobian.h"

#include <limits>
#include <new>
#include <utility>

#include "geometry/angle_gradient.h"

namespace planish {

namespace {

// Rows that share a vertex make a dense block of A A^T; a larger one than this is not worth it.
constexpr std::size_t k_most_neighbours = 256;

/// By column.
std::vector<unsigned char> movable_in(const PatchState& state,
                                      std::span<const std::span<const Index>> rings,
                                      std::span<const unsigned char> border_movable) {
  std::vector<unsigned char> movable;
  for (Index v = 0; v < rings.size(); ++v)
    movable.push_back(!state.is_fixed(v) && rings[v].size() <= k_most_neighbours ? 1 : 0);
  movable.insert(movable.end(), border_movable.begin(), border_movable.end());
  return movable;
}

}  // namespace

AngleJacobian::AngleJacobian(const PatchState& state, std::span<const unsigned char> border_movable)
    : state_(state),
      rings_(rings_by_vertex(state.plan())),
      movable_(movable_in(state, rings_, border_movable)) {
  lay_out();
}

AngleJacobian::AngleJacobian(const PatchState& state, std::vector<Index> vertices,
                             std::vector<std::span<const Index>> rings,
                             std::vector<unsigned char> movable)
    : state_(state),
      vertex_of_(std::move(vertices)),
      rings_(std::move(rings)),
      movable_(std::move(movable)) {
  lay_out();
}

void AngleJacobian::lay_out() {
  row_start_.push_back(0);
  for (const auto& ring : rings_)
    row_start_.push_back(row_start_.back() + 1 + ring.size());
  if (row_start_.back() > std::numeric_limits<std::uint32_t>::max()) throw std::bad_alloc();
  gradients_.resize(row_start_.back());
  find_columns();
}

AngleJacobian AngleJacobian::part(std::span<const Index> rows,
                                  std::span<const unsigned char> movable) const {
  std::vector<std::span<const Index>> rings;
  for (const Index v : rows)
    rings.push_back(rings_[v]);
  return {state_, {rows.begin(), rows.end()}, std::move(rings), {movable.begin(), movable.end()}};
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

void AngleJacobian::update(ThreadPool& pool) {
  pool.for_ranges(rings_.size(), 512, [this](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const Index v = vertex_of(static_cast<Index>(row));
      const auto ring = rings_[row];
      Vec3* gradient = gradients_.data() + row_start_[row];
      std::fill_n(gradient, 1 + ring.size(), Vec3{});
      const Vec3 p = state_.position(v);
      for (std::size_t j = 0; j < ring.size(); ++j) {
        const std::size_t k = j + 1 < ring.size() ? j + 1 : 0;
        const AngleGradient corner =
            angle_gradient(p, state_.position(ring[j]), state_.position(ring[k]));
        gradient[0] += corner.at_p;
        gradient[1 + j] += corner.at_q;
        gradient[1 + k] += corner.at_r;
      }
      if (!is_movable(v)) gradient[0] = {};
      for (std::size_t j = 0; j < ring.size(); ++j) {
        if (!is_movable(ring[j])) gradient[1 + j] = {};
      }
    }
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
