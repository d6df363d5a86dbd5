#include "report/page/page_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <planish/draw/color.h>
#include <planish/measure/fairness.h>
#include <planish/measure/flattenability.h>
#include <planish/mesh/patch.h>
#include <planish/sheet/pattern_sheet.h>

#include "draw/base64.h"
#include "draw/scale_limit.h"
#include "measure/normals.h"
#include "report/json_parts.h"
#include "report/page/display_mesh.h"
#include "report/page/packed_array.h"
#include "report/page/page_json.h"
#include "report/pictures/view.h"
#include "sheet/limit_map.h"
#include "unfold/strain/vertex_strain.h"

namespace planish {

namespace {

constexpr double k_nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double k_scale_share = 0.98;  // of the vertices within a scale
constexpr int k_map_colors = 129;       // of a colour map

/// A figure of all vertices, by state; a list that is empty: there is none.
struct VertexFigure {
  const char* id;
  ColorMap map;
  double limit = 0.0;
  std::vector<std::vector<double>> by_state = {};
};

/// What the share of the sizes does not exceed, rounded up.
double limit_of(const std::vector<double>& values, double share, double least) {
  std::vector<double> sizes;
  for (const double value : values) {
    if (std::isfinite(value)) sizes.push_back(std::abs(value));
  }
  // Of patches beyond all sizes squares are 0 or infinite.
  constexpr double lowest = 1e-300, highest = 1e300;
  if (sizes.empty()) return std::clamp(least, lowest, highest);
  const auto rank = static_cast<std::size_t>(share * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(rank), sizes.end());
  return round_up_125(std::clamp(std::max(sizes[rank], least), lowest, highest));
}

/// The same of all values of all states.
double largest_limit(const VertexFigure& figure, double least) {
  double limit = least;
  for (const auto& values : figure.by_state)
    limit = std::max(limit, limit_of(values, 1.0, least));
  return limit;
}

/// The largest size of all values of all states, with two digits rounded up: a scale that fits.
double fitted_limit(const VertexFigure& figure, double least) {
  double largest = least;
  for (const auto& values : figure.by_state) {
    for (const double value : values) {
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    }
  }
  const double step = round_up_125(largest) / 100.0;
  const double fitted = std::ceil(largest / step * (1.0 - 1e-12)) * step;
  return std::isfinite(fitted) && fitted > 0.0 ? fitted : largest;
}

/// NaN where nothing is measured.
std::vector<double> of_inner(std::vector<double> values, const Patch& patch) {
  for (Index v = 0; v < values.size(); ++v) {
    if (!patch.is_inner(v)) values[v] = k_nothing;
  }
  return values;
}

std::vector<double> moves(std::span<const Vec3> before, std::span<const Vec3> after) {
  std::vector<double> lengths;
  lengths.reserve(before.size());
  for (std::size_t v = 0; v < before.size(); ++v)
    lengths.push_back(norm(after[v] - before[v]));
  return lengths;
}

bool is_same(const PageState& a, const PageState& b) {
  return a.patch.positions() == b.patch.positions() &&
         std::equal(a.pattern.begin(), a.pattern.end(), b.pattern.begin(), b.pattern.end());
}

/// Stretch in the direction where the pattern is longest beside the patch, and across it, where it
/// is shortest.
std::array<VertexFigure, 2> principal_figures(const PageInput& input) {
  VertexFigure longest{"longest", ColorMap::diverging, input.strain_limit};
  VertexFigure shortest{"shortest", ColorMap::diverging, input.strain_limit};
  for (const PageState& state : input.states) {
    auto& most = longest.by_state.emplace_back();
    auto& least = shortest.by_state.emplace_back();
    if (state.pattern.empty()) continue;
    for (const PrincipalStretch& stretch : vertex_stretches(state.patch.mesh(), state.pattern)) {
      most.push_back(stretch.max - 1.0);
      least.push_back(stretch.min - 1.0);
    }
  }
  return {std::move(longest), std::move(shortest)};
}

std::vector<VertexFigure> figures_of(const PageInput& input) {
  VertexFigure defect{"defect", ColorMap::diverging, input.defect_limit};
  VertexFigure curvature{"curvature", ColorMap::paper};
  VertexFigure bent{"bent", ColorMap::sequential};
  VertexFigure deviation{"deviation", ColorMap::sequential};
  VertexFigure offset{"offset", ColorMap::diverging};
  VertexFigure strain{"strain", ColorMap::diverging, input.strain_limit};
  VertexFigure edge_strain{"edge_strain", ColorMap::diverging, input.strain_limit};
  const double weight_of_stretch = input.limit ? input.limit->weight_of_stretch() : 1.0;
  for (const PageState& state : input.states) {
    const Patch& patch = state.patch;
    deviation.by_state.push_back(moves(input.patch().positions(), patch.positions()));
    // The design itself has none.
    offset.by_state.push_back(&state == &input.states.front()
                                  ? std::vector<double>()
                                  : normal_offsets(input.patch(), patch.positions()));
    if (!defect.by_state.empty() && is_same(state, input.states.front())) {
      for (VertexFigure* figure : {&defect, &curvature, &bent, &strain, &edge_strain}) {
        std::vector<double> same = figure->by_state.front();
        figure->by_state.push_back(std::move(same));
      }
      continue;
    }
    const auto defects = angle_defects(patch);
    curvature.by_state.push_back(of_inner(gaussian_curvatures(patch, defects), patch));
    defect.by_state.push_back(of_inner(defects, patch));
    bent.by_state.push_back(vertex_bends(patch));
    strain.by_state.push_back(state.pattern.empty() ? std::vector<double>()
                                                    : vertex_strains(patch.mesh(), state.pattern));
    edge_strain.by_state.push_back(
        state.pattern.empty() ? std::vector<double>()
                              : largest_edge_strains(patch, state.pattern, weight_of_stretch));
  }
  const double size = bounding_box_diagonal(input.patch().mesh());
  curvature.limit = limit_of(curvature.by_state.front(), k_scale_share, 1e-6 / (size * size));
  // One scale for all states: what is darker than the design was is new.
  bent.limit = limit_of(bent.by_state.front(), k_scale_share, 1e-3 / size);
  deviation.limit = largest_limit(deviation, 1e-6 * size);
  offset.limit = fitted_limit(offset, 1e-6 * size);
  std::vector<VertexFigure> figures = {std::move(defect), std::move(curvature),
                                       std::move(bent),   std::move(deviation),
                                       std::move(strain), std::move(edge_strain)};
  if (input.limit) {
    for (VertexFigure& figure : principal_figures(input))
      figures.push_back(std::move(figure));
  }
  figures.push_back(std::move(offset));
  return figures;
}

/// The vertex of every list at which the figure is largest.
std::vector<Index> worst_vertices(const std::vector<VertexFigure>& figures) {
  std::vector<Index> worst;
  for (const VertexFigure& figure : figures) {
    for (const auto& values : figure.by_state) {
      Index best = 0;
      double largest = -1.0;
      for (Index v = 0; v < values.size(); ++v) {
        if (!(std::abs(values[v]) > largest)) continue;
        largest = std::abs(values[v]);
        best = v;
      }
      if (largest >= 0.0) worst.push_back(best);
    }
  }
  return worst;
}

template <class Value>
std::vector<Value> picked(std::span<const Value> values, const std::vector<Index>& source) {
  std::vector<Value> some;
  some.reserve(source.size());
  for (const Index v : source)
    some.push_back(values[v]);
  return some;
}

Json to_json(const VertexFigure& figure, const std::vector<Index>& source) {
  Json values = Json::array();
  for (const auto& all : figure.by_state) {
    values.push_back(all.empty()
                         ? Json(nullptr)
                         : Json(packed_floats(picked(std::span<const double>(all), source))));
  }
  return {{"id", figure.id},
          {"map", figure.map == ColorMap::diverging    ? "diverging"
                  : figure.map == ColorMap::sequential ? "sequential"
                                                       : "paper"},
          {"limit", figure.limit},
          {"values", std::move(values)}};
}

Json states_json(const PageInput& input, const DisplayMesh& shown) {
  std::vector<std::vector<Vec3>> positions;
  std::vector<std::string> names;
  for (const PageState& state : input.states) {
    positions.push_back(picked(std::span<const Vec3>(state.patch.positions()), shown.source));
    names.push_back(state.name);
  }
  return states_json(names, input.shown, positions);
}

Json drawn_json(const PageInput& input, const DisplayMesh& shown) {
  if (input.drawn.empty()) return nullptr;
  const PackedPoints packed = packed_points(picked(input.drawn, shown.source));
  return {{"low", packed.low}, {"step", packed.step}, {"positions", packed.data.front()}};
}

std::string map_bytes(ColorMap map) {
  std::string bytes;
  for (int i = 0; i < k_map_colors; ++i) {
    const double share = static_cast<double>(i) / (k_map_colors - 1);
    const Color color = color_at(map, map == ColorMap::diverging ? 2.0 * share - 1.0 : share);
    for (const std::uint8_t part : {color.r, color.g, color.b})
      bytes += static_cast<char>(part);
  }
  return base64(bytes);
}

std::size_t usual_most(const PageInput& input) {
  constexpr std::size_t bytes = 3'400'000;  // base64 makes four of three
  // Positions and six figures by state, eight with a limit; offsets of all but the first; number,
  // place in the pattern and two triangles.
  const std::size_t figures = input.limit ? 8 : 6, states = input.states.size();
  return bytes / ((6 + 4 * figures) * states + 4 * (states - 1) + 16);
}

/// One limit, or two where those of stretch and compression are apart: null where one has none.
Json limit_json(const MapLimit& limit) {
  const Color beyond = k_beyond_limit;
  Json json = Json::object();
  if (limit.stretch == limit.compression) {
    json["asked"] = limit.stretch;
  } else {
    json["stretch"] = limit.stretch;
    json["compression"] = limit.compression;
  }
  json["beyond"] = {beyond.r, beyond.g, beyond.b};
  return json;
}

/// By the numbers that people know vertices by.
std::vector<Index> numbers_of(const PageInput& input, const DisplayMesh& shown) {
  return input.source.empty() ? shown.source : picked(input.source, shown.source);
}

}  // namespace

std::string json_for_script(std::string json) {
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos;)
    json.replace(at, 1, "\\u003c");
  return json;
}

