#include "flags/annotation_flags.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include <planish/pattern/read_annotations.h>

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
         quantity_value(flag, arguments.value(flag), Quantity::length, positive, arguments);
}

std::optional<Allowance> allowance_from(const Arguments& arguments) {
  if (!arguments.has("--allowance")) return std::nullopt;
  Allowance allowance{.width = length_from(arguments, "--allowance")};
  if (arguments.has("--corners")) {
    allowance.corners = value_named("kind of corners", arguments.text("--corners"), k_corners);
  }
  allowance.holes = arguments.text("--hole-allowance", "yes") == "yes";
  return allowance;
}

/// An angle, or a direction of three numbers.
std::optional<Grain> grain_from(const Arguments& arguments) {
  if (!arguments.has("--grain")) return std::nullopt;
  const std::vector<Field> parts = arguments.fields("--grain");
  if (parts.size() == 1)
    return quantity_value("--grain", parts.front(), Quantity::angle, {-360.0, 360.0}, arguments);
  std::vector<double> numbers;
  numbers.reserve(parts.size());
  for (const Field& part : parts)
    numbers.push_back(field_number(part).value_or(std::numeric_limits<double>::quiet_NaN()));
  numbers.resize(std::max<std::size_t>(numbers.size(), 3));
  const Vec3 direction = {numbers[0], numbers[1], numbers[2]};
  if (parts.size() != 3 || !(norm(direction) > 0.0)) {
    throw UsageError("--grain is \"" + arguments.text("--grain") +
                     "\" but must be a direction such as 0,0,1 or an angle such as 30deg");
  }
  return direction;
}

/// Two numbers of vertices.
std::optional<FoldLine> fold_from(const Arguments& arguments) {
  if (!arguments.has("--fold")) return std::nullopt;
  const std::vector<Field> ends = arguments.fields("--fold");
  if (ends.size() != 2) {
    throw UsageError("--fold is \"" + arguments.text("--fold") +
                     "\" but must be two vertices, as 12,57");
  }
  constexpr Range range = {.min = 0.0, .max = std::numeric_limits<std::int32_t>::max()};
  const auto vertex = [&](const Field& end) {
    return static_cast<Index>(whole_number_of("--fold", end, range));
  };
  return FoldLine{vertex(ends[0]), vertex(ends[1])};
}

