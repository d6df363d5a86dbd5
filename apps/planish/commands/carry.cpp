#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include <planish/draw/format_drawing.h>
#include <planish/io/mesh_format.h>
#include <planish/mesh/carry.h>
#include <planish/sheet/pattern_sheet.h>

#include "commands/commands.h"
#include "cut/drawn_on_pattern.h"
#include "flags/units.h"
#include "io/read_drawing.h"
#include "model/model_flags.h"
#include "platform/path.h"
#include "sheet/carry/drawing_on_sheet.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/session.h"
#include "shell/text.h"
#include "shell/values.h"
#include "text/carry_text.h"
#include "text/summary.h"

namespace planish::cli {

namespace {

/// The two meshes between which lines are carried.
struct CarryPair {
  std::string from_path, to_path;
  Patch from, to;
};

/// @throws Error unsupported_format
void check_extension(const std::string& path, const std::string& what) {
  if (is_svg(path) || lower_extension(path) == ".obj") return;
  throw Error(ErrorCode::unsupported_format, what + " must be an .svg or an .obj file",
              {.path = path});
}

Patch patch_of(const std::string& path, const Arguments& arguments, Session& session) {
  const TriMesh mesh = read_piece(path, arguments, session).mesh;
  return about(path, [&] { return Patch(mesh); });
}

CarryPair pair_from(const Arguments& arguments, Session& session) {
  const std::string from = arguments.text("--from"), to = arguments.text("--to");
  CarryPair pair{from, to, patch_of(from, arguments, session), patch_of(to, arguments, session)};
  about(to, [&] { check_same_triangles(pair.from.mesh(), pair.to.mesh()); });
  const auto check_flat = [](const std::string& drawing, const std::string& path,
                             const Patch& patch, const std::string& flag) {
    if (!is_svg(drawing) || is_flat(patch.mesh())) return;
    throw Error(ErrorCode::unsupported_format,
                "lines of an .svg lie on a flat mesh, but " + path + " of " + flag +
                    " is a surface in space; take an .obj, or exchange --from and --to",
                {.path = drawing});
  };
  check_flat(arguments.operands.front(), from, pair.from, "--from");
  check_flat(arguments.text("--output"), to, pair.to, "--to");
  return pair;
}

ReadDrawing read_drawing(const std::string& path, const CarryPair& pair, Unit unit) {
  if (is_svg(path)) return drawing_on_sheet(path, pair.from, unit);
  return {read_obj_lines(path_of(path)), {}};
}

double length_of(const TracedLines& traced, const Patch& patch) {
  double sum = 0.0;
  for (const auto& line : traced.lines) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      sum += norm(position_of(line[i], patch.positions()) -
                  position_of(line[i - 1], patch.positions()));
    }
  }
  return sum;
}

DrawnLines placed_on(const Patch& patch, const TracedLines& traced) {
  DrawnLines drawn;
  for (const auto& line : traced.lines) {
    std::vector<Vec3>& points = drawn.lines.emplace_back().points;
    for (const SurfacePoint& place : line)
      points.push_back(position_of(place, patch.positions()));
  }
  for (const SurfacePoint& place : traced.points)
    drawn.points.push_back(position_of(place, patch.positions()));
  return drawn;
}

CarryFigures carried_figures(const TracedLines& traced, const CarryPair& pair, ReadDrawing read) {
  return {traced.lines.size(),
          traced.points.size(),
          length_of(traced, pair.from),
          length_of(traced, pair.to),
          traced.outside_length,
          traced.outside_points,
          traced.farthest,
          std::move(read.left_out)};
}

void note_left_out(Session& session, const std::string& path, const CarryFigures& figures) {
  std::string text;
  for (const auto& [kind, count] : figures.left_out)
    text += (text.empty() ? "" : ", ") + kind + " (" + std::to_string(count) + ")";
  if (!text.empty()) session.note(path + ": left out what is no line: " + text);
}

CommandResult run_carry(const Arguments& arguments, Session& session) {
  const std::string& path = arguments.operands.front();
  const std::string output = arguments.text("--output");
  check_extension(path, "the file of lines");
  check_extension(output, "what is written");
  const Unit unit = unit_from(arguments);
  const CarryPair pair = pair_from(arguments, session);
  ReadDrawing read = read_drawing(path, pair, unit);
  const TracedLines traced = about(path, [&] { return trace_lines(pair.from, read.drawn); });
  if (traced.lines.empty() && traced.points.empty()) {
    throw Error(ErrorCode::malformed_file,
                "all that it draws lies off " + pair.from_path +
                    ": is it the mesh that was drawn on, in the same units?",
                {.path = path});
  }
  const CarryFigures figures = carried_figures(traced, pair, std::move(read));
  note_left_out(session, path, figures);
  const DrawnLines drawn = placed_on(pair.to, traced);
  const std::string content = is_svg(output)
                                  ? format_svg(carried_sheet(pair.to, drawn, unit, stem_of(path)))
                                  : format_obj_lines(drawn);
  CommandResult outcome = {
      path + " -> " + output + "\n" + carry_text(figures, pair.from_path, unit),
      carry_json(figures, unit, output)};
  session.write({{path_of(output), content}});
  return outcome;
}

}  // namespace

Command carry_command() {
  return {
      "carry",
      "move lines from a pattern to its surface, or back",
      "LINES --from MESH --to MESH -o OUT",
      "Moves lines and points from one mesh to the same places of another mesh with the same "
      "triangles, such as flat.obj and processed.obj, which flatten writes. LINES is an .obj with "
      "lines (l) and points (p) in the coordinates of the first mesh, or a copy of pattern.svg "
      "with lines on a new layer. OUT is an .obj, or an .svg at true size if the second mesh is "
      "flat. Parts of lines outside the mesh are left out; their length is printed.",
      {"LINES"},
      {{"Output",
        {{"--from",
          "MESH",
          "the mesh on which the lines are drawn",
          0,
          true,
          {.extensions = names_of(k_mesh_formats)}},
         {"--to",
          "MESH",
          "the mesh to which they go",
          0,
          true,
          {.extensions = names_of(k_mesh_formats)}},
         {"--output",
          "OUT",
          "the lines on the second mesh: .obj, or .svg if that mesh is flat",
          'o',
          true,
          {.extensions = {"obj", "svg"}}},
         unit_flag()}},
       model_flags()},
      {"planish carry drawn.svg --from flat.obj --to processed.obj -o logo.obj",
       "planish carry logo.obj --from processed.obj --to flat.obj -o drawn.svg"},
      run_carry,
      false,
      false,
      {{.extensions = {"obj", "svg"}}}};
}

}  // namespace planish::cli
