#include "sheet/piece/allowance_words.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "sheet/piece/sheet_length.h"

namespace planish {

namespace {

/// Edges of one width that is not the usual one.
struct OtherWidth {
  double width = 0.0;
  std::vector<std::string> places;
};

std::string width_text(double width, Unit unit) {
  return width > 0.0 ? short_sheet_length(width, unit, 3) : "none";
}

std::string list_text(const std::vector<std::string>& places) {
  std::string text;
  for (std::size_t i = 0; i < places.size(); ++i)
    text += (i == 0 ? "" : i + 1 < places.size() ? ", " : " and ") + places[i];
  return text;
}

void add_place(double width, const std::string& place, std::vector<OtherWidth>& others) {
  auto found = std::find_if(others.begin(), others.end(),
                            [&](const OtherWidth& other) { return other.width == width; });
  if (found == others.end()) found = others.insert(others.end(), {width, {}});
  if (found->places.empty() || found->places.back() != place) found->places.push_back(place);
}

/// The widths of all points of the outline but those of the fold, which has none.
std::vector<OtherWidth> other_widths(const PieceOutline& outline, const Allowance& widths,
                                     double usual, const std::vector<std::string>& names) {
  std::vector<OtherWidth> others;
  const std::vector<OutlineEdge> edges = edges_between_corners(outline);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const std::vector<double>& of_loop = widths.edge_widths[edges[e].loop];
    const std::vector<std::size_t>& points = edges[e].points;
    const double first = of_loop[points.front()];
    const bool is_whole = std::all_of(points.begin(), points.end() - 1,
                                      [&](std::size_t k) { return of_loop[k] == first; });
    const std::string place = (is_whole ? "" : "a part of ") + names[e];
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const double width = of_loop[points[i]];
      if (width != usual && width >= 0.0) add_place(width, place, others);
    }
  }
  return others;
}

}  // namespace

namespace {

std::string widths_words(const PieceOutline& outline, const PatternOptions& options) {
  constexpr double k_fold = -1.0;
  const double usual = options.allowance->width;
  std::vector<EdgeAllowance> stretches = options.edge_allowances;
  if (options.is_half() && !stretches.empty()) {
    stretches.push_back(fold_stretch(outline, *options.fold));
    stretches.back().width = k_fold;
  }
  std::string plain = width_text(usual, options.sheet_unit) + " allowance";
  if (stretches.empty()) return plain;
  const Allowance widths = with_edge_allowances({.width = usual}, outline, stretches);
  const bool has_usual = std::any_of(
      widths.edge_widths.begin(), widths.edge_widths.end(),
      [&](const auto& loop) { return std::find(loop.begin(), loop.end(), usual) != loop.end(); });
  const std::vector<OtherWidth> others =
      other_widths(outline, widths, usual, words_of_edges(outline, options.edges));
  if (others.empty()) return plain;
  if (!has_usual && others.size() == 1)
    return width_text(others.front().width, options.sheet_unit) + " allowance";
  std::string text = "allowance ";
  if (has_usual) text += width_text(usual, options.sheet_unit);
  for (std::size_t i = 0; i < others.size(); ++i) {
    text += (i > 0 || has_usual ? ", " : "") + width_text(others[i].width, options.sheet_unit) +
            " at " + list_text(others[i].places);
  }
  return text;
}

}  // namespace

std::string allowance_words(const PieceOutline& outline, const PatternOptions& options) {
  if (!options.allowance) return {};
  const bool has_darts = std::any_of(options.edge_allowances.begin(), options.edge_allowances.end(),
                                     [](const EdgeAllowance& edge) { return edge.takes_darts; });
  return widths_words(outline, options) + (has_darts ? ", darts folded and not cut out" : "");
}

}  // namespace planish
