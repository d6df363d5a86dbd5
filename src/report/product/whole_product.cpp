#include "report/product/whole_product.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <planish/report/json_report.h>

#include "core/figure_text.h"
#include "draw/svg/svg_layers.h"
#include "draw/text/markup_text.h"
#include "flatten/product/piece_verdict.h"
#include "flatten/verdict.h"
#include "report/json_parts.h"
#include "report/page/html_parts.h"
#include "report/page/packed_array.h"
#include "report/page/page_assets.h"
#include "report/page/page_json.h"
#include "report/pictures/patch_view.h"
#include "report/pictures/piece_outline.h"

namespace planish {

namespace {

constexpr std::size_t k_most_vertices = 24'000;
constexpr int k_picture_width = 680;  // pixels: sharp at half of it

std::string seam_length(const ProductReport& report) {
  double length = 0.0;  // mm
  for (const MeasuredSeam& seam : report.seams)
    length += seam.on_model[0];
  if (length == 0.0) return "no seam";
  return (length < 1000.0 ? about_text(length) + "\u00A0mm"
                          : about_text(length / 1000.0) + "\u00A0m") +
         " of seam";
}

std::string picture_of(const DrawnProduct& drawn) {
  std::vector<Color> colors;
  for (const DrawnPiece& piece : drawn.pieces)
    colors.insert(colors.end(), piece.vertices, piece_color(piece.patch));
  const PatchView view(drawn.mesh, {}, k_picture_width, standing_view(UpAxis::y));
  return "<div class=\"still\">" +
         html_tile_picture(view.picture(drawn.mesh.positions, colors),
                           "All pieces in their places, each in its colour") +
         "</div>\n";
}

/// What a row says behind the name, plain text.
std::string row_facts(const PatchResult& piece, bool is_drawn) {
  if (!piece.finished) return "failed";
  const UnfoldReport& unfold = piece.finished->unfold;
  const double moved = piece.finished->deviation.max;
  return "stretches " + percent_text(unfold.strain.max) +
         (moved == 0.0 ? "" : ", moves " + length_text(moved, unfold.unit)) +
         (is_drawn ? "" : "; not in the picture");
}

std::string rows_of(const ProductReport& report, const DrawnProduct& drawn) {
  std::string html = "<ol class=\"parts\">\n";
  for (std::size_t p = 0; p < report.patches.size(); ++p) {
    const bool is_drawn = std::any_of(drawn.pieces.begin(), drawn.pieces.end(),
                                      [p](const DrawnPiece& piece) { return piece.patch == p; });
    const std::string chip =
        is_drawn
            ? "<span class=\"chip\" style=\"background:" + hex_text(piece_color(p)) + "\"></span>"
            : "<span class=\"chip\"></span>";
    html += "<li><a href=\"#" + piece_anchor(p) + "\">" + chip + "<span>" +
            piece_mark(report.patches[p]) + escape_markup(report.patches[p].name) + "<small>" +
            escape_markup(row_facts(report.patches[p], is_drawn)) + "</small></span></a></li>\n";
  }
  return html + "</ol>\n";
}

}  // namespace

Color piece_color(std::size_t patch) {
  constexpr std::array<Color, 12> colors = {{{232, 195, 158},
                                             {150, 193, 222},
                                             {198, 216, 140},
                                             {222, 160, 164},
                                             {182, 170, 216},
                                             {136, 204, 186},
                                             {240, 218, 128},
                                             {196, 174, 148},
                                             {226, 174, 214},
                                             {160, 184, 146},
                                             {176, 190, 210},
                                             {242, 172, 130}}};
  return colors.at(patch % colors.size());
}

std::string product_sentence(const ProductReport& report) {
  const std::size_t count = report.patches.size(), failed = count - report.finished();
  double moved = 0.0;
  for (const PatchResult& piece : report.patches) {
    if (piece.finished) moved = std::max(moved, piece.finished->deviation.max);
  }
  const EdgeStrain most = largest_strain(report);
  return count_text(count) + (count == 1 ? " piece" : " pieces") +
         (failed > 0 ? " (" + count_text(failed) + " failed)" : "") + ", " + seam_length(report) +
         "; moves " + (moved == 0.0 ? "0\u00A0mm" : "up to " + length_text(moved, report.unit)) +
         "; needs " +
         (is_too_small_to_measure(most) ? "no stretch" : percent_text(most.p99) + " of stretch") +
         ".";
}

std::string piece_mark(const PatchResult& piece) {
  if (!piece.outcome().usable()) return "<span class=\"missed\">\u2717</span> ";
  const bool is_judged = piece.finished->not_judged.empty();
  return is_judged ? "<span class=\"met\">\u2713</span> "
                   : "<span class=\"neutral\">\u2022</span> ";
}

std::string piece_anchor(std::size_t patch) {
  return "piece-" + std::to_string(patch + 1);
}

std::string seam_anchor(std::size_t number) {
  return "seam-" + std::to_string(number);
}

std::string product_data(const ProductReport& report, const DrawnProduct& drawn) {
  std::size_t whole = 0;
  Json pieces = Json::array(), seams = Json::array();
  for (const DrawnPiece& piece : drawn.pieces) {
    const Color color = piece_color(piece.patch);
    whole += report.patches[piece.patch].finished->processed.positions.size();
    pieces.push_back({{"name", report.patches[piece.patch].name},
                      {"number", piece.patch + 1},
                      {"color", {color.r, color.g, color.b}},
                      {"vertices", piece.vertices},
                      {"middle", piece.middle}});
  }
  for (const DrawnSeam& seam : drawn.seams) {
    seams.push_back({{"number", seam.number},
                     {"piece", seam.patch + 1},
                     {"vertices", packed_numbers(seam.vertices)}});
  }
  std::vector<std::string> names = {"result"};
  std::vector<std::vector<Vec3>> positions = {drawn.mesh.positions};
  if (!drawn.design.empty()) {
    names.insert(names.begin(), "design");
    positions.insert(positions.begin(), drawn.design);
  }
  const std::size_t count = drawn.mesh.positions.size();
  return data_element(
      {{"schema", k_json_schema},
       {"unit", to_string(report.unit)},
       {"vertices", count},
       {"of", whole},
       {"views",
        {{"y", view_json(standing_view(UpAxis::y))}, {"z", view_json(standing_view(UpAxis::z))}}},
       {"middle", drawn.middle},
       {"triangles", triangles_json(drawn.mesh.triangles, count)},
       {"states", states_json(names, names.size() - 1, positions)},
       {"pieces", std::move(pieces)},
       {"seams", std::move(seams)}});
}

WholeProduct whole_product(const ProductReport& report) {
  const DrawnProduct drawn = drawn_product(report, k_most_vertices);
  if (drawn.pieces.empty()) return {};
  WholeProduct whole;
  whole.html = "<section class=\"whole keep\">\n<h2>The whole product</h2>\n<p class=\"sum\">" +
               escape_markup(product_sentence(report)) +
               "</p>\n<div class=\"room\">\n<div>\n<div id=\"stage\"></div>\n" + picture_of(drawn) +
               "</div>\n" + rows_of(report, drawn) + "</div>\n</section>\n";
  if (page_script().is_there()) whole.data = product_data(report, drawn);
  return whole;
}

}  // namespace planish
