#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include <planish/report/html_report.h>

#include "core/figure_text.h"
#include "core/number_text.h"
#include "draw/text/markup_text.h"
#include "flatten/product/piece_verdict.h"
#include "flatten/twin_report.h"
#include "flatten/verdict.h"
#include "report/page/html_parts.h"
#include "report/page/page_assets.h"
#include "report/pictures/patch_view.h"
#include "report/pictures/piece_outline.h"
#include "report/pictures/sheet_picture.h"
#include "report/product/whole_product.h"

namespace planish {

namespace {

/// As the start of a sentence.
std::string capital(std::string text) {
  if (!text.empty() && text.front() >= 'a' && text.front() <= 'z')
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text;
}

/// What is missed, or else that nothing is: one sentence, plain text.
std::string sentence_on(const PatchResult& piece) {
  std::string missed, kept;
  for (const PieceCheck& check : piece_checks(piece)) {
    std::string& text = check.met ? kept : missed;
    text += (text.empty() ? "" : "; ") + check.text;
  }
  std::string text = missed.empty() ? kept : missed;
  if (piece.finished && !piece.finished->not_judged.empty() && missed.empty())
    return "Cannot be judged: " + piece.finished->not_judged + ".";
  if (text.empty()) return "No limit was given.";
  if (text.back() != '.') text += '.';
  return capital(text);
}

/// What the pattern and the form cost, plain text.
std::string cost_of(const FinishedPatch& piece) {
  const EdgeStrain& strain = piece.unfold.strain;
  return " The pattern stretches " + largest_strain_text(strain) + " at most, " +
         percent_text(strain.rms) + " rms. " +
         (piece.deviation.max == 0.0
              ? "The form is the design's."
              : "The form moved by " + length_text(piece.deviation.max, piece.unfold.unit) +
                    " at most.");
}

/// Path of a file as the address of a link: what has a meaning there, and bytes beyond ASCII, by
/// their numbers.
std::string address_of(std::string_view path) {
  constexpr std::string_view hex = "0123456789ABCDEF";
  std::string address;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.' || c == '/';
    if (is_plain)
      address += c;
    else
      address += {'%', hex[byte >> 4U], hex[byte & 15U]};
  }
  return address;
}

std::vector<OutlinedSeam> seams_of_piece(const ProductReport& report, std::size_t piece) {
  std::vector<OutlinedSeam> seams;
  for (std::size_t s = 0; s < report.seams.size(); ++s) {
    for (const SeamSide& side : report.seams[s].seam.sides) {
      if (side.patch == piece) seams.push_back({s + 1, side});
    }
  }
  return seams;
}

std::string views_of(const ProductReport& report, std::size_t p) {
  const PatchResult& piece = report.patches[p];
  if (!piece.finished) return {};
  const TriMesh& mesh = piece.finished->processed;
  const std::vector<Vec2>& pattern = piece.finished->unfold.pattern.positions;
  const PatchView view(mesh, {}, k_tile_width);
  return "<div class=\"views\">" +
         html_tile_picture(view.shaded(mesh.positions), piece.name + ": the surface, shaded") +
         piece_outline(Patch(mesh), pattern, OutlineWindow({&pattern, 1}),
                       piece.name + ": outline of the pattern", seams_of_piece(report, p)) +
         "</div>";
}

/// How many of what material, size and kin, plain text.
std::string facts_of(const PatchResult& piece) {
  std::vector<std::string> facts;
  if (piece.words.quantity > 0)
    facts.push_back("cut " + count_text(static_cast<std::size_t>(piece.words.quantity)));
  if (!piece.words.material.empty()) facts.push_back(piece.words.material);
  if (piece.finished) {
    const UnfoldReport& unfold = piece.finished->unfold;
    facts.push_back(size_text(unfold.pattern.width, unfold.pattern.height, unfold.unit));
  }
  if (piece.finished && piece.finished->twin_of)
    facts.push_back(twin_text(*piece.finished->twin_of));
  std::string text;
  for (const std::string& fact : facts)
    text += (text.empty() ? "" : "; ") + fact;
  return text;
}

std::string tile_of(const ProductReport& report, std::size_t p, const std::string& link) {
  const PatchResult& piece = report.patches[p];
  const bool met = piece.outcome().usable();
  const std::string small = facts_of(piece);
  return "<li id=\"" + piece_anchor(p) + "\"" + (met ? "" : " class=\"lacking\"") + ">" +
         views_of(report, p) + "<h3>" + piece_mark(piece) + escape_markup(piece.name) +
         (small.empty() ? "" : "<small>" + escape_markup(small) + "</small>") + "</h3><p>" +
         escape_markup(sentence_on(piece) + (piece.finished ? cost_of(*piece.finished) : "")) +
         "</p>" +
         (piece.finished && !link.empty()
              ? "<p><a href=\"" + address_of(link) + "\">Report of this piece</a></p>"
              : "") +
         "</li>\n";
}

std::string swatch(std::size_t number) {
  return "<svg class=\"swatch " + seam_class(number) +
         "\" viewBox=\"0 0 36 10\" aria-hidden=\"true\"><polyline points=\"0,5 36,5\"/></svg>";
}

std::string millimetres(const std::optional<double>& length) {
  return "<td>" + (length ? decimals_text(*length, 2) : "\u2013") + "</td>";
}

/// Which side is longer.
std::string easing_note(const ProductReport& report, const MeasuredSeam& seam) {
  const std::string text = easing_text(report, seam);
  return text.empty() ? "" : "<br><small>" + escape_markup(text) + "</small>";
}

std::string seam_row(const ProductReport& report, std::size_t s) {
  const MeasuredSeam& seam = report.seams[s];
  const auto name = [&](std::size_t side) {
    return escape_markup(report.patches[seam.seam.sides[side].patch].name);
  };
  const std::string label =
      seam.name.empty() ? "" : "<small>" + escape_markup(seam.name) + "</small>";
  return "<tr id=\"" + seam_anchor(s + 1) + "\"><th>" + swatch(s + 1) + std::to_string(s + 1) +
         label + "</th><td class=\"sewn\">" + name(0) + " \u2013 " + name(1) +
         easing_note(report, seam) + "</td>" + millimetres(seam.difference()) +
         millimetres(seam.on_model[0]) + millimetres(seam.in_pattern[0]) +
         millimetres(seam.in_pattern[1]) + "</tr>\n";
}

/// Borders that look like seams and are none.
std::string near_section(const ProductReport& report) {
  if (report.near_borders.empty()) return {};
  std::string html =
      "<section>\n<h2>Borders without a seam</h2>\n<p>These lie beside each other, but could not "
      "be "
      "matched: they are too short, too ragged or too far apart. <code>--seam-tolerance</code> "
      "says "
      "how far apart borders may be.</p>\n<ul>\n";
  for (const NearBorders& near : report.near_borders) {
    html += "<li>" + escape_markup(near_borders_name(report, near)) + ": " +
            significant_text(near.length, 3) + "\u00A0mm</li>\n";
  }
  return html + "</ul>\n</section>\n";
}

std::string seam_table(const ProductReport& report) {
  std::string near = near_section(report);
  if (report.seams.empty()) return near;
  std::string html =
      "<section>\n<h2>Seams</h2>\n<p>A seam has one colour and one number on both sides. Lengths "
      "in mm. Unless <code>--no-match-seams</code> was given, both sides are as long as on the "
      "model. Where they differ, the longer one must be eased in.</p>\n<div class=\"scroll\">\n"
      "<table class=\"seams\">\n<thead><tr><th>Seam</th><th class=\"sewn\">Pieces</th>"
      "<th>Difference</th><th>On the model</th><th>First piece</th><th>Second piece</th></tr>"
      "</thead>\n<tbody>\n";
  for (std::size_t s = 0; s < report.seams.size(); ++s)
    html += seam_row(report, s);
  return html + "</tbody>\n</table>\n</div>\n</section>\n" + near;
}

/// A few of them: a page with a hundred would be of no use.
std::string sheets_section(const ProductPage& page) {
  constexpr std::size_t most = 6;
  if (page.sheets.empty()) return {};
  std::string html = "<section>\n<h2>On the sheet</h2>\n<p>" +
                     escape_markup(capital(page.on_sheets)) +
                     ". The files are <code>layout.*</code>.</p>\n<div class=\"sheets\">\n";
  const std::size_t count = page.sheets.size(), shown = std::min(count, most);
  for (std::size_t s = 0; s < shown; ++s) {
    const std::string number = count == 1 ? "" : " " + std::to_string(s + 1);
    html +=
        "<figure>" + sheet_picture(page.sheets[s], s + 1, "sheet" + number + " with its pieces") +
        (count == 1 ? ""
                    : "<figcaption>Sheet" + number + " of " + count_text(count) + "</figcaption>") +
        "</figure>\n";
  }
  return html + "</div>\n" +
         (shown < count ? "<p>The first " + count_text(shown) + " are shown.</p>\n" : "") +
         "</section>\n";
}

std::string pieces_words(const ProductReport& report) {
  const auto all = report.patches.size();
  const auto missing = static_cast<std::size_t>(
      std::count_if(report.patches.begin(), report.patches.end(),
                    [](const PatchResult& piece) { return !piece.outcome().usable(); }));
  const bool has_limit = std::any_of(
      report.patches.begin(), report.patches.end(),
      [](const PatchResult& piece) { return piece.finished && !piece.finished->limits.empty(); });
  if (missing == 0 && !has_limit) return {};
  if (missing == 0)
    return (all == 1   ? "The piece is"
            : all == 2 ? "Both pieces are"
                       : "All " + count_text(all) + " pieces are") +
           std::string(" as asked for.");
  return count_text(missing) + " of " + count_text(all) +
         (missing == 1 ? " pieces needs a look, and is shown first."
                       : " pieces need a look, and are shown first.");
}

std::string near_words(const ProductReport& report) {
  double length = 0.0;
  for (const NearBorders& near : report.near_borders)
    length += near.length;
  if (length == 0.0) return {};
  return " Borders lie beside each other along " + significant_text(length, 3) +
         "\u00A0mm without a seam.";
}

std::string seams_words(const ProductReport& report) {
  std::optional<double> largest;
  std::size_t number = 0;
  for (std::size_t s = 0; s < report.seams.size(); ++s) {
    const auto difference = report.seams[s].difference();
    if (!difference || (largest && *difference <= *largest)) continue;
    largest = difference;
    number = s + 1;
  }
  if (!largest) return near_words(report);
  return " Of " + count_text(report.seams.size()) +
         (report.seams.size() == 1 ? " seam" : " seams") + " the two sides differ by " +
         decimals_text(*largest, 2) + "\u00A0mm at most (seam " + std::to_string(number) + ")." +
         near_words(report);
}

std::string verdict_of(const ProductReport& report) {
  const std::string pieces = pieces_words(report), sheet = product_verdict(report);
  return pieces + (pieces.empty() || sheet.empty() ? "" : " ") + sheet + seams_words(report);
}

}  // namespace

std::string html_report(const ProductReport& report, const ProductPage& page) {
  std::string tiles = "<ol class=\"pieces\">\n";
  for (const std::size_t p : missed_first(report))
    tiles += tile_of(report, p, p < page.reports.size() ? page.reports[p] : std::string());
  WholeProduct whole = whole_product(report);
  return html_page({.kind = "product",
                    .name = page.name,
                    .verdict = verdict_of(report),
                    .style = product_style(),
                    .data = std::move(whole.data),
                    .app = app_links(page.project)},
                   whole.html + tiles + "</ol>\n" + sheets_section(page) + seam_table(report));
}

}  // namespace planish
