#include <cmath>
#include <numbers>

#include <planish/measure/flattenability.h>
#include <planish/mesh/inspect.h>

#include <gtest/gtest.h>

#include "oracle/plain.h"
#include "property/property.h"
#include "support/meshes.h"

namespace planish {
namespace {

TriMesh arbitrary_relief() {
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  const double height = 0.01 * *rc::gen::inRange(0, 300);
  return meshes::rough_grid(6, 5, seed, 0.4, height);
}

Flattenability measured(const TriMesh& mesh) {
  return measure(Patch(mesh));
}

void expect_same(const Flattenability& a, const Flattenability& b) {
  RC_ASSERT(std::abs(a.e_max - b.e_max) < 1e-11);
  RC_ASSERT(std::abs(a.energy - b.energy) < 1e-10);
  RC_ASSERT(std::abs(a.sum_abs_defect - b.sum_abs_defect) < 1e-10);
  RC_ASSERT(std::abs(a.min_angle - b.min_angle) < 1e-11);
  RC_ASSERT(std::abs(a.roughness - b.roughness) < 1e-8);
}

PLANISH_PROPERTY(MeasureProperty, DoesNotChangeWhenThePatchIsTurnedAndShifted, 4'000) {
  const TriMesh mesh = arbitrary_relief();
  const double a = *rc::gen::inRange(0, 628) * 0.01, b = *rc::gen::inRange(0, 628) * 0.01;
  TriMesh moved = mesh;
  for (Vec3& p : moved.positions) {
    const Vec3 q{std::cos(a) * p.x - std::sin(a) * p.y, std::sin(a) * p.x + std::cos(a) * p.y, p.z};
    p = {q.x, std::cos(b) * q.y - std::sin(b) * q.z, std::sin(b) * q.y + std::cos(b) * q.z};
    p += {3.0, -20.0, 7.0};
  }
  expect_same(measured(mesh), measured(moved));
}

PLANISH_PROPERTY(MeasureProperty, DoesNotChangeWhenThePatchIsMirroredOrTurnedOver, 4'000) {
  const TriMesh mesh = arbitrary_relief();
  TriMesh mirrored = mesh, turned = mesh;
  for (Vec3& p : mirrored.positions)
    p.x = -p.x;
  for (Triangle& t : turned.triangles)
    std::swap(t[0], t[1]);
  expect_same(measured(mesh), measured(mirrored));
  expect_same(measured(mesh), measured(turned));
}

PLANISH_PROPERTY(MeasureProperty, DoesNotChangeWithSize, 4'000) {
  const TriMesh mesh = arbitrary_relief();
  const double size = std::pow(10.0, *rc::gen::inRange(-300, 150));
  TriMesh scaled = mesh;
  for (Vec3& p : scaled.positions)
    p = size * p;
  expect_same(measured(mesh), measured(scaled));
}

PLANISH_PROPERTY(MeasureProperty, AgreesWithASumOfArctangents, 1'000) {
  const TriMesh mesh = arbitrary_relief();
  const plain::Patch patch(mesh);
  const auto defects = angle_defects(Patch(mesh));
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    RC_ASSERT(std::abs(defects[v] - (patch.inner[v] ? patch.defect(v) : 0.0)) < 1e-12);
  }
}

/// The defects of all vertices, those of the border measured against pi, are 2 pi times the Euler
/// characteristic: of disks, tubes, tori and balls of any shape.
PLANISH_PROPERTY(MeasureProperty, FulfilsGaussAndBonnet, 4'000) {
  const auto a = *rc::gen::inRange<std::size_t>(3, 8), b = *rc::gen::inRange<std::size_t>(3, 8);
  TriMesh mesh = *rc::gen::element(meshes::flat_grid(a, b), meshes::tube(a, b), meshes::torus(a, b),
                                   meshes::fan(a), meshes::tetrahedron());
  meshes::Random random(*rc::gen::arbitrary<std::uint32_t>());
  for (Vec3& p : mesh.positions)
    p += 0.3 * Vec3{random.number(), random.number(), random.number()};
  const Topology topology = inspect(mesh).topology;
  const plain::Patch patch(mesh);
  const auto defects = angle_defects(Patch(mesh));
  double total = 0.0;
  for (Index v = 0; v < mesh.positions.size(); ++v)
    total += patch.inner[v] ? defects[v] : std::numbers::pi - patch.angle_sum(v);
  RC_ASSERT(std::abs(total - 2.0 * std::numbers::pi *
                                 static_cast<double>(topology.euler_characteristic)) < 1e-11);
}

}  // namespace
}  // namespace planish
