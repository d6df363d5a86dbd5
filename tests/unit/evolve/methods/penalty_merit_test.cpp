#include "evolve/methods/penalty_merit.h"

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "oracle/plain.h"
#include "oracle/series.h"
#include "support/meshes.h"
#include "support/seams.h"

namespace planish {
namespace {

/// A patch laid out for sweeping, with its merit.
class Laid {
 public:
  Laid(const TriMesh& mesh, BorderRule border, const Constraints& constraints = {})
      : mesh_(mesh),
        patch_(mesh_),
        pool_(2),
        state_(patch_, pool_, constraints),
        merit_(state_, border, pool_) {}

  const TriMesh& mesh() const { return mesh_; }
  const PatchState& state() const { return state_; }
  const PenaltyMerit& merit() const { return merit_; }
  std::vector<Vec3> positions() const {
    std::vector<Vec3> positions;
    for (std::size_t v = 0; v < state_.vertex_count(); ++v)
      positions.push_back(state_.position(v));
    return positions;
  }
  /// Every node elsewhere: all its vertices by the same bit.
  std::vector<Vec3> shifted(const std::vector<Vec3>& by_node, double length) const {
    std::vector<Vec3> positions = this->positions();
    for (std::size_t node = 0; node < merit_.node_count(); ++node) {
      for (const Index v : merit_.vertices_of(node))
        positions[v] += length * by_node[node];
    }
    return positions;
  }
  /// The mesh with vertices at these positions, in its own size.
  TriMesh mesh_at(const std::vector<Vec3>& positions) const {
    TriMesh moved = mesh_;
    for (std::size_t v = 0; v < positions.size(); ++v)
      moved.positions[state_.vertex_of(v)] = (1.0 / state_.scale()) * positions[v];
    return moved;
  }

