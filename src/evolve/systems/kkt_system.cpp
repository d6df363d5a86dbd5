#include "evolve/systems/kkt_system.h"

#include <algorithm>
#include <utility>

#include "solve/dissection.h"

namespace planish {

KktSystem::KktSystem(const AngleJacobian& jacobian, const PatchState& state,
                     const ForPairs& for_pairs, const SparseMatrix& square, Moves moves,
                     Precision precision, const ThreadPool& pool, MirrorOrbits orbits)
    : jacobian_(jacobian),
      orbits_(std::move(orbits)),
      inner_(static_cast<Index>(orbits_.count(jacobian.angle_count()))),
      count_(static_cast<Index>(orbits_.count(jacobian.column_count()))),
      moves_(moves) {
  pool.stop_if_cancelled();
  matrix_ = matrix_with(for_pairs, square);
  pool.stop_if_cancelled();
  solver_.emplace(matrix_.lower(), elimination_order(state), precision, &pool);
}

BlockMatrix KktSystem::matrix_with(const ForPairs& for_pairs, const SparseMatrix& square) const {
  std::vector<unsigned char> sizes;
  for (Index orbit = 0; orbit < count_; ++orbit) {
    sizes.push_back(static_cast<unsigned char>(move_count(orbit)));
    if (orbit < inner_) sizes.push_back(1);
  }
  sizes.resize(sizes.size() + 3 * jacobian_.holes().size(), 1);
  return {sizes, [&](const BlockMatrix::VisitPair& visit) {
            for_pairs([&](Index v, Index w) {
              const Index first = orbits_.orbit_of(v), second = orbits_.orbit_of(w);
              if (first < count_ && second < count_) visit(moves_of(first), moves_of(second));
            });
            for (Index v = 0; v < jacobian_.column_count(); ++v) {
              for (const AngleJacobian::Entry& entry : jacobian_.column(v))
                visit(moves_of(orbits_.orbit_of(v)), multiplier_of(orbits_.orbit_of(entry.row)));
            }
            for (int v = 0; v < square.outerSize(); ++v) {
              for (SparseMatrix::InnerIterator entry(square, v); entry; ++entry)
                visit(multiplier_of(static_cast<Index>(v)),
                      multiplier_of(static_cast<Index>(entry.row())));
            }
          }};
}

std::vector<Index> KktSystem::elimination_order(const PatchState& state) const {
  const auto orbit_of = [&](Index block) {
    return block < 2 * inner_ ? block / 2 : block - inner_;
  };
  std::vector<std::vector<Index>> neighbours(count_);
  const Index first_of_holes = inner_ + count_;
  for (Index block = 0; block < first_of_holes; ++block) {
    const Index v = orbit_of(block);
    matrix_.for_pairs_of(block, [&](Index other, BlockMatrix::Pair) {
      const Index w = orbit_of(other);
      if (other >= first_of_holes || v == w) return;
      neighbours[v].push_back(w);
      neighbours[w].push_back(v);
    });
  }
  Graph graph;
  for (std::vector<Index>& of_orbit : neighbours) {
    std::sort(of_orbit.begin(), of_orbit.end());
    const auto end = std::unique(of_orbit.begin(), of_orbit.end());
    graph.neighbours.insert(graph.neighbours.end(), of_orbit.begin(), end);
    graph.start.push_back(graph.neighbours.size());
  }
  Positions places;
  for (Index orbit = 0; orbit < count_; ++orbit)
    places.push_back(state.position(orbits_.first_of(orbit)));
  std::vector<Index> order;
  for (const Index v : nested_dissection(places, graph)) {
    for (int part = 0; part < move_count(v); ++part)
      order.push_back(static_cast<Index>(matrix_.unknown(moves_of(v), part)));
    if (v < inner_) order.push_back(static_cast<Index>(matrix_.unknown(multiplier_of(v), 0)));
  }
  // The rows of holes meet many others.
  for (Index block = first_of_holes; block < matrix_.block_count(); ++block)
    order.push_back(static_cast<Index>(matrix_.unknown(block, 0)));
  return order;
}

void KktSystem::clear(std::vector<Vec3> directions, double unit) {
  directions_ = directions_by_orbit(std::move(directions));
  unit_ = unit;
  matrix_.clear();
  hold_unused_moves();
}

/// On the plane a vertex moves along it: a direction nearly across it is none.
std::vector<Vec3> KktSystem::directions_by_orbit(std::vector<Vec3> directions) const {
  constexpr double least = 0.1;
  if (!orbits_.is_symmetric() || directions.empty()) return directions;
  const auto inner = static_cast<Index>(jacobian_.angle_count());
  std::vector<Vec3> by_orbit;
  for (Index orbit = 0; orbit < count_; ++orbit) {
    if (move_count(orbit) != 1) continue;
    const Index v = orbits_.first_of(orbit);
    const Vec3 along =
        orbits_.carried(v, directions[v < inner || moves_.inner == 1 ? v : v - inner]);
    const double length = norm(along);
    by_orbit.push_back(length < least ? Vec3{} : (1.0 / length) * along);
  }
  return by_orbit;
}

/// Unknowns in which nothing moves get 1 on the diagonal: those of what is held, and on the plane
/// those across it.
void KktSystem::hold_unused_moves() {
  for (Index orbit = 0; orbit < count_; ++orbit) {
    const Index v = orbits_.first_of(orbit), moves = moves_of(orbit);
    const bool along_one = move_count(orbit) == 1;
    if (!is_movable(v) || (along_one && direction(orbit) == Vec3{})) {
      for (int part = 0; part < move_count(orbit); ++part)
        *matrix_.own(moves, part) = 1.0;
    } else if (orbits_.is_on_plane(v) && !along_one) {
      add_own(orbit, 1.0, orbits_.normal());
    }
  }
}

/// s a b^T: rows of the second vertex, columns of the first.
void KktSystem::add_product(Index first, Index second, BlockMatrix::Pair pair, double scale,
                            Vec3 rows, Vec3 columns) {
  const std::array<double, 3> by_column = along_moves(first, scale * columns),
                              by_row = along_moves(second, rows);
  const auto column_count = static_cast<std::size_t>(move_count(first)),
             row_count = static_cast<std::size_t>(move_count(second));
  for (std::size_t column = 0; column < column_count; ++column) {
    double* values = matrix_.entries(moves_of(first), pair, static_cast<int>(column));
    for (std::size_t row = 0; row < row_count; ++row)
      values[row] += by_column[column] * by_row[row];
  }
}

void KktSystem::add_own(Index orbit, double scale, Vec3 g) {
  add_block(orbit, {scale * g.x * g.x, scale * g.x * g.y, scale * g.x * g.z, scale * g.y * g.y,
                    scale * g.y * g.z, scale * g.z * g.z});
}

void KktSystem::add_vertex(Index v, const Block& block) {
  if (!is_movable(v)) return;
  if (!orbits_.is_symmetric()) return add_block(v, block);
  const Vec3 x = orbits_.carried(v, {block.xx, block.xy, block.xz}),
             y = orbits_.carried(v, {block.xy, block.yy, block.yz}),
             z = orbits_.carried(v, {block.xz, block.yz, block.zz});
  const Vec3 of_x = orbits_.carried(v, {x.x, y.x, z.x}), of_y = orbits_.carried(v, {x.y, y.y, z.y}),
             of_z = orbits_.carried(v, {x.z, y.z, z.z});
  add_block(orbits_.orbit_of(v), {of_x.x, of_x.y, of_x.z, of_y.y, of_y.z, of_z.z});
}

/// To what an orbit that may move has with itself.
void KktSystem::add_block(Index orbit, const Block& block) {
  const Index moves = moves_of(orbit);
  if (move_count(orbit) == 1) {
    const Vec3 a = direction(orbit);
    *matrix_.own(moves, 0) += a.x * (block.xx * a.x + 2.0 * (block.xy * a.y + block.xz * a.z)) +
                              a.y * (block.yy * a.y + 2.0 * block.yz * a.z) + a.z * block.zz * a.z;
    return;
  }
  double *x = matrix_.own(moves, 0), *y = matrix_.own(moves, 1), *z = matrix_.own(moves, 2);
  x[0] += block.xx;
  x[1] += block.xy;
  x[2] += block.xz;
  y[0] += block.yy;
  y[1] += block.yz;
  z[0] += block.zz;
}

void KktSystem::add_scalar(Index v, Index w, BlockMatrix::Pair pair, double scale, double value) {
  if (!is_movable(v) || !is_movable(w)) return;
  const bool in_order = orbits_.orbit_of(v) < orbits_.orbit_of(w);
  const Index a = in_order ? v : w, b = in_order ? w : v;
  const Index first = orbits_.orbit_of(a), second = orbits_.orbit_of(b);
  if (v == w && !orbits_.is_on_plane(v)) {
    for (int part = 0; part < move_count(first); ++part)
      *matrix_.own(moves_of(first), part) += scale * value;
    return;
  }
  // Of a vertex and its image there are two entries.
  const double factor = first == second && v != w ? 2.0 * scale : scale;
  for (int column = 0; column < move_count(first); ++column) {
    const std::array<double, 3> along = along_moves_at(b, unit_move(a, column));
    double* values = first == second ? matrix_.own(moves_of(first), column) - column
                                     : matrix_.entries(moves_of(first), pair, column);
    for (int row = first == second ? column : 0; row < move_count(second); ++row)
      values[row] += factor * along[static_cast<std::size_t>(row)] * value;
  }
}

Vec3 KktSystem::unit_move(Index v, int part) const {
  constexpr std::array<Vec3, 3> axes = {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
  const Index orbit = orbits_.orbit_of(v);
  return orbits_.carried(
      v, move_count(orbit) == 1 ? direction(orbit) : axes[static_cast<std::size_t>(part)]);
}

/// J is minus the Jacobian of the angle sums. All of it is 0 before.
void KktSystem::fill_jacobian() {
  for (Index v = 0; v < jacobian_.column_count(); ++v) {
    if (!is_movable(v)) continue;
    const Index orbit = orbits_.orbit_of(v), moves = moves_of(orbit);
    for (const AngleJacobian::Entry& entry : jacobian_.column(v)) {
      const auto parts = along_moves_at(v, jacobian_.gradient(entry.entry));
      const Index multiplier = multiplier_of(orbits_.orbit_of(entry.row));
      const BlockMatrix::Pair pair = matrix_.pair_of(moves, multiplier);
      for (int part = 0; part < move_count(orbit); ++part) {
        double& value = moves < multiplier ? *matrix_.entries(moves, pair, part)
                                           : matrix_.entries(multiplier, pair, 0)[part];
        value += -unit_ * parts[static_cast<std::size_t>(part)];
      }
    }
  }
}

void KktSystem::fill_square(const SparseMatrix& square, double c) {
  for (int v = 0; v < square.outerSize(); ++v) {
    const Index first = multiplier_of(static_cast<Index>(v));
    for (SparseMatrix::InnerIterator entry(square, v); entry; ++entry) {
      const Index second = multiplier_of(static_cast<Index>(entry.row()));
      double* value = first == second ? matrix_.own(first, 0)
                                      : matrix_.entries(first, matrix_.pair_of(first, second), 0);
      *value = -c * entry.value();
    }
  }
}

bool KktSystem::factor(const SparseMatrix& square, double c, ThreadPool& pool) {
  fill_jacobian();
  fill_square(square, c);
  return solver_->factor(matrix_.lower(), pool);
}

Positions KktSystem::solve(const Positions& force, const Eigen::VectorXd& angle_change,
                           ThreadPool& pool, double accuracy) {
  Eigen::VectorXd right = Eigen::VectorXd::Zero(matrix_.lower().rows());
  for (Index row = 0; row < jacobian_.row_count(); ++row)
    right[matrix_.unknown(multiplier_of(orbits_.orbit_of(row)), 0)] += angle_change[row];
  for (Index v = 0; v < jacobian_.column_count(); ++v) {
    if (!is_movable(v)) continue;
    const std::array<double, 3> parts = along_moves_at(v, force[v]);
    const Index orbit = orbits_.orbit_of(v);
    for (int part = 0; part < move_count(orbit); ++part)
      right[matrix_.unknown(moves_of(orbit), part)] += parts[static_cast<std::size_t>(part)];
  }
  const Eigen::VectorXd solution = solver_->solve(matrix_.lower(), right, pool, accuracy);
  Positions step(jacobian_.column_count());
  for (Index v = 0; v < step.size(); ++v) {
    if (is_movable(v)) step[v] = move_of(v, solution);
  }
  return step;
}

Vec3 KktSystem::move_of(Index v, const Eigen::VectorXd& solution) const {
  const Index orbit = orbits_.orbit_of(v);
  const auto part = [&](int number) { return solution[matrix_.unknown(moves_of(orbit), number)]; };
  if (move_count(orbit) == 1) return (unit_ * part(0)) * orbits_.carried(v, direction(orbit));
  return orbits_.carried(v, unit_ * Vec3{part(0), part(1), part(2)});
}

}  // namespace planish