PieceLabel label_from(const Arguments& arguments) {
  PieceLabel label{.name = arguments.text("--piece-name"),
                   .size = arguments.text("--size"),
                   .fabric = arguments.text("--fabric"),
                   .note = arguments.text("--note")};
  if (arguments.has("--quantity")) {
    label.quantity = whole_number_of("--quantity", arguments.value("--quantity"), k_quantity);
  }
  if (arguments.has("--mirrored")) {
    label.mirrored = whole_number_of("--mirrored", arguments.value("--mirrored"),
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
                  quantity_value("--curve-tolerance", arguments.value("--curve-tolerance"),
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
  return arguments.has(flag) && lower_extension(arguments.text(flag)) == ".obj";
}

/// What the rows of a flag say; nothing without the flag, and where its file is a drawing.
template <class Item>
void take_rows(const std::string& flag, const Arguments& arguments,
               std::vector<Item> (*items_in)(const Rows&), std::vector<Item>& items) {
  if (arguments.has(flag) && !is_drawn(flag, arguments)) items = items_in(arguments.rows_of(flag));
}

void refuse_idle_flags(const Arguments& arguments, bool writes_sheet) {
  const auto check = [&](const std::string& flag, const std::string& other) {
    if (arguments.has(flag) && !arguments.has(other)) {
      throw UsageError("flag " + flag + " goes with " + other + " only");
    }
  };
  check("--corners", "--allowance");
  check("--hole-allowance", "--allowance");
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
      "What the pattern has besides its outline",
      {{"--allowance",
        "LENGTH",
        "width of the seam allowance, as 10mm",
        0,
        false,
        {.range = {.min = 0.0}}},
       {"--corners",
        "KIND",
        "corners of the allowance: " + list_of(names_of(k_corners)) + " (default mitre)",
        0,
        false,
        {.choices = names_of(k_corners), .standard = std::string(to_string(k_corners.front()))}},
       {"--hole-allowance",
        "ANSWER",
        "give holes the allowance too, inwards: yes or no (default yes)",
        0,
        false,
        {.choices = {"yes", "no"}, .standard = "yes"}},
       {"--kerf",
        "LENGTH",
        "width that the machine cuts away, as 0.2mm; cut lines move by half of it, outwards, and "
        "into holes (default 0)",
        0,
        false,
        {.range = {.min = 0.0}, .standard = "0"}},
       {"--edge-allowances", "FILE",
        "allowances of single stretches of the border, one a line: first vertex, last vertex, "
        "width in mm"},
       {"--fold", "V,W",
        "the two vertices at the ends of a straight stretch of the border; the piece is cut on the "
        "fold there, without an allowance"},
       {"--open-folds", "", "draw the whole piece on both sides of its fold, not its half"},
       {"--notches", "FILE",
        "notches, one a line: vertex, or place along the border as 0.25 or 25%; slit, v or t; "
        "double; or an .obj drawn on the model"},
       {"--seam-notches", "FILE",
        "notches on both sides of seams, one a line: number of the seam, or * for all; place as "
        "50% or 120mm; slit, v or t; double; or an .obj drawn on the model"},
       {"--notch-depth",
        "LENGTH",
        "depth of notches (default 5mm, or half the allowance if that is less)",
        0,
        false,
        {.range = {.min = 0.0}}},
       {"--grain", "X,Y,Z|ANGLE", "grain: a direction on the model, or an angle in the pattern"},
       {"--marks", "FILE",
        "marks, one a line: vertex; cross or drill; or an .obj drawn on the model"},
       {"--inner-lines", "FILE",
        "lines inside the piece, such as legs of darts: the vertices of each on one line; or an "
        ".obj drawn on the model"},
       {"--piece-name", "TEXT",
        "name of the piece, written inside it, as are the values of the next five flags"},
       {"--size", "TEXT", "size that the piece is for"},
       {"--quantity", "N", "number of pieces to cut", 0, false, {.range = k_quantity}},
       {"--mirrored",
        "N",
        "number of pieces of --quantity to cut as mirror images",
        0,
        false,
        {.range = {.min = 0.0, .max = k_quantity.max}}},
       {"--fabric", "TEXT", "material to cut the piece from"},
       {"--note", "TEXT", "any other text, as \"one mirrored\" or \"cut on fold\""},
       {"--date", "TEXT", "date to write on the sheet, printed as you give it (default none)"},
       {"--edge-lengths", "",
        "write the length of each edge, from corner to corner, beside it; flatten also writes "
        "edge-lengths.csv"},
       {"--sheet-unit",
        "UNIT",
        "unit of the lengths on sheets, of the .dxf and of edge-lengths.csv: mm or in (default mm)",
        0,
        false,
        {.choices = {"mm", "in"}, .standard = "mm"}},
       {"--curve-tolerance",
        "LENGTH",
        "largest distance between the drawn curves and the border of the mesh (default 0.1mm; 0: "
        "straight lines from vertex to vertex)",
        0,
        false,
        {.range = {.min = 0.0}}}}};
}

Unit sheet_unit_from(const Arguments& arguments) {
  const std::vector<std::string> units = {"mm", "in"};
  return unit_named(known_name("unit of sheets", arguments.text("--sheet-unit", "mm"), units));
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
  if (arguments.has("--kerf"))
    options.kerf = millimetres_per(unit_from(arguments)) *
                   quantity_value("--kerf", arguments.value("--kerf"), Quantity::length,
                                  {.min = 0.0, .max = 1e6}, arguments);
  options.notch_sizes = notch_sizes_from(arguments, options.allowance);
  options.fold = fold_from(arguments);
  options.open_fold = arguments.has("--open-folds");
  options.grain = grain_from(arguments);
  options.label = label_from(arguments);
  options.date = arguments.text("--date");
  options.model_scale = scale_from(arguments);
  options.edge_lengths = arguments.has("--edge-lengths");
  options.curves = line_fit_from(arguments);
  options.sheet_unit = sheet_unit_from(arguments);
  take_rows("--notches", arguments, notches_in, options.notches);
  take_rows("--inner-lines", arguments, inner_lines_in, options.inner_lines);
  take_rows("--edge-allowances", arguments, edge_allowances_in, options.edge_allowances);
  take_rows("--marks", arguments, marks_in, options.marks);
  return options;
}

PatternOptions with_drawn_annotations(PatternOptions options, const Arguments& arguments,
                                      const Patch& patch, Session& session) {
  const ShownLengths lengths(unit_from(arguments));
  const double scale = scale_from(arguments);
  const Patch in_file = as_in_file(patch, arguments);
  const auto add = [&](const std::string& flag, auto read) {
    if (!is_drawn(flag, arguments)) return;
    const std::string file = arguments.text(flag);
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
