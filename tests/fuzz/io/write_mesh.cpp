// Writing any mesh and reading it back.

#include <cstring>
#include <vector>

#include <planish/io/mesh_format.h>
#include <planish/io/read_mesh.h>

#include "fuzz/bytes.h"
#include "fuzz/check.h"

using namespace planish;

namespace {

TriMesh any_mesh(fuzz::Bytes& bytes) {
  TriMesh mesh;
  const std::size_t vertices = bytes.whole(0, 20), triangles = bytes.whole(0, 20);
  for (std::size_t t = 0; t < triangles; ++t)
    mesh.triangles.push_back({bytes.byte(), bytes.byte(), bytes.byte()});
  if (bytes.flag()) {
    for (Triangle& triangle : mesh.triangles) {
      for (Index& v : triangle)
        v = vertices > 0 ? v % static_cast<Index>(vertices) : 0;
    }
  }
  for (std::size_t v = 0; v < vertices; ++v)
    mesh.positions.push_back({bytes.any_double(), bytes.any_double(), bytes.any_double()});
  return mesh;
}

bool same_bits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)) == 0;
}

Vec3 as_floats(Vec3 p) {
  const auto rounded = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  return {rounded(p.x), rounded(p.y), rounded(p.z)};
}

void check_stl(const TriMesh& mesh, const TriMesh& again) {
  fuzz::check(again.triangles.size() == mesh.triangles.size(), "STL keeps triangles");
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 p = as_floats(mesh.positions[mesh.triangles[t][k]]);
      fuzz::check(again.positions[again.triangles[t][k]] == p, "STL keeps corners as floats");
    }
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const TriMesh mesh = any_mesh(bytes);
  for (const MeshFormat format : k_mesh_formats) {
    fuzz::allow_refusal([&] {
      const std::string written = format_mesh(mesh, format);
      if (mesh.triangles.empty()) return;
      TriMesh again;
      try {
        again = parse_mesh(written, format, "again").mesh;
      } catch (const Error&) {
        fuzz::check(false, "what is written can be read");
      }
      if (format == MeshFormat::stl) return check_stl(mesh, again);
      fuzz::check(same_bits(again.positions, mesh.positions), "positions keep every bit");
      fuzz::check(again.triangles == mesh.triangles, "triangles stay");
    });
  }
  return 0;
}
