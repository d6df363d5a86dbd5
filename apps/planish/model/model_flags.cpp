#include "model/model_flags.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include <planish/mesh/inspect.h>

#include "flags/quantities.h"
#include "flags/scale_flag.h"
#include "flags/units.h"
#include "model/model_text.h"
#include "model/orient.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

constexpr std::array k_divisions = {Divide::objects, Divide::materials, Divide::parts};
constexpr std::array k_sides = {Side::outer, Side::inner};
constexpr Range k_from_zero = {.min = 0.0};

/// Where the name that begins there ends: at the next comma, but behind a known name that has
/// commas itself, also with a number as in "left, small-2".
std::size_t end_of_name(const std::string& text, std::size_t begin,
                        std::span<const std::string> known) {
  std::size_t end = std::min(text.find(',', begin), text.size());
  for (const std::string& name : known) {
    if (name.find(',') == std::string::npos || text.compare(begin, name.size(), name) != 0)
      continue;
    std::size_t behind = begin + name.size();
    if (behind < text.size() && text[behind] == '-')
      behind = std::min(text.find_first_not_of("0123456789", behind + 1), text.size());
    if (behind == text.size() || text[behind] == ',') end = std::max(end, behind);
  }
  return end;
}

/// The names of a list, as they were typed.
std::vector<std::string> names_from(const Arguments& arguments, const std::string& flag,
                                    std::span<const std::string> known) {
  std::vector<std::string> names;
  if (!arguments.has(flag)) return names;
  for (const Field& field : arguments.flags.at(flag)) {
    const std::string text = field_text(field);
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = end_of_name(text, begin, known);
      if (end > begin) names.push_back(text.substr(begin, end - begin));
      begin = end + 1;
    }
  }
  if (names.empty())
    throw UsageError(flag + " needs the names of pieces, with commas between them");
  return names;
}

double model_length(const Arguments& arguments, const std::string& flag) {
  return quantity_value(flag, arguments.value(flag), Quantity::length, k_from_zero, arguments);
}

Flag names_flag(const std::string& name, const std::string& doc) {
  return {name, "PIECES", doc, 0, false, {.repeats = true}};
}

}  // namespace

FlagGroup model_flags() {
  return {
      "What is read",
      {{"--divide",
        "KIND",
        "what makes a piece: objects (or groups, if the file has no objects), materials, or parts, "
        "which are not connected to each other (default objects)",
        0,
        false,
        {.choices = names_of(k_divisions), .standard = "objects"}},
       names_flag(
           "--only",
           "take only these objects, groups, materials or pieces: names, separated by commas"),
       names_flag(
           "--without",
           "leave out these objects, groups, materials or pieces: names, separated by commas"),
       {"--weld",
        "LENGTH",
        "join borders that lie within LENGTH of each other (1.5 or 1.5mm; default: a length that "
        "fits the size of the mesh)",
        0,
        false,
        {.range = k_from_zero, .optional = true}},
       {"--fill-holes",
        "LENGTH",
        "close holes whose border is at most LENGTH long (1.5 or 1.5mm)",
        0,
        false,
        {.range = k_from_zero}},
       {"--side",
        "NAME",
        "of a wall with a thickness, take one side: outer or inner",
        0,
        false,
        {.choices = names_of(k_sides)}},
       {"--flip", "", "turn the surface over: its inner side becomes the outer one"},
       {"--strict", "",
        "take the mesh as it is; repair and leave out only what other flags ask for"}}};
}

ModelOptions model_options_from(const Arguments& arguments, std::span<const std::string> known) {
  ModelOptions options;
  options.strict = arguments.has("--strict");
  if (arguments.has("--weld")) {
    options.weld = arguments.text("--weld").empty() ? 0.0 : model_length(arguments, "--weld");
  }
  if (arguments.has("--fill-holes")) options.fill_holes = model_length(arguments, "--fill-holes");
  options.divide =
      value_named("kind of pieces", arguments.text("--divide", "objects"), k_divisions);
  options.only = names_from(arguments, "--only", known);
  options.without = names_from(arguments, "--without", known);
  if (arguments.has("--side"))
    options.side = value_named("side", arguments.text("--side"), k_sides);
  options.flip = arguments.has("--flip");
  return options;
}

