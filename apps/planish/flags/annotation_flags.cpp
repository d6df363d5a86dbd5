#include "flags/annotation_flags.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>

#include <planish/pattern/read_annotations.h>

#include <fast_float/fast_float.h>

#include "flags/quantities.h"
#include "flags/scale_flag.h"
#include "flags/units.h"
#include "platform/path.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/values.h"
#include "text/lengths.h"

namespace planish::cli {

namespace {

constexpr std::array k_corners = {Corners::mitre, Corners::square, Corners::round};

constexpr Range k_quantity = {1.0, 1'000'000.0};

/// Millimetres on the sheet.
double length_from(const Arguments& arguments, const std::string& flag) {
  constexpr Range positive = {.min = std::numeric_limits<double>::min()};
  return millimetres_per(unit_from(arguments)) *
         quantity_value(flag, arguments.flags.at(flag), Quantity::length, positive, arguments);
}

std::optional<Allowance> allowance_from(const Arguments& arguments) {
  if (!arguments.has("--allowance")) return std::nullopt;
  Allowance allowance{.width = length_from(arguments, "--allowance")};
  if (arguments.has("--corners")) {
    allowance.corners = value_named("kind of corners", arguments.flags.at("--corners"), k_corners);
  }
  return allowance;
}

/// Three numbers with commas between them; nothing for anything else.
std::optional<Vec3> direction_in(const std::string& text) {
  std::array<double, 3> numbers = {};
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0 && (at == end || *at++ != ',')) return std::nullopt;
    const auto parsed = fast_float::from_chars(at, end, numbers[i]);
    if (parsed.ec != std::errc() || !std::isfinite(numbers[i])) return std::nullopt;
    at = parsed.ptr;
  }
  if (at != end) return std::nullopt;
  return Vec3{numbers[0], numbers[1], numbers[2]};
}

std::optional<Grain> grain_from(const Arguments& arguments) {
  if (!arguments.has("--grain")) return std::nullopt;
  const std::string& text = arguments.flags.at("--grain");
  if (text.find(',') == std::string::npos) {
    return quantity_value("--grain", text, Quantity::angle, {-360.0, 360.0}, arguments);
  }
  const auto direction = direction_in(text);
  if (!direction || !(norm(*direction) > 0.0)) {
    throw UsageError("--grain is \"" + text +
                     "\" but must be a direction such as 0,0,1 or an angle such as 30deg");
  }
  return *direction;
}

/// Two numbers of vertices with a comma between them.
std::optional<FoldLine> fold_from(const Arguments& arguments) {
  if (!arguments.has("--fold")) return std::nullopt;
  const std::string& text = arguments.flags.at("--fold");
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos)
    throw UsageError("--fold is \"" + text + "\" but must be two vertices, as 12,57");
  constexpr Range range = {.min = 0.0, .max = std::numeric_limits<std::int32_t>::max()};
  const auto vertex = [&](const std::string& word) {
    return static_cast<Index>(whole_number_of("--fold", word, range));
  };
  return FoldLine{vertex(text.substr(0, comma)), vertex(text.substr(comma + 1))};
}

PieceLabel label_from(const Arguments& arguments) {
  PieceLabel label{.name = arguments.value_or("--piece-name", ""),
                   .size = arguments.value_or("--size", ""),
                   .fabric = arguments.value_or("--fabric", ""),
                   .note = arguments.value_or("--note", "")};
  if (arguments.has("--quantity")) {
    label.quantity = whole_number_of("--quantity", arguments.flags.at("--quantity"), k_quantity);
  }
  if (arguments.has("--mirrored")) {
    label.mirrored = whole_number_of("--mirrored", arguments.flags.at("--mirrored"),
                                     {.min = 0.0, .max = k_quantity.max});
    if (const int pieces = std::max(1, label.quantity); label.mirrored > pieces) {
      throw UsageError("--mirrored is " + std::to_string(label.mirrored) + " but --quantity is " +
                       std::to_string(pieces) + ": no more pieces than there are can be mirrored");
    }
  }
  return label;
}

