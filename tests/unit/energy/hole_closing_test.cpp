#include "energy/hole_closing.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <string_view>
#include <utility>

#include <planish/unfold/strain.h>
#include <planish/unfold/unfold.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "energy/angle_jacobian.h"
#include "energy/strain_potential.h"
#include "evolve/systems/dense.h"
#include "evolve/systems/positions.h"
#include "support/meshes.h"
#include "support/moves.h"
#include "unit/energy/strain_gradient.h"

namespace planish {
namespace {

using meshes::blocks, meshes::on_cone, meshes::on_cylinder, meshes::on_plane, meshes::perforated,
    meshes::Place;

/// A patch with holes, and its potential with a free border.
struct Perforated {
  explicit Perforated(const TriMesh& mesh)
      : patch(mesh),
        state(patch, pool),
        movable(state.vertex_count() - state.inner_count(), 1),
        jacobian(angle_jacobian_of(state, movable, hole_borders_of(state))),
        potential(jacobian, all_positions(state), pool, BoundaryCondition::free,
                  potential_precision(state.inner_count())) {
    jacobian.update(state.positions(), pool);
  }
  /// With the polygons of the holes as they were when K was taken.
  Eigen::VectorXd defects() {
    state.measure(pool);
    return potential.defects(inner_defects(state), state.positions());
  }
  double strain_of(const Eigen::VectorXd& phi) const {
    const Eigen::VectorXd shares = area_shares(state.triangles(), all_positions(state));
    return edge_strain_of(std::sqrt(phi.cwiseAbs2().dot(shares)));
  }
  double predicted_strain() { return strain_of(potential.of(defects(), pool)); }
  /// As if the holes were cut open.
  double strain_of_freed() {
    const AngleJacobian rows = angle_jacobian_of(state);
    StrainPotential freed(rows, all_positions(state), pool, BoundaryCondition::free);
    return strain_of(freed.of(inner_defects(state), pool));
  }
  double measured_strain() const {
    return edge_strain(patch, unfold(patch, {.least_stretch = true}).positions).rms;
  }