std::vector<std::string> names_in(const ReadResult& file, const std::string& name) {
  std::vector<std::string> names = file.groups.names;
  names.insert(names.end(), file.materials.names.begin(), file.materials.names.end());
  names.push_back(name);
  return names;
}

void check_asked_names(const Arguments& arguments, std::span<const std::string> names) {
  check_names(model_options_from(arguments, names), names);
}

void check_model(const Model& model, const Arguments& arguments, const std::string& path) {
  std::vector<std::string> names = model.names;
  names.insert(names.end(), arguments.names_of_all.begin(), arguments.names_of_all.end());
  check_asked_names(arguments, names);
  if (!model.pieces.empty()) return;
  throw Error(ErrorCode::no_triangles, "nothing is left of the file", {.path = path});
}

namespace {

/// The mesh in the unit of the run.
/// @param unit as read_model_of_several() has it
ReadResult read_in_run_unit(const std::string& path, std::optional<Unit> unit,
                            const ReadOptions& options, const Arguments& arguments,
                            Session& session) {
  const RunUnit run = run_unit_from(arguments);
  ReadResult file = session.read(path, options);
  if (!unit) return in_run_unit(std::move(file), run, path, session);
  if (file.unit && file.unit->unit != *unit) {
    session.note(path + ": the file says \"" + file.unit->words + "\", but the product file says " +
                 std::string(to_string(*unit)) + ", which is taken");
  }
  const double scale = millimetres_per(*unit) / millimetres_per(run.unit);
  file.mesh = scaled(std::move(file.mesh), scale, path);
  return file;
}

}  // namespace

Model read_model_of_several(const FileOfSeveral& of, const Arguments& arguments, Session& session) {
  const std::string& path = of.path;
  const double scale = scale_from(arguments);
  const ReadOptions reading = {.strict = arguments.has("--strict")};
  ReadResult file = read_in_run_unit(path, of.unit, reading, arguments, session);
  file.notes.clear();  // they were shown
  file.mesh = scaled(std::move(file.mesh), scale, path);
  std::vector<std::string> known = names_in(file, of.name);
  known.insert(known.end(), of.known.begin(), of.known.end());
  known.insert(known.end(), arguments.names_of_all.begin(), arguments.names_of_all.end());
  const ModelOptions options = model_options_from(arguments, known);
  Model model = about(path, [&] { return prepare_model(std::move(file), options, of.name); });
  for (const std::string& note : work_notes(model.work, ShownLengths(unit_from(arguments))))
    session.note(path + ": " + note);
  return model;
}

Model read_model(const std::string& path, const Arguments& arguments, Session& session) {
  Model model = read_model_of_several({path, stem_of(path)}, arguments, session);
  check_model(model, arguments, path);
  for (const std::string& note : turn_inside_out(model, model_options_from(arguments, model.names)))
    session.note(path + ": " + note);
  return model;
}

TriMesh read_whole(const std::string& path, const Arguments& arguments, Session& session) {
  Model model = read_model(path, arguments, session);
  return arguments.has("--strict") ? std::move(model.mesh) : divided(model);
}

namespace {

/// The first vertex that the second piece uses.
Index vertex_of_second(const Model& model) {
  Index first = std::numeric_limits<Index>::max();
  for (std::size_t t = 0; t < model.piece_of.size(); ++t) {
    if (model.piece_of[t] != 1) continue;
    for (const Index v : model.mesh.triangles[t])
      first = std::min(first, v);
  }
  return first;
}

}  // namespace

Model read_piece(const std::string& path, const Arguments& arguments, Session& session) {
  Model model = read_model(path, arguments, session);
  const std::size_t count = model.pieces.size();
  if (count == 1) return model;
  // What is mended without --strict is wrong with the mesh, before it has pieces.
  if (arguments.has("--strict"))
    about(path, [&] { require(inspect(model.mesh), Purpose::evolve); });
  const Index second = vertex_of_second(model);
  throw Error(ErrorCode::several_components,
              "holds " + std::to_string(count) + " pieces (" + list_of_some(model.pieces) +
                  "), the second with vertex " + std::to_string(second),
              {.path = path, .first = second, .count = count});
}

}  // namespace planish::cli
