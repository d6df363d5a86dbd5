#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <planish/core/error.h>
#include <planish/io/read_features.h>
#include <planish/io/read_mesh.h>

#include "io/file/file_bytes.h"
#include "io/formats/formats.h"
#include "io/formats/obj_texture.h"
#include "platform/path.h"

namespace planish {

namespace {

/// An edge by its ends, the lower one first: by places, as files have a vertex for each side of a
/// seam.
using Ends = std::array<Vec3, 2>;

struct ByCoordinates {
  bool operator()(const Ends& a, const Ends& b) const {
    const auto row = [](const Ends& e) {
      return std::tie(e[0].x, e[0].y, e[0].z, e[1].x, e[1].y, e[1].z);
    };
    return row(a) < row(b);
  }
};

bool is_lower(Vec3 a, Vec3 b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// Finds edges of which the sides have something else.
template <class Side>
class Differences {
 public:
  /// @param side of an edge, in the order of its ends
  void add(Vec3 a, Vec3 b, const Side& side, std::optional<std::size_t> line) {
    const auto [known, is_first] = sides_.emplace(Ends{a, b}, side);
    if (!is_first && !(known->second == side)) found_.emplace(known->first, line);
  }

  DrawnLines lines(const std::string& name) const {
    DrawnLines drawn;
    drawn.lines.reserve(found_.size());
    for (const auto& [ends, line] : found_)
      drawn.lines.push_back({{ends[0], ends[1]}, {.path = name, .line = line}});
    return drawn;
  }

 private:
  std::map<Ends, Side, ByCoordinates> sides_;
  std::map<Ends, std::optional<std::size_t>, ByCoordinates> found_;
};

/// Edges at which the texture is elsewhere on one side than on the other.
DrawnLines texture_seams(const ObjTexture& texture, const std::string& name) {
  Differences<std::array<std::optional<Vec2>, 2>> seams;
  for (const TexturedFace& face : texture.faces) {
    for (std::size_t k = 0; k < face.corners.size(); ++k) {
      const TexturedCorner &one = face.corners[k],
                           &next = face.corners[(k + 1) % face.corners.size()];
      Vec3 a = texture.positions[one.vertex], b = texture.positions[next.vertex];
      std::array<std::optional<Vec2>, 2> side = {one.place, next.place};
      if (a == b) continue;
      if (is_lower(b, a)) std::swap(a, b), std::swap(side[0], side[1]);
      seams.add(a, b, side, face.line);
    }
  }
  return seams.lines(name);
}

/// Edges between triangles of two parts.
DrawnLines borders_between(const TriMesh& mesh, const FaceGroups& groups, const std::string& name) {
  Differences<Index> borders;
  for (std::size_t t = 0; t < groups.of_triangle.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 a = mesh.positions[mesh.triangles[t][k]],
                 b = mesh.positions[mesh.triangles[t][(k + 1) % 3]];
      borders.add(is_lower(a, b) ? a : b, is_lower(a, b) ? b : a, groups.of_triangle[t], {});
    }
  }
  return borders.lines(name);
}

}  // namespace

DrawnLines read_model_lines(const std::filesystem::path& path, ModelLines lines) {
  const std::string name = utf8_of(path);
  DrawnLines drawn;
  if (lines == ModelLines::texture) {
    if (lower_extension(path) != ".obj") {
      throw Error(ErrorCode::unsupported_format,
                  "texture coordinates are read of .obj files only; export the model as one",
                  {.path = name});
    }
    const FileBytes file(path);
    drawn = texture_seams(parse_obj_texture(file.view(), name), name);
  } else {
    const ReadResult file = read_mesh(path);
    const bool has_groups = !file.groups.names.empty();
    const FaceGroups& parts =
        lines == ModelLines::groups && has_groups ? file.groups : file.materials;
    if (parts.names.empty()) {
      throw Error(ErrorCode::misplaced_cut, "the file has no two groups or materials",
                  {.path = name});
    }
    drawn = borders_between(file.mesh, parts, name);
  }
  if (drawn.lines.empty()) {
    throw Error(ErrorCode::misplaced_cut,
                lines == ModelLines::texture ? "its texture has no seam inside the surface"
                                             : "its groups or materials share no edge",
                {.path = name});
  }
  return drawn;
}

}  // namespace planish
