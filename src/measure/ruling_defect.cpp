#include "measure/ruling_defect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/neumaier_sum.h"
#include "geometry/angle_between.h"

namespace planish {

namespace {

/// Below this, per vertex, the sum of the two smaller eigenvalues is rounding.
constexpr double k_eigenvalue_rounding = 1e-14;

using Symmetric = std::array<std::array<double, 3>, 3>;

/// One rotation of Jacobi's method: makes the entry (p, q) zero.
void rotate(Symmetric& a, std::size_t p, std::size_t q) {
  if (a[p][q] == 0.0) return;
  const std::size_t r = 3 - p - q;
  const double theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
  const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
  const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
  a[p][p] -= t * a[p][q];
  a[q][q] += t * a[p][q];
  a[p][q] = a[q][p] = 0.0;
  const double at_p = a[r][p], at_q = a[r][q];
  a[r][p] = a[p][r] = c * at_p - s * at_q;
  a[r][q] = a[q][r] = s * at_p + c * at_q;
}

/// In increasing order.
std::array<double, 3> eigenvalues(Symmetric a) {
  constexpr int most_rounds = 12;  // three or four do
  constexpr double small = 1e-18;
  for (int k = 0; k < most_rounds; ++k) {
    const double off = std::abs(a[0][1]) + std::abs(a[0][2]) + std::abs(a[1][2]);
    if (off <= small * (std::abs(a[0][0]) + std::abs(a[1][1]) + std::abs(a[2][2]))) break;
    rotate(a, 0, 1);
    rotate(a, 0, 2);
    rotate(a, 1, 2);
  }
  std::array<double, 3> values = {a[0][0], a[1][1], a[2][2]};
  std::sort(values.begin(), values.end());
  return values;
}

void add(Symmetric& sum, double weight, Vec3 n) {
  const std::array<double, 3> of = {n.x, n.y, n.z};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      sum[i][j] += weight * of[i] * of[j];
  }
}

/// For each vertex the sum of corner angle x n n^T.
std::vector<Symmetric> normal_spreads(const TriMesh& mesh) {
  const double scale = unit_scale(mesh);
  std::vector<Symmetric> spreads(mesh.positions.size(), Symmetric{});
  for (const Triangle& t : mesh.triangles) {
    const std::array<Vec3, 3> p = {scale * mesh.positions[t[0]], scale * mesh.positions[t[1]],
                                   scale * mesh.positions[t[2]]};
    const Vec3 normal = cross(p[1] - p[0], p[2] - p[0]);
    const double length = norm(normal);
    if (!(length > 0.0)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const double angle = angle_between(p[(k + 1) % 3] - p[k], p[(k + 2) % 3] - p[k]);
      add(spreads[t[k]], angle, (1.0 / length) * normal);
    }
  }
  return spreads;
}

}  // namespace

double ruling_defect(const Patch& patch) {
  const std::vector<Symmetric> spreads = normal_spreads(patch.mesh());
  NeumaierSum least, both;
  for (const Index v : patch.inner_vertices()) {
    const auto [l1, l2, l3] = eigenvalues(spreads[v]);
    const double smallest = std::max(l1, 0.0);
    least.add(smallest);
    both.add(smallest + std::max(l2, 0.0));
  }
  const auto count = static_cast<double>(patch.inner_vertices().size());
  return both.value() > k_eigenvalue_rounding * count ? least.value() / both.value() : 0.0;
}

}  // namespace planish
