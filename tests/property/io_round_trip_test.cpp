#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <planish/io/mesh_format.h>
#include <planish/io/read_mesh.h>

#include <gtest/gtest.h>

#include "property/property.h"

namespace planish {
namespace {

/// Any finite double: of any bits, so that all magnitudes are as likely.
rc::Gen<double> finite_double() {
  return rc::gen::suchThat(rc::gen::map(rc::gen::arbitrary<std::uint64_t>(),
                                        [](std::uint64_t bits) {
                                          // Small bit patterns come often: reversed, they are not
                                          // denormal.
                                          return std::bit_cast<double>(
                                              bits % 2 == 0 ? bits : (bits << 52) ^ (bits >> 1));
                                        }),
                           [](double value) { return std::isfinite(value); });
}

rc::Gen<double> finite_float() {
  return rc::gen::suchThat(
      rc::gen::map(rc::gen::arbitrary<std::uint32_t>(),
                   [](std::uint32_t bits) {
                     return static_cast<double>(std::bit_cast<float>(bits * 2654435761U));
                   }),
      [](double value) { return std::isfinite(value); });
}

/// Any mesh of some vertices and at least one triangle, mostly a broken one.
TriMesh any_mesh(const rc::Gen<double>& coordinate) {
  const auto position = rc::gen::construct<Vec3>(coordinate, coordinate, coordinate);
  const auto positions = *rc::gen::nonEmpty(rc::gen::container<std::vector<Vec3>>(position));
  const auto vertex = rc::gen::inRange<Index>(0, static_cast<Index>(positions.size()));
  const auto triangle = rc::gen::container<Triangle>(vertex);
  return {.positions = positions,
          .triangles = *rc::gen::nonEmpty(rc::gen::container<std::vector<Triangle>>(triangle))};
}

bool same_bits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)) == 0;
}

PLANISH_PROPERTY(IoRoundTrip, KeepsEveryBitOfPositionsAndTriangles, 500) {
  const TriMesh mesh = any_mesh(finite_double());
  for (const MeshFormat format : {MeshFormat::obj, MeshFormat::ply, MeshFormat::off}) {
    const ReadResult result = parse_mesh(format_mesh(mesh, format), format);
    RC_ASSERT(same_bits(result.mesh.positions, mesh.positions));
    RC_ASSERT(result.mesh.triangles == mesh.triangles);
    RC_ASSERT(result.notes.empty());
  }
}

PLANISH_PROPERTY(IoRoundTrip, KeepsThePlacesOfStlCornersThatAreFloats, 500) {
  const TriMesh mesh = any_mesh(finite_float());
  const TriMesh again = parse_mesh(format_mesh(mesh, MeshFormat::stl), MeshFormat::stl).mesh;
  RC_ASSERT(again.triangles.size() == mesh.triangles.size());
  Index seen = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = again.triangles[i][k];
      RC_ASSERT(again.positions[v] == mesh.positions[mesh.triangles[i][k]]);
      RC_ASSERT(v <= seen);  // numbered by first use
      seen = std::max(seen, v + 1);
    }
  }
  RC_ASSERT(seen == again.positions.size());
}

}  // namespace
}  // namespace planish
