#include "cut/drawn_on_pattern.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include <planish/io/read_mesh.h>
#include <planish/sheet/pattern_sheet.h>
#include <planish/unfold/unfold.h>

#include "io/read_drawing.h"
#include "platform/path.h"
#include "sheet/carry/drawing_on_sheet.h"
#include "shell/file_name.h"

namespace planish::cli {

namespace {

std::vector<std::vector<Vec2>> lines_on(const SvgDrawing& drawing, std::string_view layer) {
  std::vector<std::vector<Vec2>> lines;
  for (const SvgLine& line : drawing.lines) {
    if (line.layer == layer) lines.push_back(line.points);
  }
  return lines;
}

/// By the outline where an allowance surrounds it, else by what is cut.
Vec2 origin_in(const SvgDrawing& drawing, const Patch& flat, Unit unit, const std::string& path) {
  const std::vector<std::vector<Vec2>> seam = lines_on(drawing, "seam");
  std::vector<std::vector<Vec2>> cut = lines_on(drawing, "cut");
  for (std::vector<Vec2>& hole : lines_on(drawing, "hole"))
    cut.push_back(std::move(hole));
  if (seam.empty()) return origin_on_sheet(cut, {}, flat, unit, path);
  const bool is_whole = std::all_of(seam.begin(), seam.end(), [](const std::vector<Vec2>& line) {
    return line.front() == line.back();
  });
  return origin_on_sheet(seam, is_whole ? std::vector<std::vector<Vec2>>{} : cut, flat, unit, path);
}

}  // namespace

bool is_svg(const std::string& path) {
  return lower_extension(path) == ".svg";
}

ReadDrawing drawing_on_sheet(const std::string& path, const Patch& flat, Unit unit) {
  SvgDrawing drawing = read_svg(path_of(path), k_sheet_layers);
  const Vec2 origin = origin_in(drawing, flat, unit, path);
  const double z = flat.positions()[flat.triangles().front().front()].z;
  const auto place = [&](Vec2 p) {
    const Vec2 q = 1.0 / millimetres_per(unit) * (p - origin);
    return Vec3{q.x, q.y, z};
  };
  ReadDrawing read{{}, std::move(drawing.left_out)};
  for (const SvgLine& line : drawing.lines) {
    if (!line.layer.empty()) continue;
    if (line.points.size() == 1) {
      read.drawn.points.push_back(place(line.points.front()));
      continue;
    }
    DrawnLine& some = read.drawn.lines.emplace_back(DrawnLine{{}, {path, line.line}});
    for (const Vec2 p : line.points)
      some.points.push_back(place(p));
  }
  if (read.drawn.lines.empty() && read.drawn.points.empty()) {
    throw Error(ErrorCode::malformed_file,
                "the file shows no lines besides those of the pattern's own layers; draw on a "
                "layer of your own",
                {.path = path});
  }
  return read;
}

Patch pattern_below(const std::string& path, const Patch& patch, double scale) {
  for (const MeshFormat format : k_mesh_formats) {
    const std::filesystem::path beside =
        path_of(path).parent_path() / path_of("flat." + std::string(to_string(format)));
    std::error_code ignored;
    if (!std::filesystem::exists(beside, ignored)) continue;
    TriMesh flat = read_mesh(beside).mesh;
    if (flat.triangles == patch.triangles() && is_flat(flat)) return Patch(std::move(flat));
  }
  std::vector<Vec3> positions;
  for (const Vec2 p : unfold(patch).positions)
    positions.push_back({scale * p.x, scale * p.y, 0.0});
  return patch.with_positions(std::move(positions));
}

}  // namespace planish::cli
