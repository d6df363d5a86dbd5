#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include <planish/mesh/tri_mesh.h>

#include "support/meshes.h"

namespace planish::meshes {

enum class FanKind { convex, saddle, noisy };

/// Vertex 0 with its ring and the next one. Vertex 0 has 3 to 9 neighbours; these have 4 to 9, or
/// are on the border. As high as wide at most.
class RandomFan {
 public:
  RandomFan(Random& random, FanKind kind) : random_(random), kind_(kind) {
    valence_ = whole(3, 9);
    height_ = 0.05 + 0.55 * share();
    noise_ = kind == FanKind::noisy ? height_ : 0.1 * height_ * share();
    add_place(0.0, 0.0);
    for (std::size_t j = 0; j < valence_; ++j)
      add_place(1.0 + 0.35 * random_.number(), angle(static_cast<double>(j), 0.35));
    for (std::size_t j = 0; j < valence_; ++j)
      mesh_.triangles.push_back({0, neighbour(j), neighbour(j + 1)});
    add_outside();
  }

  const TriMesh& mesh() const { return mesh_; }

 private:
  double share() { return 0.5 + 0.5 * random_.number(); }
  std::size_t whole(std::size_t from, std::size_t to) {
    return from + static_cast<std::size_t>(share() * static_cast<double>(to - from + 1));
  }
  double angle(double j, double shift) {
    return 2.0 * std::numbers::pi * (j + shift * random_.number()) / static_cast<double>(valence_);
  }
  Index neighbour(std::size_t j) const { return static_cast<Index>(1 + j % valence_); }

  Index add_place(double r, double phi) {
    const double z = kind_ == FanKind::convex   ? -height_ * r * r
                     : kind_ == FanKind::saddle ? height_ * r * r * std::cos(2.0 * phi)
                                                : 0.0;
    mesh_.positions.push_back(
        {r * std::cos(phi), r * std::sin(phi), z + noise_ * random_.number()});
    return static_cast<Index>(mesh_.positions.size() - 1);
  }

  /// Between two neighbours stands an outer vertex; it may be the one before it again.
  void add_outside() {
    std::vector<Index> between;
    for (std::size_t j = 0; j < valence_; ++j) {
      const bool same = j > 0 && j + 1 < valence_ && share() < 0.1;
      between.push_back(
          same ? between.back()
               : add_place(2.0 + 0.3 * random_.number(), angle(static_cast<double>(j) + 0.5, 0.2)));
    }
    for (std::size_t j = 0; j < valence_; ++j) {
      mesh_.triangles.push_back({neighbour(j), between[j], neighbour(j + 1)});
      add_fan_of(j, between[(j + valence_ - 1) % valence_], between[j]);
    }
  }

  /// The outer triangles at a neighbour; without one of them it is on the border.
  void add_fan_of(std::size_t j, Index first, Index last) {
    if (first == last) return;
    std::vector<Index> outer{first};
    const std::size_t more = whole(0, 4);
    for (std::size_t i = 1; i <= more; ++i) {
      const double at = static_cast<double>(i) / static_cast<double>(more + 1) - 0.5;
      outer.push_back(
          add_place(2.1 + 0.2 * random_.number(), angle(static_cast<double>(j) + at, 0.0)));
    }
    outer.push_back(last);
    const std::size_t left_out = share() < 0.25 ? whole(0, more) : outer.size();
    for (std::size_t i = 0; i + 1 < outer.size(); ++i) {
      if (i != left_out) mesh_.triangles.push_back({neighbour(j), outer[i], outer[i + 1]});
    }
  }

  Random& random_;
  FanKind kind_;
  std::size_t valence_ = 0;
  double height_ = 0.0, noise_ = 0.0;
  TriMesh mesh_;
};

}  // namespace planish::meshes
