#include "sheet/cut_sheet.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <planish/sheet/pattern_sheet.h>

namespace planish {

namespace {

constexpr Color k_dart_red = {215, 0, 20};
constexpr Color k_outline_gray = {60, 60, 64};
// Millimetres, of a sheet up to k_usual_sheet wide; of a wider one more, to be seen on a screen.
constexpr double k_dart_width = 0.8, k_cut_number_height = 5.0, k_usual_sheet = 800.0;

/// The edges of the pattern, by their ends in it, that stand for edges of a path of the mesh.
std::vector<std::array<Index, 2>> edges_of_path(const CutMesh& cut,
                                                const std::vector<Index>& path) {
  std::vector<std::array<Index, 2>> wanted;
  for (std::size_t i = 1; i < path.size(); ++i)
    wanted.push_back({std::min(path[i - 1], path[i]), std::max(path[i - 1], path[i])});
  std::sort(wanted.begin(), wanted.end());
  std::vector<std::array<Index, 2>> edges;
  for (const Triangle& t : cut.mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = t[k], w = t[(k + 1) % 3];
      const Index a = cut.source[v], b = cut.source[w];
      // Each inner edge comes from either side: once is enough.
      if (a < b && std::binary_search(wanted.begin(), wanted.end(), std::array{a, b}))
        edges.push_back({v, w});
    }
  }
  return edges;
}

/// Edges as lines that are as long as they can be drawn in one go.
std::vector<std::vector<Index>> chained(std::vector<std::array<Index, 2>> edges) {
  std::vector<std::vector<Index>> lines;
  while (!edges.empty()) {
    std::vector<Index>& line = lines.emplace_back(edges.back().begin(), edges.back().end());
    edges.pop_back();
    for (bool grew = true; grew;) {
      grew = false;
      for (auto edge = edges.begin(); edge != edges.end() && !grew; ++edge) {
        auto [a, b] = *edge;
        if (b == line.back() || b == line.front()) std::swap(a, b);
        if (a != line.back() && a != line.front()) continue;
        if (a == line.front()) std::reverse(line.begin(), line.end());
        line.push_back(b);
        edges.erase(edge);
        grew = true;
        break;
      }
    }
  }
  return lines;
}

}  // namespace

Drawing cut_sheet(const CutSuggestion& suggestion, Unit unit, const std::string& name) {
  const CutPattern& first = suggestion.first;
  const Patch opened(first.cut.mesh);
  const UnfoldReport report = {first.pattern, first.strain, unit,
                               largest_border_strain(opened, first.pattern.positions)};
  const PatternGeometry pattern = pattern_geometry(opened.mesh(), report, name);
  Drawing sheet = pattern_sheet(opened.mesh(), report, pattern);
  for (Layer& layer : sheet.layers) {
    if (layer.name != "cut" && layer.name != "hole") continue;
    for (DrawingShape& shape : layer.shapes)
      std::get<Path>(shape).stroke = Stroke{k_outline_gray};
  }
  const double larger = std::max(1.0, std::max(sheet.width, sheet.height) / k_usual_sheet);
  Layer layer{"suggested", {}};
  for (std::size_t k = 0; k < suggestion.cuts.size(); ++k) {
    const SuggestedCut& cut = suggestion.cuts[k];
    if (!cut.is_dart) continue;
    Path lines{{}, false, Stroke{k_dart_red, larger * k_dart_width}};
    for (const std::vector<Index>& line : chained(edges_of_path(first.cut, cut.path))) {
      std::vector<Vec2>& points = lines.lines.emplace_back();
      for (const Index v : line)
        points.push_back(pattern.positions[v]);
    }
    layer.shapes.emplace_back(std::move(lines));
    // The tip is inside, so that it is there once.
    const Vec2 tip = pattern.positions[cut.path.back()] + larger * Vec2{1.5, 1.5};
    layer.shapes.emplace_back(
        Text{tip, larger * k_cut_number_height, std::to_string(k + 1), k_dart_red});
  }
  sheet.layers.push_back(std::move(layer));
  return sheet;
}

}  // namespace planish
