#include "io/svg/svg_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/math.h"
#include "io/svg/markup_reader.h"
#include "io/svg/svg_chords.h"
#include "io/svg/svg_values.h"

namespace planish {

namespace {

constexpr std::size_t k_most_drawing_points = 20'000'000;

constexpr std::array<std::string_view, 7> k_shapes = {"path", "line",   "polyline", "polygon",
                                                      "rect", "circle", "ellipse"};
constexpr std::array<std::string_view, 3> k_groups = {"g", "a", "switch"};
constexpr std::array<std::string_view, 5> k_not_taken = {"text", "image", "use", "svg",
                                                         "foreignObject"};

template <class Names>
bool is_one_of(std::string_view name, const Names& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string_view local_name(std::string_view name) {
  return name.starts_with("svg:") ? name.substr(4) : name;
}

/// What holds for an element and those in it.
struct State {
  Affine to_mm;
  bool is_rendered = true;  ///< neither within definitions nor within what is unknown
  bool is_displayed = true, is_visible = true;
  bool has_fill = true, has_stroke = false;
  std::string layer;

  bool is_shown() const { return is_rendered && is_displayed && is_visible; }
};

class SvgReader {
 public:
  SvgReader(std::string_view bytes, std::string_view name, std::span<const std::string_view> layers)
      : markup_(bytes, name), layers_(layers) {}

  SvgDrawing read() {
    for (MarkupTag tag = markup_.next(); tag.kind != MarkupTag::Kind::none; tag = markup_.next()) {
      if (tag.kind == MarkupTag::Kind::end) {
        states_.pop_back();
      } else {
        start(tag);
      }
    }
    if (!has_root_) markup_.fail(ErrorCode::malformed_file, "the file has no element <svg>", 1);
    return std::move(drawing_);
  }

 private:
  [[noreturn]] void fail(const MarkupTag& tag, const std::string& message,
                         ErrorCode code = ErrorCode::malformed_file) const {
    markup_.fail(code, "<" + printable(tag.name) + ">: " + message, tag.line);
  }

  void start(const MarkupTag& tag) {
    const std::string_view name = local_name(tag.name);
    if (states_.empty()) {
      if (has_root_ || name != "svg") {
        fail(tag, "an SVG file has one outermost element, <svg>");
      }
      has_root_ = true;
      states_.push_back(styled(root_state(tag), tag));
      return;
    }
    State state = states_.back();
    if (state.is_rendered) {
      state = styled(std::move(state), tag);
      if (is_one_of(name, k_shapes)) {
        add_shape(name, tag, state);
      } else if (is_one_of(name, k_not_taken) && state.is_shown() && state.layer.empty()) {
        ++drawing_.left_out[std::string(name)];
      }
      if (name == "g") enter_layer(tag.attribute("id"), state);
      state.is_rendered = is_one_of(name, k_groups);
    }
    states_.push_back(std::move(state));
  }

  void enter_layer(const std::string& id, State& state) const {
    if (state.layer.empty() && is_one_of(std::string_view(id), layers_)) state.layer = id;
  }

  /// Millimetres per user unit: the size of the sheet over the view box. Where the view box lies
  /// within another form of sheet does not matter: places are relative to a layer.
  State root_state(const MarkupTag& tag) {
    State state;
    Affine& to_mm = state.to_mm;
    to_mm = {1.0 / k_user_units_per_mm, 0.0, 0.0, -1.0 / k_user_units_per_mm, 0.0, 0.0};
    const std::string box_text = tag.attribute("viewBox");
    if (box_text.empty()) {
      whole_ = {sheet_length(tag, "width").value_or(0.0),
                sheet_length(tag, "height").value_or(0.0)};
      return state;
    }
    const auto box = svg_numbers(box_text);
    if (!box || box->size() != 4 || !((*box)[2] > 0.0) || !((*box)[3] > 0.0)) {
      fail(tag,
           "viewBox is " + in_quotes(box_text) + " but must be four numbers, the last two above 0");
    }
    whole_ = {(*box)[2], (*box)[3]};
    const auto width = sheet_length(tag, "width"), height = sheet_length(tag, "height");
    Vec2 zoom = {width.value_or(height.value_or(whole_.y) / whole_.y * whole_.x) / whole_.x,
                 height.value_or(width.value_or(whole_.x) / whole_.x * whole_.y) / whole_.y};
    if (tag.attribute("preserveAspectRatio").find("none") == std::string::npos) {
      zoom.x = zoom.y = std::min(zoom.x, zoom.y);
    }
    to_mm = to_mm.after({zoom.x, 0.0, 0.0, zoom.y, -zoom.x * (*box)[0], -zoom.y * (*box)[1]});
    return state;
  }

  /// Nothing where the sheet is as large as the window.
  std::optional<double> sheet_length(const MarkupTag& tag, std::string_view name) const {
    const std::string text = tag.attribute(name);
    if (text.empty() || text == "auto" || text.ends_with('%')) return std::nullopt;
    const auto length = svg_length(text, 0.0);
    if (length && *length > 0.0) return length;
    fail(tag,
         std::string(name) + " is " + in_quotes(text) + " but must be a length above 0, as 210mm");
  }

  State styled(State state, const MarkupTag& tag) const {
    const std::string style = tag.attribute("style");
    const auto value = [&](std::string_view property) {
      const std::string_view styled = style_value(style, property);
      return styled.empty() ? tag.attribute(property) : std::string(styled);
    };
    if (value("display") == "none") state.is_displayed = false;
    const std::string visibility = value("visibility");
    if (visibility == "visible") state.is_visible = true;
    if (visibility == "hidden" || visibility == "collapse") state.is_visible = false;
    if (const std::string fill = value("fill"); !fill.empty() && fill != "inherit")
      state.has_fill = fill != "none";
    if (const std::string stroke = value("stroke"); !stroke.empty() && stroke != "inherit")
      state.has_stroke = stroke != "none";
    const std::string text = value("transform");
    const auto transform = svg_transform(text);
    if (!transform)
      fail(tag, "transform is " + in_quotes(text) + ", which is no list of transforms");
    state.to_mm = state.to_mm.after(*transform);
    return state;
  }

  /// A length that says where an element is or how large; 0 where it has none.
  double length(const MarkupTag& tag, std::string_view name, double whole) const {
    return optional_length(tag, name, whole).value_or(0.0);
  }

  std::optional<double> optional_length(const MarkupTag& tag, std::string_view name,
                                        double whole) const {
    const std::string text = tag.attribute(name);
    if (text.empty() || text == "auto") return std::nullopt;
    const auto length = svg_length(text, whole);
    if (!length) fail(tag, std::string(name) + " is " + in_quotes(text) + ", which is no length");
    return length;
  }

  double size(const MarkupTag& tag, std::string_view name, double whole) const {
    const double value = length(tag, name, whole);
    if (value < 0.0) fail(tag, std::string(name) + " is below 0");
    return value;
  }

  Vec2 place(const MarkupTag& tag, std::string_view x, std::string_view y) const {
    return {length(tag, x, whole_.x), length(tag, y, whole_.y)};
  }

  void add_path_of(const MarkupTag& tag, SvgChords& chords) const {
    const std::string fault = add_path(tag.attribute("d"), chords);
    if (!fault.empty()) fail(tag, fault);
  }

  void add_points_of(const MarkupTag& tag, bool closed, SvgChords& chords) const {
    const auto values = svg_numbers(tag.attribute("points"));
    if (!values || values->size() % 2 != 0) fail(tag, "points is no list of pairs of numbers");
    for (std::size_t i = 0; i < values->size(); i += 2) {
      const Vec2 p = {(*values)[i], (*values)[i + 1]};
      if (i == 0) {
        chords.move_to(p);
      } else {
        chords.line_to(p);
      }
    }
    if (closed) chords.close();
  }

  void add_rectangle_of(const MarkupTag& tag, SvgChords& chords) const {
    const Vec2 extent = {size(tag, "width", whole_.x), size(tag, "height", whole_.y)};
    const auto rx = optional_length(tag, "rx", whole_.x), ry = optional_length(tag, "ry", whole_.y);
    // One stands for both where the other is missing.
    const Vec2 round = {std::clamp(rx ? *rx : ry.value_or(0.0), 0.0, 0.5 * extent.x),
                        std::clamp(ry ? *ry : rx.value_or(0.0), 0.0, 0.5 * extent.y)};
    if (extent.x > 0.0 && extent.y > 0.0) {
      add_rectangle(place(tag, "x", "y"), extent, round, chords);
    }
  }

  void add_ellipse_of(const MarkupTag& tag, Vec2 radii, SvgChords& chords) const {
    if (radii.x > 0.0 && radii.y > 0.0) add_ellipse(place(tag, "cx", "cy"), radii, chords);
  }

  void add_chords(std::string_view name, const MarkupTag& tag, SvgChords& chords) const {
    if (name == "path") return add_path_of(tag, chords);
    if (name == "polyline" || name == "polygon") {
      return add_points_of(tag, name == "polygon", chords);
    }
    if (name == "rect") return add_rectangle_of(tag, chords);
    if (name == "circle") {
      const double r = size(tag, "r", math::hypot(whole_.x, whole_.y) / std::sqrt(2.0));
      return add_ellipse_of(tag, {r, r}, chords);
    }
    if (name == "ellipse") {
      return add_ellipse_of(tag, {size(tag, "rx", whole_.x), size(tag, "ry", whole_.y)}, chords);
    }
    chords.move_to(place(tag, "x1", "y1"));
    chords.line_to(place(tag, "x2", "y2"));
  }

  void add_shape(std::string_view name, const MarkupTag& tag, const State& state) {
    const bool is_seen = state.is_shown() && (state.has_fill || state.has_stroke);
    if (!is_seen && state.layer.empty()) return;
    SvgChords chords(state.to_mm);
    add_chords(name, tag, chords);
    if (chords.failed()) {
      fail(tag, "it is too large: a curve of more than 100,000 chords, or a place out of reach",
           ErrorCode::too_large);
    }
    for (const std::vector<Vec2>& line : chords.lines()) {
      points_ += line.size();
      drawing_.lines.push_back({line, tag.line, state.layer});
    }
    if (points_ > k_most_drawing_points) {
      fail(tag, "the shapes up to this one have more than 20 million points", ErrorCode::too_large);
    }
  }

  MarkupReader markup_;
  std::span<const std::string_view> layers_;
  std::vector<State> states_;
  Vec2 whole_;
  bool has_root_ = false;
  std::size_t points_ = 0;
  SvgDrawing drawing_;
};

}  // namespace

SvgDrawing parse_svg(std::string_view bytes, std::string_view name,
                     std::span<const std::string_view> layers) {
  return SvgReader(bytes, name, layers).read();
}

}  // namespace planish
