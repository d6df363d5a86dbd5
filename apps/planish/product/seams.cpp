#include "product/seams.h"

#include <algorithm>
#include <utility>

#include <planish/flatten/product.h>
#include <planish/pattern/notches.h>
#include <planish/pattern/read_annotations.h>

#include "flags/annotation_flags.h"
#include "flags/quantities.h"
#include "flags/scale_flag.h"
#include "flags/unfold_flags.h"
#include "flags/units.h"
#include "io/read_drawing.h"
#include "platform/path.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/text.h"
#include "shell/values.h"
#include "text/own_seams.h"

namespace planish::cli {

double seam_tolerance_from(const Arguments& arguments) {
  if (!arguments.has("--seam-tolerance")) return 0.0;
  return quantity_value("--seam-tolerance", arguments.value("--seam-tolerance"), Quantity::length,
                        {.min = 0.0}, arguments);
}

void match_own_seams(const Patch& patch, const Arguments& arguments, FlattenOptions& options,
                     const Context& context) {
  if (!matches_seams_of_product(arguments) || options.match_seams) return;
  SewnBorder border = find_own_seams(patch, options, context);
  if (!border.has_seams) return;
  options.match_seams = options.match_if_possible = true;
  options.free_edges = std::move(border.free_edges);
  options.seam_lengths = std::move(border.lengths);
}

ProductOptions product_options_from(const Arguments& arguments, FlattenOptions flatten,
                                    bool is_cut) {
  return {.flatten = std::move(flatten),
          .seam_tolerance = seam_tolerance_from(arguments),
          .match_seams = matches_seams_of_product(arguments),
          .common_lengths = is_cut};
}

namespace {

/// Every point of the drawing, model units.
std::vector<Vec3> drawn_places(const std::string& file, const Arguments& arguments) {
  const auto kept = arguments.files.find(file);
  const DrawnLines drawn = kept != arguments.files.end() ? parse_obj_lines(kept->second, file)
                                                         : read_obj_lines(path_of(file));
  std::vector<Vec3> places = drawn.points;
  for (const DrawnLine& line : drawn.lines)
    places.insert(places.end(), line.points.begin(), line.points.end());
  for (Vec3& place : places)
    place = scale_from(arguments) * place;
  return places;
}

}  // namespace

std::vector<SeamNotch> seam_notches_from(const Arguments& arguments,
                                         std::span<const TriMesh> meshes) {
  if (!arguments.has("--seam-notches")) return {};
  const std::string file = arguments.text("--seam-notches");
  if (arguments.rows.contains("--seam-notches") || lower_extension(file) != ".obj")
    return seam_notches_in(arguments.rows_of("--seam-notches"));
  return about(file, [&] {
    return seam_notches_at(drawn_places(file, arguments),
                           find_sound_seams(meshes, seam_tolerance_from(arguments)), meshes);
  });
}

std::vector<std::vector<Notch>> notches_on_seams(const Arguments& arguments,
                                                 std::span<const TriMesh> meshes,
                                                 std::span<const std::string> names) {
  if (!arguments.has("--seam-notches")) return std::vector<std::vector<Notch>>(meshes.size());
  const std::vector<SeamNotch> notches = seam_notches_from(arguments, meshes);
  return about(arguments.text("--seam-notches"), [&] {
    return notches_of_patches(notches, find_sound_seams(meshes, seam_tolerance_from(arguments)),
                              meshes, names, millimetres_per(unit_from(arguments)));
  });
}

namespace {

/// The vertex of a side that is nearest to a length along it.
Index vertex_at(const SeamSide& side, std::span<const Vec3> positions, double length) {
  double way = 0.0;
  std::size_t k = 0;
  while (k + 1 < side.vertices.size()) {
    const double edge = norm(positions[side.vertices[k + 1]] - positions[side.vertices[k]]);
    if (way + 0.5 * edge >= length) break;
    way += edge;
    ++k;
  }
  return side.vertices[k];
}

/// What is written beside a side of a seam: in its middle, and near its ends where there is room.
void add_numbers_of_side(const SeamSide& side, const SeamNumber& seam,
                         std::span<const Vec3> positions, double millimetre,
                         std::vector<SeamNumber>& numbers) {
  constexpr double k_least = 15.0, k_least_with_ends = 80.0, k_inset = 10.0;  // millimetres
  constexpr double k_inset_share = 0.04;                                      // of the length
  constexpr std::size_t k_fewest = 6;  // vertices of a side with ends
  const double length = length_of(side, positions);
  if (length < k_least * millimetre) return;
  const auto add = [&](char end, Index vertex) {
    numbers.push_back({seam.number, vertex, seam.partner, end});
  };
  add(0, vertex_at(side, positions, 0.5 * length));
  const bool is_closed = side.vertices.front() == side.vertices.back();
  if (is_closed || length < k_least_with_ends * millimetre || side.vertices.size() < k_fewest)
    return;
  // The first and the last vertex are corners of the piece, where words would leave it.
  const double inset = std::max(k_inset * millimetre, k_inset_share * length);
  const SeamSide inner{side.patch, {side.vertices.begin() + 1, side.vertices.end() - 1}};
  const double first = norm(positions[side.vertices[1]] - positions[side.vertices[0]]);
  add('a', vertex_at(inner, positions, std::max(0.0, inset - first)));
  add('b', vertex_at(inner, positions, length - inset - first));
}

}  // namespace

std::vector<std::vector<SeamNumber>> numbers_of_seams(const Arguments& arguments,
                                                      std::span<const Seam> seams,
                                                      std::span<const TriMesh> meshes,
                                                      std::span<const std::string> names) {
  const double millimetre = 1.0 / millimetres_per(unit_from(arguments));
  std::vector<std::vector<SeamNumber>> numbers(meshes.size());
  int number = 0;
  for (const Seam& seam : seams) {
    SeamNumber written{.number = ++number};
    for (std::size_t s = 0; s < 2; ++s) {
      const std::size_t patch = seam.sides[s].patch, other = seam.sides[1 - s].patch;
      written.partner = other == patch ? std::string() : names[other];
      add_numbers_of_side(seam.sides[s], written, meshes[patch].positions, millimetre,
                          numbers[patch]);
    }
  }
  return numbers;
}

std::vector<MeasuredSeam> with_names(std::vector<MeasuredSeam> seams,
                                     const std::vector<PatchResult>& patches,
                                     const std::vector<NamedSeam>& names, Session& session) {
  for (const NamedSeam& named : names) {
    const auto is_between = [&](const MeasuredSeam& seam) {
      const std::string& one = patches[seam.seam.sides[0].patch].name;
      const std::string& other = patches[seam.seam.sides[1].patch].name;
      return (one == named.between[0] && other == named.between[1]) ||
             (one == named.between[1] && other == named.between[0]);
    };
    const auto found = std::find_if(seams.begin(), seams.end(), [&](const MeasuredSeam& seam) {
      return seam.name.empty() && is_between(seam);
    });
    if (found != seams.end())
      found->name = named.name;
    else
      session.note("seam \"" + named.name + "\": " + named.between[0] + " and " + named.between[1] +
                   " share no border that is still without a name");
  }
  return seams;
}

PatternOptions annotations_on(PatternOptions annotations, const Arguments& arguments,
                              const Patch& patch, const std::string& name, Session& session) {
  annotations = with_drawn_annotations(std::move(annotations), arguments, patch, session);
  if (meets_itself(patch)) {
    const std::span<const TriMesh> alone(&patch.mesh(), 1);
    annotations.seam_numbers =
        numbers_of_seams(arguments, find_sound_seams(alone, seam_tolerance_from(arguments)), alone,
                         {&name, 1})
            .front();
  }
  const bool seams = arguments.has("--seam-notches");
  if (named_vertices(annotations).empty() && annotations.notches.empty() && !seams)
    return annotations;
  check_pattern_options(annotations, patch.vertex_count(), patch.border_loops(), name);
  const std::vector<std::vector<Notch>> on_seams =
      notches_on_seams(arguments, {&patch.mesh(), 1}, {&name, 1});
  annotations.notches.insert(annotations.notches.end(), on_seams.front().begin(),
                             on_seams.front().end());
  return annotations;
}

namespace {

std::string notches_are(std::size_t count) {
  return count == 1 ? "1 notch is" : std::to_string(count) + " notches are";
}

}  // namespace

void note_notches(Session& session, std::span<const PatternGeometry> patterns) {
  std::size_t on_seam = 0, shorter = 0;
  double depth = 0.0;
  for (const PatternGeometry& pattern : patterns) {
    depth = pattern.options.notch_sizes.depth;
    for (const PlacedNotch& notch : pattern.notches) {
      if (notch.on_seam)
        ++on_seam;
      else if (notch.depth < depth - 1e-6)
        ++shorter;
    }
  }
  if (on_seam > 0) {
    session.note(notches_are(on_seam) +
                 " drawn on the seam line: no cut line runs beside the place, as the allowance "
                 "fills the dart, slit or inner corner there; for notches in a cut line take less "
                 "--allowance");
  }
  if (shorter > 0) {
    session.note(
        notches_are(shorter) + " drawn shorter than " + fixed(depth, 1) +
        " mm, as the allowance there is narrower; beside an edge without an allowance they "
        "go into the piece: to leave these out, take them out of the file of notches");
  }
}

void note_filled(Session& session, const PatternGeometry& pattern) {
  const std::vector<FilledStretch>& filled = pattern.filled;
  if (filled.empty()) return;
  std::vector<std::string> places;
  places.reserve(filled.size());
  double length = 0.0;
  for (const FilledStretch& stretch : filled) {
    length += stretch.length;
    places.push_back("near vertex " + std::to_string(stretch.vertex) + " (" +
                     fixed(stretch.length, 0) + " mm)");
  }
  session.note(pattern.name + ": the allowance fills slits, darts or bays: " + fixed(length, 0) +
               " mm of seam line have no cut line beside them, " + list_of_some(places) +
               "; to cut along them take less --allowance, or less there "
               "with --edge-allowances");
}

void note_left_out(Session& session, const PatternGeometry& pattern) {
  for (const std::string& what : pattern.left_out)
    session.note(what);
}

void note_pattern(Session& session, const PatternGeometry& pattern) {
  note_notches(session, {&pattern, 1});
  note_filled(session, pattern);
  note_left_out(session, pattern);
}

}  // namespace planish::cli
