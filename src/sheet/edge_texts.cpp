#include "sheet/edge_texts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "core/figure_text.h"
#include "draw/text/text_lines.h"
#include "pattern/polygon/loop_box.h"
#include "sheet/piece/sheet_length.h"
#include "sheet/sheet_layout.h"

namespace planish {

namespace {

/// Half of what a level text of one line takes in a direction of unit length.
double half_extent(const std::string& text, double height, Vec2 direction) {
  return 0.5 * height * (std::abs(direction.x) * text_width(text) + std::abs(direction.y));
}

/// A level text on the left of a line through `at` along `way`: its box keeps the gap.
Text text_beside(Vec2 at, Vec2 way, double gap, double height, std::string text) {
  const Vec2 left = 1.0 / norm(way) * Vec2{-way.y, way.x};
  const Vec2 middle = at + (gap + half_extent(text, height, left)) * left;
  return {{middle.x, middle.y - 0.5 * height},
          height,
          std::move(text),
          sheet::k_annotation_color,
          true};
}

constexpr double k_length_gap = 2.75, k_length_height = 2.5;

/// Before lengths: "hem ", or with settings of any edge the number of this one, as "2: ".
std::vector<std::string> names_of_edges(const PieceOutline& outline,
                                        const std::vector<PatternEdge>& named) {
  std::vector<std::string> names = words_of_edges(outline, named);
  for (std::size_t e = 0; e < names.size(); ++e) {
    const bool is_number = names[e] == PatternEdge{static_cast<int>(e) + 1}.words();
    names[e] = named.empty() ? "" : is_number ? std::to_string(e + 1) + ": " : names[e] + " ";
  }
  return names;
}

/// Millimetres need no word, inches have one.
std::string length_of_edge(double length, Unit unit) {
  return unit == Unit::mm ? decimals_text(length, 1) : sheet_length(length, unit, 1);
}

/// The lengths from corner to corner, each beside the middle of its edge, inside.
void add_edge_lengths(const PieceOutline& outline, const PatternOptions& options, double scale,
                      std::vector<Text>& texts) {
  constexpr double shortest = 5.0;
  const std::vector<OutlineEdge> edges = edges_between_corners(outline);
  const std::vector<std::string> names = names_of_edges(outline, options.edges);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const OutlineEdge& edge = edges[e];
    if (edge.length < shortest) continue;
    const Polygon& loop = outline.loops[edge.loop];
    const std::size_t k = edge.points.size() / 2;
    const Vec2 a = loop[edge.points[k - 1]], b = loop[edge.points[k]], way = b - a;
    if (!(norm(way) > 0.0)) continue;
    texts.push_back(text_beside(a + 0.5 * way, way, scale * k_length_gap, scale * k_length_height,
                                names[e] + length_of_edge(edge.length, options.sheet_unit)));
  }
}

/// "seam 3: back" in the middle of a side, "3a" and "3b" at its ends.
std::string words_of(const SeamNumber& seam) {
  const std::string number = std::to_string(seam.number);
  if (seam.end != 0) return number + seam.end;
  return "seam " + number + (seam.partner.empty() ? "" : ": " + seam.partner);
}

/// A vertex of the border, and the direction of the border there; nothing for others.
struct BorderPlace {
  Vec2 at, way;
};

std::optional<BorderPlace> place_on_border(const PieceOutline& outline, Index vertex) {
  for (std::size_t l = 0; l < outline.vertices.size(); ++l) {
    const std::vector<Index>& vertices = outline.vertices[l];
    const auto found = std::find(vertices.begin(), vertices.end(), vertex);
    if (found == vertices.end()) continue;
    const Polygon& loop = outline.loops[l];
    const std::size_t n = loop.size(), k = static_cast<std::size_t>(found - vertices.begin());
    return BorderPlace{loop[k], loop[(k + 1) % n] - loop[(k + n - 1) % n]};
  }
  return std::nullopt;
}

/// What is written of seams: in the middle farther inside than a length of the edge would be.
void add_seam_texts(const PieceOutline& outline, const PatternOptions& options, double scale,
                    std::vector<Text>& texts) {
  constexpr double k_height = 4.0, k_gap = 3.5, k_height_of_end = 2.5, k_gap_of_end = 1.5;
  for (const SeamNumber& seam : options.seam_numbers) {
    const auto place = place_on_border(outline, seam.vertex);
    if (!place || !(norm(place->way) > 0.0)) continue;
    if (seam.end != 0) {
      texts.push_back(text_beside(place->at, place->way, scale * k_gap_of_end,
                                  scale * k_height_of_end, words_of(seam)));
      continue;
    }
    const Vec2 left = 1.0 / norm(place->way) * Vec2{-place->way.y, place->way.x};
    const double length =
        options.edge_lengths ? 2.0 * half_extent("1000.0", scale * k_length_height, left) : 0.0;
    texts.push_back(text_beside(place->at, place->way, scale * k_gap + length, scale * k_height,
                                words_of(seam)));
  }
}

}  // namespace

double text_width(const std::string& text) {
  return sheet::k_letter_width * static_cast<double>(letters_in(text));
}

double letter_scale(const Polygon& outline) {
  constexpr double k_small = 100.0, k_large = 1500.0, k_least = 0.4, k_most = 8.0;
  const Vec2 size = loop_box(std::span(&outline, 1)).size();
  const double across = std::max(size.x, size.y);
  return across < k_small ? std::max(k_least, across / k_small)
                          : std::clamp(across / k_large, 1.0, k_most);
}

std::vector<Text> edge_texts(const PieceOutline& outline, const PatternOptions& options) {
  const double scale = letter_scale(outline.loops.front());
  std::vector<Text> texts;
  if (options.edge_lengths) add_edge_lengths(outline, options, scale, texts);
  add_seam_texts(outline, options, scale, texts);
  return texts;
}

}  // namespace planish