Json view_json(const View& view) {
  return {{"right", view.right}, {"up", view.up}, {"towards", view.towards}};
}

Json triangles_json(std::span<const Triangle> triangles, std::size_t vertices) {
  std::vector<Index> corners;
  corners.reserve(3 * triangles.size());
  for (const Triangle& t : triangles)
    corners.insert(corners.end(), t.begin(), t.end());
  const bool is_small = vertices <= 65536;
  return {{"bits", is_small ? 16 : 32},
          {"data", is_small ? packed_small_numbers(corners) : packed_numbers(corners)}};
}

Json states_json(std::span<const std::string> names, std::size_t shown,
                 std::span<const std::vector<Vec3>> positions) {
  const PackedPoints packed = packed_points(positions);
  return {{"names", std::vector<std::string>(names.begin(), names.end())},
          {"shown", shown},
          {"low", packed.low},
          {"step", packed.step},
          {"positions", packed.data}};
}

std::string data_element(const Json& json) {
  return "<script type=\"application/json\" id=\"report-data\">" +
         json_for_script(json_text(json, -1)) + "</script>\n";
}

std::string page_data(const PageInput& input) {
  const std::vector<VertexFigure> figures = figures_of(input);
  const std::size_t most = input.most_vertices > 0 ? input.most_vertices : usual_most(input);
  const DisplayMesh shown = display_mesh(input.patch(), most, worst_vertices(figures));
  Json modes = Json::array();
  for (const VertexFigure& figure : figures)
    modes.push_back(to_json(figure, shown.source));
  Json json = {{"schema", k_json_schema},
               {"unit", to_string(input.unit)},
               {"vertices", shown.source.size()},
               {"of", input.patch().vertex_count()},
               {"view", view_json(view_of(input.patch().mesh()))},
               {"maps",
                {{"diverging", map_bytes(ColorMap::diverging)},
                 {"sequential", map_bytes(ColorMap::sequential)},
                 {"paper", map_bytes(ColorMap::paper)}}},
               {"numbers", packed_numbers(numbers_of(input, shown))},
               {"triangles", triangles_json(shown.triangles, shown.source.size())},
               {"states", states_json(input, shown)},
               {"figures", std::move(modes)},
               {"pattern", drawn_json(input, shown)}};
  if (input.limit) {
    json["limit"] = limit_json(*input.limit);
    json["maps"]["pale"] = map_bytes(ColorMap::pale);
  }
  return data_element(json);
}

}  // namespace planish
