#include "panels/uv_map.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include <planish/core/error.h>
#include <planish/io/read_mesh.h>
#include <planish/mesh/weld.h>

#include "io/file/file_bytes.h"
#include "io/formats/obj_texture.h"
#include "panels/piece/laid_flat.h"
#include "panels/seams/seam_chains.h"
#include "platform/path.h"

namespace planish {

namespace {

/// How many triangles parse_mesh() makes of a face.
std::size_t triangles_of(const TexturedFace& face) {
  std::vector<Index> vertices;
  for (const TexturedCorner& corner : face.corners)
    vertices.push_back(corner.vertex);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  while (vertices.size() > 1 && vertices.front() == vertices.back())
    vertices.pop_back();
  return std::max<std::size_t>(vertices.size(), 3) - 2;
}

/// Joins the two sides of cuts. Triangles may be turned over for it, so corners are found by place.
UvMap welded(UvMap map, const std::string& name) {
  const WeldedMesh welded = weld(map.mesh, 0.0);
  if (welded.joined == 0) return map;
  UvMap result{welded.mesh, {}};
  for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
    const Triangle& source = map.mesh.triangles[welded.source[t]];
    std::array<Vec2, 3>& corners = result.corners.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 at = result.mesh.positions[result.mesh.triangles[t][i]];
      const auto same = std::find_if(source.begin(), source.end(),
                                     [&](Index v) { return map.mesh.positions[v] == at; });
      if (same == source.end()) {
        throw Error(ErrorCode::misplaced_cut, "a vertex of a cut lies in a side of a triangle",
                    {.path = name});
      }
      corners[i] = map.corners[welded.source[t]][static_cast<std::size_t>(same - source.begin())];
    }
  }
  return result;
}

}  // namespace

UvMap read_uv_map(const std::filesystem::path& path) {
  const std::string name = utf8_of(path);
  UvMap map{read_mesh(path).mesh, {}};
  const FileBytes file(path);
  for (const TexturedFace& face : parse_obj_texture(file.view(), name).faces) {
    for (std::size_t left = triangles_of(face); left > 0; --left) {
      const Triangle& triangle = map.mesh.triangles.at(map.corners.size());
      std::array<Vec2, 3>& corners = map.corners.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const auto corner =
            std::find_if(face.corners.begin(), face.corners.end(),
                         [&](const TexturedCorner& c) { return c.vertex == triangle[i]; });
        if (corner == face.corners.end() || !corner->place) {
          throw Error(ErrorCode::misplaced_cut, "a corner of the face has no texture coordinate",
                      {.path = name, .line = face.line});
        }
        corners[i] = *corner->place;
      }
    }
  }
  return welded(std::move(map), name);
}

UvMap uv_map_of(const PanelSuggestion& found, const StrainLimits& limits) {
  const PanelMesh mesh{Patch(found.mesh)};
  OpenEdges open(mesh.edges().size(), 0);
  for (const std::vector<Index>& seam : found.seams) {
    for (std::size_t k = 1; k < seam.size(); ++k)
      open[find_edge(mesh, seam[k - 1], seam[k])] = 1;
  }
  UvMap map{found.mesh, std::vector<std::array<Vec2, 3>>(found.mesh.triangles.size())};
  Vec2 shift{};
  for (const SuggestedPanel& panel : found.panels) {
    const PieceCorners corners(mesh, open, panel.triangles);
    const auto flat = laid_flat(mesh, corners, {limits}, {});
    if (!flat) throw Error(ErrorCode::unfold_failed, "a panel has no pattern");
    for (std::size_t k = 0; k < panel.triangles.size(); ++k) {
      for (std::size_t i = 0; i < 3; ++i)
        map.corners[panel.triangles[k]][i] = flat->pattern.positions[corners.corners(k)[i]] + shift;
    }
    shift.x += 1.05 * flat->pattern.width;
  }
  return map;
}

std::string format_panels(const PanelSuggestion& found, const UvMap& map) {
  std::ostringstream text;
  text.precision(17);
  for (const Vec3 p : map.mesh.positions)
    text << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
  for (const std::array<Vec2, 3>& corners : map.corners) {
    for (const Vec2 p : corners)
      text << "vt " << p.x << ' ' << p.y << '\n';
  }
  for (std::size_t k = 0; k < found.panels.size(); ++k) {
    text << "g panel-" << k + 1 << '\n';
    for (const Index t : found.panels[k].triangles) {
      text << 'f';
      for (std::size_t i = 0; i < 3; ++i)
        text << ' ' << map.mesh.triangles[t][i] + 1 << '/' << 3 * std::size_t{t} + i + 1;
      text << '\n';
    }
  }
  for (const std::vector<Index>& seam : found.seams) {
    text << 'l';
    for (const Index v : seam)
      text << ' ' << v + 1;
    text << '\n';
  }
  return text.str();
}

}  // namespace planish