LineFit line_fit_from(const Arguments& arguments) {
  LineFit fit;
  if (arguments.has("--match-seams")) fit.length_tolerance = k_length_tolerance_of_seams;
  if (!arguments.has("--curve-tolerance")) return fit;
  fit.tolerance = millimetres_per(unit_from(arguments)) *
                  quantity_value("--curve-tolerance", arguments.flags.at("--curve-tolerance"),
                                 Quantity::length, {.min = 0.0, .max = 1e6}, arguments);
  return fit;
}

NotchSizes notch_sizes_from(const Arguments& arguments, const std::optional<Allowance>& allowance) {
  NotchSizes sizes;
  // As deep as leaves half of the allowance whole.
  if (allowance) sizes.depth = std::min(sizes.depth, 0.5 * allowance->width);
  if (arguments.has("--notch-depth")) sizes.depth = length_from(arguments, "--notch-depth");
  return sizes;
}

/// Whether the file of a flag is a drawing, which can be read only when there is a mesh.
bool is_drawn(const std::string& flag, const Arguments& arguments) {
  return arguments.has(flag) && lower_extension(arguments.flags.at(flag)) == ".obj";
}

/// The path of a flag's file; nothing without the flag, and where the file is a drawing.
std::optional<std::filesystem::path> list_of_flag(const std::string& flag,
                                                  const Arguments& arguments) {
  if (!arguments.has(flag) || is_drawn(flag, arguments)) return std::nullopt;
  return path_of(arguments.flags.at(flag));
}

void refuse_idle_flags(const Arguments& arguments, bool writes_sheet) {
  const auto check = [&](const std::string& flag, const std::string& other) {
    if (arguments.has(flag) && !arguments.has(other)) {
      throw UsageError("flag " + flag + " goes with " + other + " only");
    }
  };
  check("--corners", "--allowance");
  check("--edge-allowances", "--allowance");
  if (!arguments.has("--seam-notches")) check("--notch-depth", "--notches");
  if (writes_sheet) return;
  for (const Flag& flag : annotation_flags().flags) {
    if (!arguments.has(flag.name)) continue;
    throw UsageError("flag " + flag.name + " goes with svg, dxf, pdf and plt only");
  }
}

}  // namespace

FlagGroup annotation_flags() {
  return {
      "What the pattern gets besides its outline",
      {{"--allowance",
        "LENGTH",
        "material beyond the seam, as 10mm",
        0,
        false,
        {.range = {.min = 0.0}}},
       {"--corners",
        "KIND",
        "of the allowance: " + list_of(names_of(k_corners)) + " (default mitre)",
        0,
        false,
        {.choices = names_of(k_corners), .standard = std::string(to_string(k_corners.front()))}},
       {"--edge-allowances", "FILE",
        "other ones for stretches of the border, a line each: from vertex, to vertex, width in mm"},
       {"--fold", "V,W",
        "vertices at the ends of a straight stretch of the border: the piece is cut on the fold "
        "there, without an allowance"},
       {"--notches", "FILE",
        "a line each: vertex, or share of the border as 0.25 or 25%; slit, v or t; double; or an "
        ".obj "
        "drawn on the model"},
       {"--seam-notches", "FILE",
        "on both sides of seams, a line each: number of the seam or *; 50% or 120mm; kind; double"},
       {"--notch-depth",
        "LENGTH",
        "of notches (default 5mm, or half of less allowance)",
        0,
        false,
        {.range = {.min = 0.0}}},
       {"--grain", "X,Y,Z|ANGLE",
        "direction of the grain on the model, or its angle in the pattern"},
       {"--marks", "FILE", "a line each: vertex; cross or drill; or an .obj drawn on the model"},
       {"--inner-lines", "FILE",
        "as legs of darts, a line each by its vertices; or an .obj drawn on the model"},
       {"--piece-name", "TEXT", "written inside the piece, as are the next five"},
       {"--size", "TEXT", "that the piece is for"},
       {"--quantity", "N", "how many to cut", 0, false, {.range = k_quantity}},
       {"--mirrored",
        "N",
        "how many of --quantity to cut as mirror images",
        0,
        false,
        {.range = {.min = 0.0, .max = k_quantity.max}}},
       {"--fabric", "TEXT", "what to cut it from"},
       {"--note", "TEXT", "anything else, as \"one mirrored\" or \"cut on fold\""},
       {"--date", "TEXT", "written on the sheet as it is (default none)"},
       {"--edge-lengths", "",
        "write the lengths from corner to corner along the outline, and with flatten into "
        "edge-lengths.csv"},
       {"--curve-tolerance",
        "LENGTH",
        "how near curves of outlines stay to the border's vertices (default 0.1mm; 0: lines from "
        "vertex to vertex)",
        0,
        false,
        {.range = {.min = 0.0}}}}};
}