 private:
  TriMesh mesh_;
  Patch patch_;
  ThreadPool pool_;
  PatchState state_;
  PenaltyMerit merit_;
};

std::vector<Vec3> random_directions(std::size_t count, std::uint64_t seed) {
  meshes::Random random(seed);
  std::vector<Vec3> directions(count);
  for (Vec3& d : directions)
    d = {random.number(), random.number(), random.number()};
  return directions;
}

std::set<std::pair<Index, Index>> edges_of(const TriMesh& mesh) {
  std::set<std::pair<Index, Index>> edges;
  for (const Triangle& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k)
      edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
  }
  return edges;
}

/// E_s written out, in the size of the mesh.
double plain_stretch(const TriMesh& before, const TriMesh& after) {
  double sum = 0.0;
  for (const auto& [v, w] : edges_of(before)) {
    const double longer = norm(after.positions[v] - after.positions[w]) -
                          norm(before.positions[v] - before.positions[w]);
    sum += longer * longer;
  }
  return sum;
}

/// Derivatives of E_s and G along a motion of all vertices, by power series.
struct Rates {
  double stretch = 0.0, energy = 0.0;
};
Rates rates_along(const TriMesh& first, const TriMesh& now, const std::vector<Vec3>& motion) {
  const plain::Patch patch(now);
  const auto place = [&](Index v) { return plain::on_line(now.positions[v], motion[v]); };
  Rates rates;
  for (const auto& [v, w] : edges_of(now)) {
    const plain::SeriesPoint edge = place(v) - place(w);
    plain::Series longer = sqrt(dot(edge, edge));
    longer.c[0] -= norm(first.positions[v] - first.positions[w]);
    rates.stretch += (longer * longer).c[1];
  }
  for (Index v = 0; v < now.positions.size(); ++v) {
    if (!patch.inner[v]) continue;
    plain::Series defect{{2.0 * std::numbers::pi}};
    for (const Index t : patch.triangles_at[v]) {
      const Triangle& tri = now.triangles[t];
      const int k = tri[0] == v ? 0 : tri[1] == v ? 1 : 2;
      defect = defect - angle_between(place(tri[(k + 1) % 3]) - place(v),
                                      place(tri[(k + 2) % 3]) - place(v));
    }
    rates.energy += (defect * defect).c[1];
  }
  return rates;
}

double inner_product(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += dot(a[i], b[i]);
  return sum;
}

std::vector<std::pair<TriMesh, BorderRule>> cases() {
  return {{meshes::rough_grid(7, 6, 1), BorderRule::fixed},
          {meshes::opened_vase(9, 5), BorderRule::linked},
          {meshes::book(3, 5, 4), BorderRule::linked}};
}

TEST(PenaltyMerit, IsTheSumsThatItSays) {
  for (const auto& [mesh, border] : cases()) {
    const Laid laid(mesh, border);
    const auto positions = laid.shifted(random_directions(laid.merit().node_count(), 3), 0.02);
    const PenaltyPoint point = laid.merit().at(positions);
    const TriMesh moved = laid.mesh_at(positions);
    const double scale = laid.state().scale();
    const double stretch = scale * scale * plain_stretch(mesh, moved);
    EXPECT_NEAR(point.stretch, stretch, 1e-13 * stretch);
    const double energy = plain::Patch(moved).energy();
    EXPECT_NEAR(point.energy, energy, 1e-12 * energy);
    double squares = 0.0;
    for (const auto& [v, w] : edges_of(mesh)) {
      const Vec3 edge = scale * (mesh.positions[v] - mesh.positions[w]);
      squares += dot(edge, edge) / static_cast<double>(edges_of(mesh).size());
    }
    EXPECT_NEAR(laid.merit().mean_squared_edge(), squares, 1e-13 * squares);
    EXPECT_TRUE(point.sound);
  }
}

TEST(PenaltyMerit, HasTheGradientsOfThePowerSeries) {
  for (const auto& [mesh, border] : cases()) {
    const Laid laid(mesh, border);
    const double scale = laid.state().scale();
    const std::size_t nodes = laid.merit().node_count();
    const auto positions = laid.shifted(random_directions(nodes, 3), 0.01);
    const PenaltyPoint point = laid.merit().at(positions);
    for (std::uint64_t seed = 10; seed < 20; ++seed) {
      const auto directions = random_directions(nodes, seed);
      std::vector<Vec3> motion(mesh.positions.size());
      for (std::size_t node = 0; node < nodes; ++node) {
        for (const Index v : laid.merit().vertices_of(node))
          motion[laid.state().vertex_of(v)] = (1.0 / scale) * directions[node];
      }
      const Rates rates = rates_along(mesh, laid.mesh_at(positions), motion);
      const double stretch = inner_product(laid.merit().gradient(point, 0.0), directions);
      const double both = inner_product(laid.merit().gradient(point, 0.3), directions);
      EXPECT_NEAR(stretch, scale * scale * rates.stretch, 1e-13 * (1.0 + std::abs(stretch)));
      EXPECT_NEAR(both, stretch + 0.3 * rates.energy, 1e-11 * (1.0 + std::abs(both)));
    }
  }
}

TEST(PenaltyMerit, HasTheGradientsOfDifferenceQuotients) {
  for (const auto& [mesh, border] : cases()) {
    const Laid laid(mesh, border);
    const std::size_t nodes = laid.merit().node_count();
    const auto directions = random_directions(nodes, 4);
    // (E_s + rho / 2 G^2)' = E_s' + rho G G'
    constexpr double h = 1e-6, rho = 0.7, at = 0.01;
    const auto merit = [&](double length) {
      const PenaltyPoint point = laid.merit().at(laid.shifted(directions, length));
      return point.stretch + 0.5 * rho * point.energy * point.energy;
    };
    const PenaltyPoint point = laid.merit().at(laid.shifted(directions, at));
    const double slope =
        inner_product(laid.merit().gradient(point, rho * point.energy), directions);
    EXPECT_NEAR(slope, (merit(at + h) - merit(at - h)) / (2.0 * h), 1e-6 * std::abs(slope));
  }
}

TEST(PenaltyMerit, LinksBorderVerticesAtOnePlace) {
  const Laid vase(meshes::opened_vase(9, 5), BorderRule::linked);
  std::size_t links = 0;
  for (std::size_t node = 0; node < vase.merit().node_count(); ++node) {
    const auto vertices = vase.merit().vertices_of(node);
    if (vase.state().is_inner(vertices.front())) {
      EXPECT_EQ(vertices.size(), 1U);
      continue;
    }
    ++links;
    ASSERT_EQ(vertices.size(), 2U);
    EXPECT_EQ(vase.state().origin(vertices[0]), vase.state().origin(vertices[1]));
  }
  EXPECT_EQ(links, 6U);

  const Laid book(meshes::book(3, 5, 4), BorderRule::linked);
  EXPECT_EQ(book.merit().node_count(), book.state().inner_count() + 5);
  for (std::size_t node = book.state().inner_count(); node < book.merit().node_count(); ++node)
    EXPECT_EQ(book.merit().vertices_of(node).size(), 3U);

  const Laid fixed(meshes::opened_vase(9, 5), BorderRule::fixed);
  EXPECT_EQ(fixed.merit().node_count(), fixed.state().inner_count());
}

TEST(PenaltyMerit, LeavesOutWhatIsFixedAndItsPartners) {
  // Vertex 0 and vertex 9 are the two sides of the seam in the first row; 12 is inside.
  const Laid vase(meshes::opened_vase(9, 5), BorderRule::linked, {.fixed = {9, 12}});
  for (std::size_t node = 0; node < vase.merit().node_count(); ++node) {
    for (const Index v : vase.merit().vertices_of(node)) {
      const Index vertex = vase.state().vertex_of(v);
      EXPECT_TRUE(vertex != 0 && vertex != 9 && vertex != 12) << vertex;
    }
  }
  EXPECT_EQ(vase.merit().node_count(), vase.state().inner_count() - 1 + 5);
}

TEST(PenaltyMerit, TellsWhereATriangleCollapses) {
  const Laid laid(meshes::rough_grid(5, 5, 2), BorderRule::fixed);
  std::vector<Vec3> positions = laid.positions();
  const Index v = laid.merit().vertices_of(0).front();
  const auto ring = rings_by_vertex(laid.state().plan())[v];
  positions[v] = positions[ring[0]];
  EXPECT_FALSE(laid.merit().at(positions).sound);
  positions[v] = 0.25 * positions[ring[0]] + 0.75 * positions[ring[1]];
  EXPECT_FALSE(laid.merit().at(positions).sound);
  positions[v] = {std::nan(""), 0.0, 0.0};
  EXPECT_FALSE(laid.merit().at(positions).sound);
}

}  // namespace
}  // namespace planish
