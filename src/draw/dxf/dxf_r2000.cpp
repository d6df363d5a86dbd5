#include "draw/dxf/dxf_r2000.h"

#include <cmath>
#include <utility>
#include <vector>

#include "core/math.h"
#include "core/number_text.h"
#include "draw/cutting_order.h"
#include "draw/dxf/dxf_layers.h"
#include "draw/dxf/dxf_places.h"
#include "draw/dxf/dxf_profile.h"
#include "draw/dxf/dxf_tags.h"
#include "draw/dxf/r2000_frame.h"
#include "draw/text/stroke_text.h"
#include "pattern/curves/piece_math.h"

namespace planish {

namespace {

constexpr std::string_view k_version = "AC1015";

/// A corner of a LWPOLYLINE and the bulge of what follows: the tangent of a quarter of its angle,
/// > 0 where it turns left.
struct BulgedPoint {
  Vec2 at;
  double bulge = 0.0;
};

/// Lines and arcs, or cubics, that follow each other.
struct Run {
  Vec2 start;
  bool is_spline = false;
  std::vector<CurvePiece> pieces;
};

std::vector<Run> runs_of(const Curve& curve) {
  std::vector<Run> runs;
  Vec2 from = curve.start;
  const CurvePiece* before = nullptr;
  Vec2 start_of_before;
  for (const CurvePiece& piece : curve.pieces) {
    const bool is_spline = std::holds_alternative<CubicTo>(piece);
    bool goes_on = !runs.empty() && runs.back().is_spline == is_spline;
    if (goes_on && is_spline) {
      // Splines end at corners.
      const Vec2 in = place_on(start_of_before, *before, 1.0).speed;
      const Vec2 out = place_on(from, piece, 0.0).speed;
      goes_on = dot(in, out) > 0.9999 * norm(in) * norm(out);
    }
    if (!goes_on) runs.push_back({from, is_spline, {}});
    runs.back().pieces.push_back(piece);
    before = &piece;
    start_of_before = from;
    from = end_of(piece);
  }
  return runs;
}

class R2000File {
 public:
  R2000File(const Drawing& drawing, const DxfOptions& options) : drawing_(drawing) {
    for (const Layer& layer : in_cutting_order(drawing)) {
      const std::string name = *dxf_layer_name(layer.name, options);
      for (const DrawingShape& shape : layer.shapes) {
        std::visit([&](const auto& some) { add(some, name, layer.visible); }, shape);
      }
    }
  }

  std::string text() {
    DxfTags tables = frame_.tables_and_blocks(layers_.with_layer_0());
    DxfTags objects = frame_.objects_section();
    DxfTags tags = header();  // last, as it names the next free handle
    tags.append(tables);
    tags.begin_section("ENTITIES");
    tags.append(entities_);
    tags.end_section();
    tags.append(objects);
    tags.add(0, "EOF");
    return tags.text();
  }

 private:
  void begin_entity(std::string_view kind, const std::string& layer, Color color, bool dashed,
                    bool visible) {
    entities_.add(0, kind);
    entities_.add(5, frame_.next_handle());
    entities_.add(330, frame_.model_space());
    entities_.add(100, "AcDbEntity");
    entities_.add(8, layer);
    entities_.append(layers_.looks_on(layer, color, dashed, visible));
  }

  void add(const Path& path, const std::string& layer, bool visible) {
    if (!path.stroke) return;
    const auto begin = [&](std::string_view kind) {
      begin_entity(kind, layer, path.stroke->color, path.stroke->dashed, visible);
    };
    for (const Curve& curve : path.fitted.curves) {
      const std::vector<Run> runs = runs_of(curve);
      for (const Run& run : runs) {
        begin(run.is_spline ? "SPLINE" : "LWPOLYLINE");
        if (run.is_spline)
          add_spline(run, path.closed && runs.size() == 1);
        else
          add_polyline(bulged_points(run), path.closed && runs.size() == 1);
      }
    }
    if (!path.fitted.curves.empty()) return;
    for (const std::vector<Vec2>& line : dxf_places(path.lines, path.closed)) {
      std::vector<BulgedPoint> points;
      points.reserve(line.size());
      for (const Vec2 place : line)
        points.push_back({place});
      begin("LWPOLYLINE");
      add_polyline(points, path.closed);
    }
  }