std::optional<std::array<Index, 2>> fold_ends_from(const Arguments& arguments) {
  const std::optional<FoldLine> fold = fold_from(arguments);
  if (!fold) return std::nullopt;
  return std::array<Index, 2>{fold->from, fold->to};
}

PatternOptions annotations_from(const Arguments& arguments, bool writes_sheet) {
  refuse_idle_flags(arguments, writes_sheet);
  PatternOptions options;
  options.allowance = allowance_from(arguments);
  options.notch_sizes = notch_sizes_from(arguments, options.allowance);
  options.fold = fold_from(arguments);
  options.grain = grain_from(arguments);
  options.label = label_from(arguments);
  options.date = arguments.value_or("--date", "");
  options.model_scale = scale_from(arguments);
  options.edge_lengths = arguments.has("--edge-lengths");
  options.curves = line_fit_from(arguments);
  if (const auto path = list_of_flag("--notches", arguments)) options.notches = read_notches(*path);
  if (const auto path = list_of_flag("--inner-lines", arguments)) {
    options.inner_lines = read_inner_lines(*path);
  }
  if (arguments.has("--edge-allowances")) {
    options.edge_allowances =
        read_edge_allowances(path_of(arguments.flags.at("--edge-allowances")));
  }
  if (const auto path = list_of_flag("--marks", arguments)) options.marks = read_marks(*path);
  return options;
}

PatternOptions with_drawn_annotations(PatternOptions options, const Arguments& arguments,
                                      const Patch& patch, Session& session) {
  const ShownLengths lengths(unit_from(arguments));
  const double scale = scale_from(arguments);
  const Patch in_file = as_in_file(patch, arguments);
  const auto add = [&](const std::string& flag, auto read) {
    if (!is_drawn(flag, arguments)) return;
    const std::string& file = arguments.flags.at(flag);
    const DrawnAnnotations drawn = read(path_of(file), in_file);
    options.notches.insert(options.notches.end(), drawn.notches.begin(), drawn.notches.end());
    options.marks.insert(options.marks.end(), drawn.marks.begin(), drawn.marks.end());
    options.drawn_lines.insert(options.drawn_lines.end(), drawn.lines.begin(), drawn.lines.end());
    if (drawn.farthest > 0.0) {
      session.note(file + ": what is drawn is at most " + lengths.text(scale * drawn.farthest) +
                   " from its places on the model");
    }
    if (drawn.outside_length > 0.0) {
      session.note(file + ": " + lengths.text(scale * drawn.outside_length) +
                   " of line lie off the model and are left out");
    }
  };
  add("--notches", read_drawn_notches);
  add("--marks", read_drawn_marks);
  add("--inner-lines", read_drawn_lines);
  return options;
}

}  // namespace planish::cli