  Patch patch;
  ThreadPool pool{1};
  PatchState state;
  std::vector<unsigned char> movable;  // the border's, all
  AngleJacobian jacobian;
  StrainPotential potential;
};

/// A cone, a cap or a saddle over a square 2 wide, of 40 by 40 cells.
std::array<std::pair<const char*, Place>, 3> curved_surfaces(double height) {
  const auto over_square = [](const std::function<double(double, double)>& z) {
    return Place([z](double x, double y) {
      const double u = x / 20.0 - 1.0, v = y / 20.0 - 1.0;
      return Vec3{u, v, z(u, v)};
    });
  };
  return {{{"cone", over_square([=](double u, double v) { return height * std::hypot(u, v); })},
           {"cap", over_square([=](double u, double v) { return -height * (u * u + v * v); })},
           {"saddle", over_square([=](double u, double v) { return height * (u * u - v * v); })}}};
}

TriMesh hill_with_two_holes() {
  return perforated(16, 12, blocks(16, 12, 2, 1, 3), [](double x, double y) {
    return Vec3{x, y, 2.0 * std::sin(x / 5.0) * std::sin(y / 4.0 + 0.3)};
  });
}

/// The angle at p of a triangle with these lengths of edges.
double angle_by_lengths(double to_q, double to_r, double across) {
  const double cosine = (to_q * to_q + to_r * to_r - across * across) / (2.0 * to_q * to_r);
  return std::acos(cosine);
}

/// The border of a hole on a surface where lengths are as given by pairs of vertices.
HoleLayout laid_out_by_lengths(const HoleBorder& hole,
                               const std::function<double(Index, Index)>& length) {
  std::vector<double> lengths, angles;
  for (std::size_t b = 0; b < hole.loop.size(); ++b) {
    const Index v = hole.loop[b];
    lengths.push_back(length(v, hole.loop[(b + 1) % hole.loop.size()]));
    double angle = 0.0;
    for (std::size_t j = 0; j + 1 < hole.rings[b].size(); ++j) {
      const Index q = hole.rings[b][j], r = hole.rings[b][j + 1];
      angle += angle_by_lengths(length(v, q), length(v, r), length(q, r));
    }
    angles.push_back(angle);
  }
  return {lengths, angles};
}

TEST(HoleLayout, ClosesInThePlane) {
  // A hexagon with a corner that bends inwards, clockwise, as a hole has the surface on its left.
  const std::array<Vec2, 6> corners = {
      {{0.0, 0.0}, {-1.0, 2.0}, {1.0, 3.0}, {2.0, 1.8}, {4.0, 3.0}, {3.0, -1.0}}};
  std::vector<double> lengths, angles;
  for (std::size_t b = 0; b < 6; ++b) {
    const Vec2 in = corners[b] - corners[(b + 5) % 6], out = corners[(b + 1) % 6] - corners[b];
    lengths.push_back(norm(out));
    angles.push_back(std::numbers::pi - std::atan2(cross(in, out), dot(in, out)));
  }
  const HoleLayout layout(lengths, angles);
  for (const double defect : layout.defects(1.0))
    EXPECT_NEAR(defect, 0.0, 1e-14);
  const HoleLayout::Polygon polygon = layout.closed();
  Vec2 normals;
  for (std::size_t b = 0; b < 6; ++b) {
    const double side = norm(polygon.places[(b + 1) % 6] - polygon.places[b]);
    EXPECT_NEAR(polygon.size * side, lengths[b], 1e-14);
    normals = normals + polygon.normals[b];
  }
  EXPECT_NEAR(norm(normals), 0.0, 1e-14);
}

TEST(HoleLayout, HasTheDerivativesOfDifferenceQuotients) {
  // It neither turns by a whole turn nor closes.
  const std::vector<double> lengths = {1.0, 0.6, 2.5, 0.9, 1.2};
  const std::vector<double> angles = {4.1, 4.6, 4.0, 4.9, 4.8};
  const HoleLayout layout(lengths, angles);
  EXPECT_GT(std::hypot(layout.defects(1.0)[1], layout.defects(1.0)[2]), 0.1);
  EXPECT_GT(std::abs(layout.defects(1.0)[0]), 0.1);
  constexpr double h = 1e-6, size = 0.7;
  for (std::size_t b = 0; b < 5; ++b) {
    const auto at = [&](double length, double angle) {
      std::vector<double> other_lengths = lengths, other_angles = angles;
      other_lengths[b] += length;
      other_angles[b] += angle;
      return HoleLayout(other_lengths, other_angles).defects(size);
    };
    for (std::size_t row = 0; row < 3; ++row) {
      EXPECT_NEAR(layout.by_angle(b, size)[row], (at(0, h)[row] - at(0, -h)[row]) / (2.0 * h),
                  1e-8);
      EXPECT_NEAR(layout.by_length(b, size)[row], (at(h, 0)[row] - at(-h, 0)[row]) / (2.0 * h),
                  1e-8);
    }
  }
}

TEST(HoleRows, AreTheDerivativeByPositions) {
  Perforated hill(hill_with_two_holes());
  ASSERT_EQ(hill.jacobian.row_count(), hill.state.inner_count() + 6);
  const Positions x = all_positions(hill.state);
  const Positions u = some_moves(x.size(), 1e-5 * hill.state.scale());
  const auto at = [&](double share) {
    set_positions(sum_of(x, share, u), hill.jacobian, hill.state);
    return hill.defects();
  };
  const Eigen::VectorXd slope = 0.5 * (at(1.0) - at(-1.0)), told = -hill.jacobian.times(u);
  EXPECT_GT(told.tail(6).cwiseAbs().minCoeff(), 1e-7);
  EXPECT_LT((slope - told).cwiseAbs().maxCoeff(), 1e-4 * told.cwiseAbs().maxCoeff());
  EXPECT_LT((slope - told).tail(6).norm(), 1e-4 * told.tail(6).norm());
}

// phi shortens edges by the mean at their ends. On a surface whose holes close, the rows of K are
// how that changes what the holes lack.
TEST(HoleRows, AreTheDerivativeByTheMetric) {
  Perforated sheet(perforated(20, 14, blocks(20, 14, 2, 1, 3), on_cone));
  const auto& holes = sheet.jacobian.holes();
  ASSERT_EQ(holes.size(), 2U);
  const Eigen::Index n = static_cast<Eigen::Index>(sheet.state.vertex_count());
  const Eigen::VectorXd phi =
      Eigen::VectorXd::NullaryExpr(n, [](Eigen::Index v) { return std::sin(1.7 * double(v)); });
  const Eigen::VectorXd told = sheet.potential.stiffness().transpose() * phi;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto at = [&](double share) {
      const auto length = [&](Index v, Index w) {
        return norm(sheet.state.position(w) - sheet.state.position(v)) *
               (1.0 - 0.5 * share * (phi[v] + phi[w]));
      };
      const HoleLayout now = laid_out_by_lengths(holes[k], length);
      const double size = laid_out(holes[k], sheet.state.positions()).closed().size;
      return now.defects(size);
    };
    constexpr double h = 1e-5;
    const auto above = at(h), below = at(-h);
    for (std::size_t row = 0; row < 3; ++row) {
      const double slope = (below[row] - above[row]) / (2.0 * h);
      const double of_row =
          told[static_cast<Eigen::Index>(sheet.state.inner_count() + 3 * k + row)];
      EXPECT_NEAR(of_row, slope, 1e-6 * (1.0 + std::abs(slope))) << k << " " << row;
    }
  }
}

TEST(HoleRows, GiveTheGradientOfTheStrain) {
  Perforated hill(hill_with_two_holes());
  expect_gradient_of_strain(hill, hill.potential);
}

TEST(StrainPotentialWithHoles, IsZeroOnDevelopableSurfaces) {
  for (const Place& place : {Place(on_plane), Place(on_cylinder), Place(on_cone)}) {
    for (const auto& [across, size] :
         {std::array<std::size_t, 2>{1, 1}, std::array<std::size_t, 2>{1, 12},
          std::array<std::size_t, 2>{3, 4}}) {
      Perforated sheet(perforated(40, 24, blocks(40, 24, across, 1, size), place));
      ASSERT_EQ(sheet.jacobian.holes().size(), across);
      EXPECT_LT(sheet.predicted_strain(), 1e-12) << across << " of " << size;
    }
  }
}

// The hole of the cone is around its apex, so all of its strain comes from the hole.
TEST(StrainPotentialWithHoles, TellsTheStrainOfThePattern) {
  for (const double height : {0.1, 0.25, 0.5}) {
    for (const auto& [name, place] : curved_surfaces(height)) {
      for (const auto& [across, size] :
           {std::array<std::size_t, 2>{1, 4}, std::array<std::size_t, 2>{1, 16},
            std::array<std::size_t, 2>{2, 8}}) {
        const bool apex_stays = name == std::string_view("cone") && across > 1;
        if (apex_stays) continue;
        Perforated sheet(perforated(40, 40, blocks(40, 40, across, 1, size), place));
        const double predicted = sheet.predicted_strain(), measured = sheet.measured_strain();
        EXPECT_NEAR(predicted, measured, 0.06 * measured) << name << " " << height << " " << size;
        EXPECT_LT(sheet.strain_of_freed(), 0.5 * measured) << name << " " << height << " " << size;
      }
    }
  }
}

}  // namespace
}  // namespace planish