  static std::vector<BulgedPoint> bulged_points(const Run& run) {
    std::vector<BulgedPoint> points = {{run.start}};
    for (const CurvePiece& piece : run.pieces) {
      const Vec2 from = points.back().at;
      if (const auto* arc = std::get_if<ArcTo>(&piece))
        points.back().bulge = math::tan(0.25 * circle_of(from, *arc).angle);
      points.push_back({end_of(piece)});
    }
    return points;
  }

  void add_polyline(std::vector<BulgedPoint> points, bool closed) {
    if (closed && points.size() > 2 && points.front().at == points.back().at) points.pop_back();
    entities_.add(100, "AcDbPolyline");
    entities_.add(90, static_cast<int>(points.size()));
    entities_.add(70, closed ? 1 : 0);
    for (const BulgedPoint& point : points) {
      entities_.add_real(10, point.at.x);
      entities_.add_real(20, point.at.y);
      if (point.bulge != 0.0) entities_.add(42, number_text(point.bulge));
      box_.add(point.at);
    }
  }

  /// Bezier curves as a B-spline of degree 3, each knot between two of them three times.
  void add_spline(const Run& run, bool closed) {
    std::vector<Vec2> controls = {run.start};
    for (const CurvePiece& piece : run.pieces) {
      const auto& cubic = std::get<CubicTo>(piece);
      controls.insert(controls.end(), {cubic.first, cubic.second, cubic.end});
    }
    const auto count = static_cast<int>(run.pieces.size());
    entities_.add(100, "AcDbSpline");
    entities_.add(70, closed ? 9 : 8);  // in a plane
    entities_.add(71, 3);
    entities_.add(72, 3 * count + 5);
    entities_.add(73, static_cast<int>(controls.size()));
    entities_.add(74, 0);
    for (int knot = 0; knot <= count; ++knot) {
      const int times = knot == 0 || knot == count ? 4 : 3;
      for (int k = 0; k < times; ++k)
        entities_.add_real(40, knot);
    }
    for (const Vec2 control : controls) {
      entities_.add_point(10, control);
      box_.add(control);
    }
  }

  void add(const Text& text, const std::string& layer, bool visible) {
    if (text.text.empty() || !std::isfinite(text.at.x) || !std::isfinite(text.at.y)) return;
    begin_entity("TEXT", layer, text.color, false, visible);
    entities_.add(100, "AcDbText");
    entities_.add_words(text);
    entities_.add(100, "AcDbText");
    box_.add(text.at);
  }

  DxfTags header() {
    const Vec2 sheet = {drawing_.width, drawing_.height};
    const auto box = box_.corners().value_or(std::pair(Vec2{}, sheet));
    DxfTags tags;
    tags.begin_section("HEADER");
    const auto add = [&](std::string_view name, int code, std::string_view value) {
      tags.add(9, name);
      tags.add(code, value);
    };
    add("$ACADVER", 1, k_version);
    add("$HANDSEED", 5, frame_.next_handle());
    add("$INSUNITS", 70, std::to_string(k_millimetres));
    add("$MEASUREMENT", 70, "1");
    const auto add_corner = [&](std::string_view name, Vec2 corner, bool has_height) {
      tags.add(9, name);
      tags.add_real(10, corner.x);
      tags.add_real(20, corner.y);
      if (has_height) tags.add_real(30, 0.0);
    };
    add_corner("$EXTMIN", box.first, true);
    add_corner("$EXTMAX", box.second, true);
    add_corner("$LIMMIN", {}, false);
    add_corner("$LIMMAX", sheet, false);
    tags.end_section();
    return tags;
  }

  const Drawing& drawing_;
  R2000Frame frame_;
  DxfTags entities_;
  DxfLayers layers_;
  DxfBox box_;
};

}  // namespace

std::string format_dxf_r2000(const Drawing& drawing, const DxfOptions& options) {
  if (options.stroked_text) {
    const Drawing stroked = with_stroked_text(drawing);
    return R2000File(stroked, options).text();
  }
  return R2000File(drawing, options).text();
}

}  // namespace planish
