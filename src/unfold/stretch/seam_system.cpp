#include "unfold/stretch/seam_system.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace planish {

namespace {

/// In units of lengths by pulls, both of which are near 1 for the whole disk.
constexpr double k_give = 1e-10;
constexpr double k_kept = 1e-10, k_rounding = 4e-16;

/// With the length that it is to have.
FlatEdge border_edge(const Disk& disk, const HeldBorder& border, std::size_t k) {
  const auto [from, to] = disk.border_edge(k);
  return {from, to, border.lengths.of_edges[k], 0.0};
}

/// Of vertices that share a turn, and of the ends of an edge with its pull.
BlockMatrix::ForPairs pairs_of_border(const Disk& disk, const HeldBorder& border) {
  return [&](const BlockMatrix::VisitPair& visit) {
    for (const TurnBending::Turn& turn : border.bend.turns()) {
      for (std::size_t k = 0; k < 3; ++k)
        visit(turn.vertices[k], turn.vertices[(k + 1) % 3]);
    }
    for (std::size_t k = 0; k < disk.border.size(); ++k) {
      const FlatEdge edge = border_edge(disk, border, k);
      for (const Index v : {edge.from, edge.to})
        visit(v, static_cast<Index>(disk.vertex_count + k));
    }
  };
}

}  // namespace

SeamSystem::SeamSystem(const Disk& disk, const HeldBorder& border, ThreadPool& pool)
    : StretchSystem(disk, disk.border.size(), pairs_of_border(disk, border), pool),
      border_(border),
      edges_of_(disk.triangles.size()) {
  find_edges_of_triangles();
  pulls_ = gaps_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(disk.border.size()));
  for (const TurnBending::Turn& turn : border.bend.turns())
    turn_pairs_.push_back(pairs_of(turn.vertices));
}

void SeamSystem::find_edges_of_triangles() {
  std::vector<std::size_t> edge_from(disk_.vertex_count, disk_.border.size());
  for (std::size_t k = 0; k < disk_.border.size(); ++k)
    edge_from[disk_.border[k]] = k;
  for (std::size_t t = 0; t < disk_.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const std::size_t k = edge_from[disk_.triangles[t][i]];
      if (k == disk_.border.size()) continue;
      if (border_edge(disk_, border_, k).to == disk_.triangles[t][(i + 1) % 3]) {
        edges_of_[t].push_back(static_cast<Index>(k));
      }
    }
  }
}

std::vector<Index> SeamSystem::elimination_order() const {
  std::vector<std::vector<std::size_t>> edges(disk_.vertex_count);
  for (std::size_t k = 0; k < disk_.border.size(); ++k) {
    edges[border_edge(disk_, border_, k).from].push_back(k);
    edges[border_edge(disk_, border_, k).to].push_back(k);
  }
  std::vector<char> is_begun(disk_.border.size(), 0);
  std::vector<Index> order;
  order.reserve(static_cast<std::size_t>(hessian().rows()));
  for (const Index v : border_.order) {
    for (int axis = 0; axis < matrix_.size(v); ++axis)
      order.push_back(static_cast<Index>(matrix_.unknown(v, axis)));
    for (const std::size_t k : edges[v]) {
      if (is_begun[k] != 0) order.push_back(static_cast<Index>(row_of_pull(k)));
      is_begun[k] = 1;
    }
  }
  return order;
}

Eigen::VectorXd SeamSystem::gaps(const std::vector<Vec2>& flat) const {
  Eigen::VectorXd gaps = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(disk_.border.size()));
  for (std::size_t k = 0; k < disk_.border.size(); ++k) {
    if (border_.lengths.may_change(k)) continue;
    const FlatEdge edge = border_edge(disk_, border_, k);
    gaps[static_cast<Eigen::Index>(k)] = LaidEdge(edge, flat).length - edge.length;
  }
  return gaps;
}

bool SeamSystem::all_kept(const Eigen::VectorXd& gaps) const {
  for (std::size_t k = 0; k < disk_.border.size(); ++k) {
    const double most = k_kept * border_.lengths.of_edges[k] + k_rounding;
    if (!(std::abs(gaps[static_cast<Eigen::Index>(k)]) <= most)) return false;
  }
  return true;
}

