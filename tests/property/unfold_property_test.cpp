#include <cmath>

#include <planish/flatten/flatten.h>
#include <planish/unfold/unfold.h>

#include <gtest/gtest.h>

#include "property/property.h"
#include "support/meshes.h"

namespace planish {
namespace {

/// A rough plane grid rolled onto a cylinder, along lines in any direction. Only edges along the
/// lines stay straight, so each triangle is bent a little; what is compared are the lengths of the
/// triangles themselves.
TriMesh flattenable_patch() {
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  TriMesh mesh =
      meshes::flat_grid(*rc::gen::inRange<std::size_t>(2, 7), *rc::gen::inRange<std::size_t>(2, 7));
  meshes::Random random(seed);
  // Folded along the columns: each column of the grid keeps its own angle.
  double x = 0.0, z = 0.0, direction = 0.0;
  std::vector<Vec2> profile{{0.0, 0.0}};
  for (int column = 0; column < 10; ++column) {
    direction += 0.8 * random.number();
    const double width = 0.6 + 0.4 * random.number();
    x += width * std::cos(direction);
    z += width * std::sin(direction);
    profile.push_back({x, z});
  }
  for (Vec3& p : mesh.positions) {
    const Vec2 q = profile[static_cast<std::size_t>(p.x)];
    p = {q.x, p.y * (1.0 + 0.3 * std::sin(static_cast<double>(seed % 7))), q.y};
  }
  return mesh;
}

PLANISH_PROPERTY(UnfoldProperty, KeepsEveryLengthWhereNoVertexHasADefect, 200) {
  const TriMesh mesh = flattenable_patch();
  const Patch patch(mesh);
  RC_ASSERT(measure(patch).e_max < 1e-12);
  const Pattern pattern = unfold(patch);
  RC_ASSERT(pattern.flipped_triangles == 0U);
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = t[k], b = t[(k + 1) % 3];
      RC_ASSERT(std::abs(norm(pattern.positions[b] - pattern.positions[a]) -
                         norm(mesh.positions[b] - mesh.positions[a])) < 1e-7);
    }
  }
}

PLANISH_PROPERTY(UnfoldProperty, GivesTheSameBitsAtEverySizeOfAPowerOfTwo, 100) {
  const TriMesh mesh = meshes::rough_grid(5, 4, *rc::gen::arbitrary<std::uint32_t>());
  const double size = std::ldexp(1.0, *rc::gen::inRange(-100, 101));
  TriMesh scaled = mesh;
  for (Vec3& p : scaled.positions)
    p = size * p;
  const Pattern one = unfold(Patch(mesh)), other = unfold(Patch(scaled));
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    RC_ASSERT(other.positions[v] == size * one.positions[v]);
}

PLANISH_PROPERTY(UnfoldProperty, FlatteningGivesTheSameBitsOnAnyNumberOfThreads, 30) {
  const TriMesh mesh = meshes::rough_grid(6, 6, *rc::gen::arbitrary<std::uint32_t>(), 0.2, 0.2);
  const auto one = flatten(Patch(mesh), "a", preset_options(5), {.threads = 1});
  const auto other =
      flatten(Patch(mesh), "a", preset_options(5), {.threads = *rc::gen::inRange(2U, 6U)});
  RC_ASSERT(one.processed.positions() == other.processed.positions());
  RC_ASSERT(one.unfold.pattern.positions == other.unfold.pattern.positions);
}

}  // namespace
}  // namespace planish
