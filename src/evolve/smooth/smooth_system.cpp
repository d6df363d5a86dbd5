#include "evolve/smooth/smooth_system.h"

#include <algorithm>
#include <utility>

#include "solve/dissection.h"

namespace planish {

namespace {

template <class Visit>
void for_pairs(std::size_t corners, Visit visit) {
  for (std::size_t i = 0; i < corners; ++i) {
    for (std::size_t j = i + 1; j < corners; ++j)
      visit(i, j);
  }
}

}  // namespace

SmoothSystem::SmoothSystem(const AngleJacobian& jacobian, const PatchState& state,
                           const HingeTerms& hinges, const ShapeGuard& guard,
                           const SparseMatrix& square, SmoothMoves moves, const ThreadPool& pool,
                           std::vector<BorderMotion::Bend> bends)
    : jacobian_(jacobian),
      hinges_(hinges),
      guard_(guard),
      bends_(std::move(bends)),
      inner_(static_cast<Index>(jacobian.row_count())),
      count_(static_cast<Index>(jacobian.column_count())),
      inner_moves_(moves == SmoothMoves::free ? 3 : 1) {
  pool.stop_if_cancelled();
  find_pairs(hinges, guard, square);
  pool.stop_if_cancelled();
  lay_out();
  find_terms(hinges, guard);
  pool.stop_if_cancelled();
  solver_.emplace(lower_, elimination_order(state), step_precision(inner_), &pool);
}

/// Calls visit(v, w, full) for the vertices of every term, also for those that meet in another
/// term.
template <class Visit>
void SmoothSystem::for_pairs_of_terms(const HingeTerms& hinges, const ShapeGuard& guard,
                                      const SparseMatrix& square, Visit visit) const {
  const auto add = [&](Index v, Index w, bool full) {
    if (v != w && v < count_ && w < count_) visit(std::min(v, w), std::max(v, w), full);
  };
  for (std::size_t h = 0; h < hinges.size(); ++h) {
    const auto& corners = hinges.corners(h);
    for_pairs(4, [&](std::size_t i, std::size_t j) { add(corners[i], corners[j], true); });
  }
  for (std::size_t e = 0; e < guard.edge_count(); ++e)
    add(guard.edge(e)[0], guard.edge(e)[1], true);
  for (const BorderMotion::Bend& bend : bends_)
    for_pairs(3,
              [&](std::size_t i, std::size_t j) { add(bend.vertices[i], bend.vertices[j], true); });
  for (Index v = 0; v < inner_; ++v) {
    for (const Index w : jacobian_.ring(v))
      add(v, w, true);
  }
  for (int v = 0; v < square.outerSize(); ++v) {
    for (SparseMatrix::InnerIterator entry(square, v); entry; ++entry)
      add(static_cast<Index>(v), static_cast<Index>(entry.row()), false);
  }
}

void SmoothSystem::find_pairs(const HingeTerms& hinges, const ShapeGuard& guard,
                              const SparseMatrix& square) {
  struct Partner {
    Index vertex;
    bool full;
  };
  std::vector<std::size_t> start(count_ + 1, 0);
  for_pairs_of_terms(hinges, guard, square, [&](Index first, Index, bool) { ++start[first + 1]; });
  for (Index v = 0; v < count_; ++v)
    start[v + 1] += start[v];
  std::vector<Partner> partners(start.back());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for_pairs_of_terms(hinges, guard, square, [&](Index first, Index second, bool full) {
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
void SmoothSystem::lay_out() {
  std::vector<int> starts = {0}, rows;
  own_start_.resize(count_);
  for (Index v = 0; v < count_; ++v) {
    for (int part = 0; part < parts(v); ++part) {
      own_start_[v][static_cast<std::size_t>(part)] = static_cast<std::uint32_t>(rows.size());
      for (int row = part; row < parts(v); ++row)
        rows.push_back(unknown(v, row));
      for (std::size_t p = pair_start_[v]; p < pair_start_[v + 1]; ++p) {
        Pair& pair = pairs_[p];
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

SmoothSystem::PairIndex SmoothSystem::pair_of(Index v, Index w) const {
  if (v >= count_ || w >= count_) return k_none;
  const auto [first, second] = std::minmax(v, w);
  const auto begin = pairs_.begin() + static_cast<std::ptrdiff_t>(pair_start_[first]);
  const auto end = pairs_.begin() + static_cast<std::ptrdiff_t>(pair_start_[first + 1]);
  const auto found = std::lower_bound(
      begin, end, second, [](const Pair& pair, Index number) { return pair.second < number; });
  return static_cast<PairIndex>(found - pairs_.begin());
}

/// Where the entries of a pair start in the column of a part of its first vertex. Of its moves the
/// columns hold the same pairs, each after the vertex's own entries, which are one fewer from
/// column to column.
std::size_t SmoothSystem::start_of(Index first, const Pair& pair, std::size_t part) const {
  if (static_cast<int>(part) == moves(first)) return pair.multiplier_start;
  const auto& own = own_start_[first];
  return pair.first_start + (own[part] - own[0]) - part;
}

void SmoothSystem::find_terms(const HingeTerms& hinges, const ShapeGuard& guard) {
  const auto add = [this](std::vector<PairIndex>& pairs, const auto& corners) {
    for_pairs(corners.size(), [&](std::size_t i, std::size_t j) {
      pairs.push_back(pair_of(corners[i], corners[j]));
    });
  };
  hinge_pairs_.reserve(6 * hinges.size());
  edge_pairs_.reserve(guard.edge_count());
  for (std::size_t h = 0; h < hinges.size(); ++h)
    add(hinge_pairs_, hinges.corners(h));
  for (std::size_t e = 0; e < guard.edge_count(); ++e)
    add(edge_pairs_, guard.edge(e));
}

std::vector<Index> SmoothSystem::elimination_order(const PatchState& state) const {
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

void SmoothSystem::clear(Positions lines) {
  lines_ = std::move(lines);
  std::fill_n(lower_.valuePtr(), lower_.nonZeros(), 0.0);
  for (Index v = 0; v < count_; ++v) {
    if (jacobian_.is_movable(v)) continue;
    for (int part = 0; part < moves(v); ++part)
      lower_.valuePtr()[own_start_[v][static_cast<std::size_t>(part)]] = 1.0;
  }
}

/// s a b^T: rows of the second vertex, columns of the first.
void SmoothSystem::add_product(Index first, const Pair& pair, double scale, Vec3 rows,
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

void SmoothSystem::add_own(Index v, double scale, Vec3 g) {
  add_vertex(v, {scale * g.x * g.x, scale * g.x * g.y, scale * g.x * g.z, scale * g.y * g.y,
                 scale * g.y * g.z, scale * g.z * g.z});
}

void SmoothSystem::add_vertex(Index v, const Block& block) {
  if (!jacobian_.is_movable(v)) return;
  double* values = lower_.valuePtr();
  const auto& start = own_start_[v];
  if (moves(v) == 1) {
    const Vec3 a = lines_[v];
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

template <std::size_t n>
void SmoothSystem::add_term(std::span<const PairIndex> pairs, const std::array<Index, n>& corners,
                            double scale, const std::array<Vec3, n>& gradient) {
  for (std::size_t i = 0; i < n; ++i)
    add_own(corners[i], scale, gradient[i]);
  std::size_t next = 0;
  for_pairs(n, [&](std::size_t i, std::size_t j) {
    const PairIndex pair = pairs[next++];
    if (!jacobian_.is_movable(corners[i]) || !jacobian_.is_movable(corners[j])) return;
    const auto [first, second] = corners[i] < corners[j] ? std::pair{i, j} : std::pair{j, i};
    add_product(corners[first], pairs_[pair], scale, gradient[second], gradient[first]);
  });
}

/// Of three vertices, whose pairs are looked up.
void SmoothSystem::add_rare_term(const std::array<Index, 3>& corners, double scale,
                                 const std::array<Vec3, 3>& gradient) {
  std::array<PairIndex, 3> pairs;
  std::size_t next = 0;
  for_pairs(3,
            [&](std::size_t i, std::size_t j) { pairs[next++] = pair_of(corners[i], corners[j]); });
  add_term<3>(pairs, corners, scale, gradient);
}

void SmoothSystem::add_hinge(std::size_t hinge, double scale, const std::array<Vec3, 4>& gradient) {
  add_term<4>({hinge_pairs_.data() + 6 * hinge, 6}, hinges_.corners(hinge), scale, gradient);
}

void SmoothSystem::add_edge(std::size_t edge, double scale, const std::array<Vec3, 2>& gradient) {
  add_term<2>({edge_pairs_.data() + edge, 1}, guard_.edge(edge), scale, gradient);
}

void SmoothSystem::add_corner(std::size_t corner, double scale,
                              const std::array<Vec3, 3>& gradient) {
  add_rare_term(guard_.corner(corner), scale, gradient);
}

void SmoothSystem::add_bend(std::size_t number, double scale) {
  const BorderMotion::Bend& bend = bends_[number];
  for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    std::array<Vec3, 3> gradient;
    for (std::size_t k = 0; k < 3; ++k)
      gradient[k] = bend.weights[k] * axis;
    add_rare_term(std::to_array(bend.vertices), scale, gradient);
  }
}

/// J is minus the Jacobian of the angle sums.
void SmoothSystem::fill_jacobian() {
  double* values = lower_.valuePtr();
  for (Index v = 0; v < count_; ++v) {
    if (!jacobian_.is_movable(v)) continue;
    for (const AngleJacobian::Entry& entry : jacobian_.column(v)) {
      const auto own = along_moves(v, -1.0 * jacobian_.gradient(entry.entry));
      const auto count = static_cast<std::size_t>(moves(v)),
                 last = static_cast<std::size_t>(moves(entry.row));  // the multiplier's part
      for (std::size_t part = 0; part < count; ++part) {
        if (entry.row == v) {
          values[own_start_[v][part] + last - part] = own[part];
          continue;
        }
        const Pair& pair = pairs_[pair_of(v, entry.row)];
        values[v < entry.row ? start_of(v, pair, part) + last
                             : start_of(entry.row, pair, last) + part] = own[part];
      }
    }
  }
}

void SmoothSystem::fill_square(const SparseMatrix& square, double c) {
  double* values = lower_.valuePtr();
  for (Index v = 0; v < inner_; ++v) {
    const Pair* pair = pairs_.data() + pair_start_[v];  // in order, as the entries are
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

bool SmoothSystem::factor(const SparseMatrix& square, double c, ThreadPool& pool) {
  fill_jacobian();
  fill_square(square, c);
  return solver_->factor(lower_, pool);
}

Positions SmoothSystem::solve(const Positions& force, const Eigen::VectorXd& angle_change,
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

Vec3 SmoothSystem::move_of(Index v, const Eigen::VectorXd& solution) const {
  if (moves(v) == 1) return solution[unknown(v, 0)] * lines_[v];
  return {solution[unknown(v, 0)], solution[unknown(v, 1)], solution[unknown(v, 2)]};
}

}  // namespace planish