/// Of a triangle with border edges the pulls' share is added, and what is left of negative
/// curvature then is cut off: less is, than of each by itself.
SeamSystem::Hessian6 SeamSystem::hessian_of(std::size_t t, const TriangleEnergy& energy,
                                            const std::vector<Vec2>& flat,
                                            Curvature curvature) const {
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  const bool on_border = !edges_of_[t].empty();
  Hessian6 result = energy.hessian(on_border ? Curvature::full : curvature);
  if (!on_border) return result;
  Eigen::Map<Eigen::Matrix<double, 6, 6, Eigen::RowMajor>> entries(result.front().data());
  Matrix6 hessian = entries;
  const Triangle& tri = disk_.triangles[t];
  for (const Index k : edges_of_[t]) {
    const FlatEdge edge = border_edge(disk_, border_, k);
    const Vec2 d = flat[edge.to] - flat[edge.from];
    const double length = norm(d);
    Eigen::Matrix<double, 6, 1> across = Eigen::Matrix<double, 6, 1>::Zero();
    for (int corner = 0; corner < 3; ++corner) {
      const double sign = tri[corner] == edge.to ? 1.0 : tri[corner] == edge.from ? -1.0 : 0.0;
      across[2 * corner] = -sign * d.y / length;
      across[2 * corner + 1] = sign * d.x / length;
    }
    hessian += (pulls_[static_cast<Eigen::Index>(k)] / length) * across * across.transpose();
  }
  if (curvature == Curvature::projected) {
    const Eigen::SelfAdjointEigenSolver<Matrix6> eigen(hessian);
    hessian = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() *
              eigen.eigenvectors().transpose();
  }
  entries = hessian;
  return result;
}

void SeamSystem::add_lengths(const std::vector<Vec2>& flat) {
  for (std::size_t k = 0; k < disk_.border.size(); ++k) {
    const FlatEdge edge = border_edge(disk_, border_, k);
    const Index pull = block_of_pull(k);
    const bool is_free = border_.lengths.may_change(k);
    *matrix_.own(pull, 0) = is_free ? -1.0 : -k_give;
    if (is_free) continue;
    const Vec2 along = LaidEdge(edge, flat).along;
    const auto set = [&](Index v, double sign) {
      const BlockMatrix::Pair pair = matrix_.pair_of(v, pull);
      for (int axis = 0; axis < matrix_.size(v); ++axis)
        *matrix_.entries(v, pair, axis) = sign * (axis == 0 ? along.x : along.y);
    };
    set(edge.from, -1.0);
    set(edge.to, 1.0);
  }
}

void SeamSystem::assemble(const std::vector<Vec2>& flat, Curvature curvature) {
  StretchSystem::assemble(flat, curvature);
  for (std::size_t k = 0; k < turn_pairs_.size(); ++k)
    add(border_.bend.summand(k, flat, stiffness_), turn_pairs_[k]);
  add_lengths(flat);
  gaps_ = gaps(flat);
}

bool SeamSystem::factor() {
  return StretchSystem::factor() && factor_->negative_pivots() == disk_.border.size();
}

Eigen::VectorXd SeamSystem::right() const {
  Eigen::VectorXd right = -gradient_;
  for (std::size_t k = 0; k < disk_.border.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    right[row_of_pull(k)] = -gaps_[i] - k_give * pulls_[i];
  }
  return right;
}

void SeamSystem::follow(const Eigen::VectorXd& step, double share) {
  for (std::size_t k = 0; k < disk_.border.size(); ++k) {
    double& pull = pulls_[static_cast<Eigen::Index>(k)];
    pull += share * (step[row_of_pull(k)] - pull);
  }
}

SeamSystem::Step SeamSystem::step() const {
  const Eigen::VectorXd right = this->right();
  const auto matrix = hessian().selfadjointView<Eigen::Lower>();
  Step step;
  step.all = solve(right);
  const Eigen::VectorXd rest = right - matrix * step.all;
  step.all += solve(rest);
  step.sound = (right - matrix * step.all).norm() <= 1e-3 * right.norm();
  step.move = spread(step.all);
  for (std::size_t k = 0; k < disk_.border.size(); ++k) {
    const double pull = step.all[row_of_pull(k)];
    step.largest_pull = std::max(step.largest_pull, std::abs(pull));
  }
  step.slope = gradient_.dot(step.all);
  return step;
}

std::vector<Vec2> SeamSystem::correction(const Eigen::VectorXd& change) const {
  Eigen::VectorXd right = Eigen::VectorXd::Zero(hessian().rows());
  for (std::size_t k = 0; k < disk_.border.size(); ++k)
    right[row_of_pull(k)] = change[static_cast<Eigen::Index>(k)];
  return spread(solve(right));
}

std::optional<std::vector<Vec2>> SeamSystem::restored(std::vector<Vec2> flat) const {
  constexpr int most_solves = 12;
  for (int solves = 0; solves <= most_solves; ++solves) {
    const Eigen::VectorXd gaps = this->gaps(flat);
    if (all_kept(gaps)) return flat;
    if (solves < most_solves) flat = moved(std::move(flat), 1.0, correction(-gaps));
  }
  return std::nullopt;
}

std::unique_ptr<StretchSystem> make_system(const Disk& disk, const HeldBorder* border,
                                           ThreadPool& pool) {
  if (border == nullptr) return std::make_unique<StretchSystem>(disk, pool);
  return std::make_unique<SeamSystem>(disk, *border, pool);
}

}  // namespace planish
