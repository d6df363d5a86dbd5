#pragma once

// What holds of every mesh reader.

#include <string>
#include <string_view>
#include <vector>

#include <planish/io/mesh_format.h>
#include <planish/io/read_mesh.h>
#include <planish/mesh/inspect.h>

#include "fuzz/check.h"

namespace planish::fuzz {

inline void check_groups(const FaceGroups& groups, std::size_t triangles) {
  if (groups.of_triangle.empty()) {
    check(groups.names.empty() && groups.kind.empty(), "no groups are no groups at all");
    return;
  }
  check(groups.names.size() > 1, "a file with groups has several");
  check(groups.of_triangle.size() == triangles, "every triangle has a group");
  for (const Index group : groups.of_triangle)
    check(group < groups.names.size(), "groups have names");
}

/// Reads bytes as a format, checks the mesh that comes out, and writes and reads it again.
inline void check_mesh_reader(std::string_view bytes, MeshFormat format) {
  allow_refusal_of("mesh", [&] {
    const ReadResult result = parse_mesh(bytes, format, "mesh");
    const TriMesh& mesh = result.mesh;
    check(!mesh.triangles.empty(), "a mesh that is read has triangles");
    check(mesh.triangles.size() <= bytes.size(), "triangles take bytes");
    check(mesh.positions.size() <= bytes.size(), "vertices take bytes");
    for (const Vec3& p : mesh.positions)
      check(is_finite(p), "coordinates are finite");
    for (const Triangle& triangle : mesh.triangles) {
      for (const Index v : triangle)
        check(v < mesh.positions.size(), "indices are in range");
    }
    check_groups(result.groups, mesh.triangles.size());
    check(!result.unit || (!result.unit->words.empty() && result.unit->words.size() < 200),
          "a unit is stated in a few words");
    allow_refusal_of("mesh", [&] {
      const ReadResult strict = parse_mesh(bytes, format, "mesh", {.strict = true});
      check(strict.mesh.positions == mesh.positions && strict.mesh.triangles == mesh.triangles,
            "what is strictly right is read as it is");
    });
    inspect(mesh);
    const TriMesh again = parse_mesh(format_mesh(mesh, MeshFormat::obj), MeshFormat::obj).mesh;
    check(again.positions == mesh.positions && again.triangles == mesh.triangles,
          "what is read can be written and read again");
  });
}

}  // namespace planish::fuzz
