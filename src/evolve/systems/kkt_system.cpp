#include "evolve/systems/kkt_system.h"

#include <algorithm>
#include <utility>

#include "solve/dissection.h"

namespace planish {

KktSystem::KktSystem(const AngleJacobian& jacobian, const PatchState& state,
                     const ForPairs& for_pairs, const SparseMatrix& square, Moves moves,
                     Precision precision, const ThreadPool& pool)
    : jacobian_(jacobian),
      inner_(static_cast<Index>(jacobian.row_count())),
      count_(static_cast<Index>(jacobian.column_count())),
      moves_(moves) {
  pool.stop_if_cancelled();
  find_pairs(for_pairs, square);
  pool.stop_if_cancelled();
  lay_out();
  pool.stop_if_cancelled();
  solver_.emplace(lower_, elimination_order(state), precision, &pool);
}

/// Calls visit(v, w, full) for the vertices of every term, also for those that meet in another
/// term.
void KktSystem::for_all_pairs(const ForPairs& for_pairs, const SparseMatrix& square,
                              const std::function<void(Index, Index, bool)>& visit) const {
  const auto add = [&](Index v, Index w, bool full) {
    if (v != w && v < count_ && w < count_) visit(std::min(v, w), std::max(v, w), full);
  };
  for_pairs([&](Index v, Index w) { add(v, w, true); });
  for (Index v = 0; v < inner_; ++v) {
    for (const Index w : jacobian_.ring(v))
      add(v, w, true);
  }
  for (int v = 0; v < square.outerSize(); ++v) {
    for (SparseMatrix::InnerIterator entry(square, v); entry; ++entry)
      add(static_cast<Index>(v), static_cast<Index>(entry.row()), false);
  }
}

void KktSystem::find_pairs(const ForPairs& for_pairs, const SparseMatrix& square) {
  struct Partner {
    Index vertex;
    bool full;
  };
  std::vector<std::size_t> start(count_ + 1, 0);
  for_all_pairs(for_pairs, square, [&](Index first, Index, bool) { ++start[first + 1]; });
  for (Index v = 0; v < count_; ++v)
    start[v + 1] += start[v];
  std::vector<Partner> partners(start.back());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for_all_pairs(for_pairs, square, [&](Index first, Index second, bool full) {
    partners[next[first]++] = {second, full};
  });
  pair_start_.assign(count_ + 1, 0);
  for (Index v = 0; v < count_; ++v) {
    const std::span<Partner> own(partners.data() + start[v], start[v + 1] - start[v]);
    std::sort(own.begin(), own.end(),
              [](const Partner& a, const Partner& b) { return a.vertex < b.vertex; });
    for (std::size_t k = 0; k < own.size(); ++k) {
      const bool again = k > 0 && own[k].vertex == own[k - 1].vertex;
      if (!again) pairs_.push_back({own[k].vertex});
      if (own[k].full) pairs_.back().first_start = 0;  // until lay_out()
    }
    pair_start_[v + 1] = pairs_.size();
  }
  pairs_.shrink_to_fit();
}

/// The lower half, column by column, zero but for ones where what is held meets itself.
void KktSystem::lay_out() {
  std::vector<int> starts = {0}, rows;
  own_start_.resize(count_);
  for (Index v = 0; v < count_; ++v) {
    for (int part = 0; part < parts(v); ++part) {
      own_start_[v][static_cast<std::size_t>(part)] = static_cast<std::uint32_t>(rows.size());
      for (int row = part; row < parts(v); ++row)
        rows.push_back(unknown(v, row));
      for (std::size_t p = pair_start_[v]; p < pair_start_[v + 1]; ++p) {
        Entries& pair = pairs_[p];
        const bool of_multiplier = part == moves(v);
        if (!pair.is_full() && !of_multiplier) continue;
        if (part == 0 && pair.is_full()) pair.first_start = static_cast<std::uint32_t>(rows.size());
        if (of_multiplier) pair.multiplier_start = static_cast<std::uint32_t>(rows.size());
        for (int row = pair.is_full() ? 0 : moves(pair.second); row < parts(pair.second); ++row)
          rows.push_back(unknown(pair.second, row));
      }
      starts.push_back(static_cast<int>(rows.size()));
    }
  }
  const auto size = static_cast<int>(starts.size()) - 1;
  const std::vector<double> values(rows.size(), 0.0);
  lower_ = Eigen::Map<const SparseMatrix>(size, size, static_cast<int>(rows.size()), starts.data(),
                                          rows.data(), values.data());
}

KktSystem::Pair KktSystem::pair_of(Index v, Index w) const {
  if (v >= count_ || w >= count_) return k_none;
  const auto [first, second] = std::minmax(v, w);
  const auto begin = pairs_.begin() + static_cast<std::ptrdiff_t>(pair_start_[first]);
  const auto end = pairs_.begin() + static_cast<std::ptrdiff_t>(pair_start_[first + 1]);
  const auto found = std::lower_bound(
      begin, end, second, [](const Entries& pair, Index number) { return pair.second < number; });
  return static_cast<Pair>(found - pairs_.begin());
}

/// Where the entries of a pair start in the column of a part of its first vertex. Of its moves the
/// columns hold the same pairs, each after the vertex's own entries, which are one fewer from
/// column to column.
std::size_t KktSystem::start_of(Index first, const Entries& pair, std::size_t part) const {
  if (static_cast<int>(part) == moves(first)) return pair.multiplier_start;
  const auto& own = own_start_[first];
  return pair.first_start + (own[part] - own[0]) - part;
}

std::vector<Index> KktSystem::elimination_order(const PatchState& state) const {
  std::vector<std::vector<Index>> neighbours(count_);
  for (Index v = 0; v < count_; ++v) {
    for (std::size_t p = pair_start_[v]; p < pair_start_[v + 1]; ++p) {
      neighbours[v].push_back(pairs_[p].second);
      neighbours[pairs_[p].second].push_back(v);
    }
  }
  Graph graph;
  for (std::vector<Index>& of_vertex : neighbours) {
    std::sort(of_vertex.begin(), of_vertex.end());
    graph.neighbours.insert(graph.neighbours.end(), of_vertex.begin(), of_vertex.end());
    graph.start.push_back(graph.neighbours.size());
  }
  std::vector<Index> order;
  for (const Index v : nested_dissection(first_positions(state, count_), graph)) {
    for (int part = 0; part < parts(v); ++part)
      order.push_back(static_cast<Index>(unknown(v, part)));
  }
  return order;
}

void KktSystem::clear(std::vector<Vec3> directions, double unit) {
  directions_ = std::move(directions);
  unit_ = unit;
  std::fill_n(lower_.valuePtr(), lower_.nonZeros(), 0.0);
  for (Index v = 0; v < count_; ++v) {
    if (jacobian_.is_movable(v)) continue;
    for (int part = 0; part < moves(v); ++part)
      lower_.valuePtr()[own_start_[v][static_cast<std::size_t>(part)]] = 1.0;
  }
}

/// s a b^T: rows of the second vertex, columns of the first.
void KktSystem::add_product(Index first, const Entries& pair, double scale, Vec3 rows,
                            Vec3 columns) {
  const std::array<double, 3> by_column = along_moves(first, scale * columns),
                              by_row = along_moves(pair.second, rows);
  const auto column_count = static_cast<std::size_t>(moves(first)),
             row_count = static_cast<std::size_t>(moves(pair.second));
  for (std::size_t part = 0; part < column_count; ++part) {
    double* value = lower_.valuePtr() + start_of(first, pair, part);
    for (std::size_t row = 0; row < row_count; ++row)
      value[row] += by_column[part] * by_row[row];
  }
}

void KktSystem::add_own(Index v, double scale, Vec3 g) {
  add_vertex(v, {scale * g.x * g.x, scale * g.x * g.y, scale * g.x * g.z, scale * g.y * g.y,
                 scale * g.y * g.z, scale * g.z * g.z});
}

void KktSystem::add_vertex(Index v, const Block& block) {
  if (!jacobian_.is_movable(v)) return;
  double* values = lower_.valuePtr();
  const auto& start = own_start_[v];
  if (moves(v) == 1) {
    const Vec3 a = direction(v);
    values[start[0]] += a.x * (block.xx * a.x + 2.0 * (block.xy * a.y + block.xz * a.z)) +
                        a.y * (block.yy * a.y + 2.0 * block.yz * a.z) + a.z * block.zz * a.z;
    return;
  }
  values[start[0]] += block.xx;
  values[start[0] + 1] += block.xy;
  values[start[0] + 2] += block.xz;
  values[start[1]] += block.yy;
  values[start[1] + 1] += block.yz;
  values[start[2]] += block.zz;
}

void KktSystem::add_scalar(Index v, Index w, double scale, double value) {
  if (!jacobian_.is_movable(v) || !jacobian_.is_movable(w)) return;
  double* values = lower_.valuePtr();
  if (v == w) {
    for (int part = 0; part < moves(v); ++part)
      values[own_start_[v][static_cast<std::size_t>(part)]] += scale * value;
    return;
  }
  const auto [first, second] = std::minmax(v, w);
  const Entries& entries = pairs_[pair_of(first, second)];
  constexpr std::array<Vec3, 3> axes = {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
  for (int part = 0; part < moves(first); ++part) {
    const auto column = static_cast<std::size_t>(part);
    const std::array<double, 3> along =
        along_moves(second, moves(first) == 1 ? direction(first) : axes[column]);
    double* start = values + start_of(first, entries, column);
    for (std::size_t row = 0; row < static_cast<std::size_t>(moves(second)); ++row)
      start[row] += scale * along[row] * value;
  }
}

/// J is minus the Jacobian of the angle sums.
void KktSystem::fill_jacobian() {
  double* values = lower_.valuePtr();
  for (Index v = 0; v < count_; ++v) {
    if (!jacobian_.is_movable(v)) continue;
    for (const AngleJacobian::Entry& entry : jacobian_.column(v)) {
      const auto own = along_moves(v, jacobian_.gradient(entry.entry));
      const auto count = static_cast<std::size_t>(moves(v)),
                 last = static_cast<std::size_t>(moves(entry.row));  // the multiplier's part
      for (std::size_t part = 0; part < count; ++part) {
        if (entry.row == v) {
          values[own_start_[v][part] + last - part] = -unit_ * own[part];
          continue;
        }
        const Entries& pair = pairs_[pair_of(v, entry.row)];
        values[v < entry.row ? start_of(v, pair, part) + last
                             : start_of(entry.row, pair, last) + part] = -unit_ * own[part];
      }
    }
  }
}

void KktSystem::fill_square(const SparseMatrix& square, double c) {
  double* values = lower_.valuePtr();
  for (Index v = 0; v < inner_; ++v) {
    const Entries* pair = pairs_.data() + pair_start_[v];  // in order, as the entries are
    for (SparseMatrix::InnerIterator entry(square, static_cast<int>(v)); entry; ++entry) {
      const auto w = static_cast<Index>(entry.row());
      if (w == v) {
        values[own_start_[v][static_cast<std::size_t>(moves(v))]] = -c * entry.value();
        continue;
      }
      while (pair->second != w)
        ++pair;
      values[pair->multiplier_start + (pair->is_full() ? moves(w) : 0)] = -c * entry.value();
    }
  }
}

bool KktSystem::factor(const SparseMatrix& square, double c, ThreadPool& pool) {
  fill_jacobian();
  fill_square(square, c);
  return solver_->factor(lower_, pool);
}

Positions KktSystem::solve(const Positions& force, const Eigen::VectorXd& angle_change,
                           ThreadPool& pool, double accuracy) {
  Eigen::VectorXd right = Eigen::VectorXd::Zero(lower_.rows());
  for (Index v = 0; v < count_; ++v) {
    if (v < inner_) right[multiplier(v)] = angle_change[v];
    if (!jacobian_.is_movable(v)) continue;
    const std::array<double, 3> own = along_moves(v, force[v]);
    for (int part = 0; part < moves(v); ++part)
      right[unknown(v, part)] = own[static_cast<std::size_t>(part)];
  }
  const Eigen::VectorXd solution = solver_->solve(lower_, right, pool, accuracy);
  Positions step(count_);
  for (Index v = 0; v < count_; ++v) {
    if (jacobian_.is_movable(v)) step[v] = move_of(v, solution);
  }
  return step;
}

Vec3 KktSystem::move_of(Index v, const Eigen::VectorXd& solution) const {
  if (moves(v) == 1) return (unit_ * solution[unknown(v, 0)]) * direction(v);
  return unit_ * Vec3{solution[unknown(v, 0)], solution[unknown(v, 1)], solution[unknown(v, 2)]};
}

}  // namespace planish
