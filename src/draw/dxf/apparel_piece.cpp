#include "draw/dxf/apparel_piece.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "core/math.h"
#include "draw/dxf/dxf_places.h"
#include "draw/dxf/dxf_profile.h"

namespace planish {

namespace {

// Layers by number, as in both standards; from 80 on in ASTM D6673 only.
constexpr std::string_view k_turn_point = "2", k_curve_point = "3", k_grade_reference = "5",
                           k_fold = "6", k_inner = "8", k_cutout = "11", k_t_notch = "80";

/// From this turn on a vertex is a turn point. Of points that apparel programs call curve points,
/// 95 % turn by less than 19 degrees.
constexpr double k_least_turn = 22.5 * std::numbers::pi / 180.0;

/// Where the vertices of an outline in full number go.
std::string_view dense_layer(std::string_view number) {
  if (number == "1") return "84";
  if (number == "8") return "85";
  if (number == k_cutout) return "86";
  return number == "14" ? "87" : std::string_view();
}

/// The layer of each line of a path. Of closed lines on the cut layer all are holes, but for the
/// boundary, which is the one that encloses most.
std::vector<std::string> layers_of(const std::vector<std::vector<Vec2>>& lines, bool are_cut,
                                   bool has_boundary, const std::string& number) {
  std::vector<std::string> layers(lines.size(), are_cut ? std::string(k_cutout) : number);
  if (are_cut && has_boundary && !lines.empty()) layers[largest_of(lines)] = number;
  return layers;
}

bool is_turn(Vec2 before, Vec2 at, Vec2 after) {
  const Vec2 in = at - before, out = after - at;
  return std::abs(math::atan2(cross(in, out), dot(in, out))) >= k_least_turn;
}

}  // namespace

ApparelPiece::ApparelPiece(const DxfOptions& options)
    : options_(options), is_astm_(dialect_of(options.profile).family == DxfFamily::astm) {}

void ApparelPiece::add(const Layer& layer, const Path& path) {
  const auto number = dxf_layer_name(layer.name, options_);
  if (!number || !path.stroke || std::holds_alternative<SignMark>(path.mark)) return;
  if (options_.notch_strokes && !std::holds_alternative<GrainMark>(path.mark)) {
    // As strokes below.
  } else if (const auto* notch = std::get_if<NotchMark>(&path.mark)) {
    return add_notch(*number, *notch);
  } else if (const auto* drill = std::get_if<DrillMark>(&path.mark)) {
    return tags_.add_point_entity(*number, drill->at);
  }
  if (const auto* grain = std::get_if<GrainMark>(&path.mark)) {
    add_straight(*number, grain->from, grain->to);
    // What pieces of other sizes are turned by.
    add_straight(std::string(k_grade_reference), grain->from, grain->to);
  } else if (const auto* fold = std::get_if<FoldMark>(&path.mark)) {
    // Programs mirror a piece along its fold: not one that is whole.
    add_straight(std::string(fold->opened ? k_inner : k_fold), fold->from, fold->to);
  } else {
    add_outline(layer, path, *number);
  }
}

void ApparelPiece::add(const Layer& layer, const Text& text) {
  if (!options_.layer_names.contains(layer.name)) return;
  if (!std::isfinite(text.at.x) || !std::isfinite(text.at.y)) return;
  tags_.add_text(*dxf_layer_name(layer.name, options_), text.at, text.height, text.text);
  box_.add(text.at);
}

void ApparelPiece::add_outline(const Layer& layer, const Path& path, const std::string& number) {
  // The boundary of a piece is closed also along a fold, where nothing is cut.
  const bool are_cut = layer.name == "cut", closed = path.closed || are_cut;
  const bool has_boundary = are_cut && !has_boundary_;
  has_boundary_ = has_boundary_ || are_cut;
  const std::vector<std::vector<Vec2>> lines =
      dxf_places(path.fitted.few.empty() ? path.lines : path.fitted.few, closed);
  const std::vector<std::string> layers = layers_of(lines, are_cut, has_boundary, number);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    add_line(layers[i], lines[i], closed);
    add_corner_points(lines[i], closed);
  }
  if (!is_astm_) return;
  const std::vector<std::vector<Vec2>> dense = dxf_places(path.lines, closed);
  const std::vector<std::string> all = layers_of(dense, are_cut, has_boundary, number);
  for (std::size_t i = 0; i < dense.size(); ++i) {
    const std::string_view other = dense_layer(all[i]);
    if (!other.empty()) add_line(std::string(other), dense[i], closed);
  }
}

void ApparelPiece::add_line(const std::string& layer, const std::vector<Vec2>& places,
                            bool closed) {
  tags_.add_polyline(layer, places, closed, {});
  for (const Vec2 place : places)
    box_.add(place);
}

void ApparelPiece::add_corner_points(const std::vector<Vec2>& places, bool closed) {
  const std::size_t n = places.size();
  for (std::size_t i = 0; i < n; ++i) {
    const bool is_end = !closed && (i == 0 || i + 1 == n);
    const bool turns = is_end || is_turn(places[(i + n - 1) % n], places[i], places[(i + 1) % n]);
    tags_.add_point_entity(std::string(turns ? k_turn_point : k_curve_point), places[i]);
  }
}

void ApparelPiece::add_notch(const std::string& number, const NotchMark& notch) {
  const bool is_t = notch.kind == NotchKind::t && is_astm_;
  tags_.add_point_entity(is_t ? std::string(k_t_notch) : number, notch.at, notch.depth);
  tags_.add_real(39, notch.width);
  tags_.add_real(50, notch.angle < 0.0 ? notch.angle + 360.0 : notch.angle);
}

void ApparelPiece::add_straight(const std::string& layer, Vec2 from, Vec2 to) {
  tags_.add(0, "LINE");
  tags_.add(8, layer);
  tags_.add_point(10, from);
  tags_.add_point(11, to);
  box_.add(from);
  box_.add(to);
}

}  // namespace planish
