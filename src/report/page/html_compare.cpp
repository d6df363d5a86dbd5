#include <span>
#include <vector>

#include <planish/report/html_report.h>
#include <planish/sheet/pattern_sheet.h>

#include "core/figure_text.h"
#include "core/number_text.h"
#include "draw/svg/svg_layers.h"
#include "draw/text/markup_text.h"
#include "report/charts/convergence_chart.h"
#include "report/page/compare_table.h"
#include "report/page/html_parts.h"
#include "report/page/html_viewer.h"
#include "report/pictures/direction_picture.h"
#include "report/pictures/patch_picture.h"
#include "report/pictures/strain_picture.h"

namespace planish {

namespace {

constexpr int k_compare_picture_width = 480;  // pixels: many pictures, each shown small

std::string headline(const CompareReport& report) {
  const auto best = best_run(report);
  if (!best) {
    return "No method improved this patch without a price that makes the result unfit: see what "
           "each did below.";
  }
  const ComparedMethod& method = report.runs[*best];
  const std::string name(name_of(method.run.method));
  if (!report.design_least_stretch) {
    return name + " did best: it lowered the curvature left from " +
           significant_text(report.before.figures.sum_abs_defect, 3) + " to " +
           significant_text(method.evolve->after.figures.sum_abs_defect, 3) + " rad.";
  }
  return name + " did best: it lowered the strain of the pattern from " +
         percent_text(report.design_least_stretch->strain.rms) + " to " +
         percent_text(method.unfold->strain.rms) + " rms.";
}

std::string table_section(const CompareReport& report) {
  const std::string patterns = report.design_least_stretch
                                   ? "Read the strain first: it is what the material feels."
                                   : "There are no patterns, so read the curvature left: " +
                                         escape_markup(report.why_no_patterns) + ".";
  return "<section>\n<h2>The methods</h2>\n<p>" + patterns +
         " A lower energy or e_max alone does not make a better pattern. Then look at what it "
         "cost: "
         "how far the vertices moved, needles among the triangles, a crumpled surface. ★ marks the "
         "best of each column.</p>\n<div class=\"scroll\">\n" +
         compare_table(report) + "</div>\n</section>\n";
}

std::string charts_section(const CompareReport& report) {
  std::string charts;
  for (const ChartFigure& figure : k_chart_figures) {
    for (const ChartAgainst against : {ChartAgainst::sweeps, ChartAgainst::seconds}) {
      const std::string chart = comparison_chart(report, figure, against);
      if (chart.empty()) continue;
      charts += "<figure>" + chart + "<figcaption><b>" + std::string(figure.name) +
                "</b> against " + (against == ChartAgainst::sweeps ? "sweeps" : "seconds") +
                "</figcaption></figure>\n";
    }
  }
  if (charts.empty()) return {};
  return "<section>\n<h2>The sweeps</h2>\n<p>All axes are logarithmic; those of sweeps and "
         "time begin with a stub for 0. What a sweep is differs between methods, so compare by "
         "time too; time is that of this "
         "machine.</p>\n<div class=\"charts\">\n" +
         charts + "</div>\n</section>\n";
}

bool has_pattern(const CompareReport& report, const ComparedMethod& method) {
  return report.design_least_stretch && method.unfold;
}

/// All pictures of the page, those of the input first.
struct Pictures {
  PatchPictures patches;
  std::vector<Image> patterns;
  double strain_limit = 0.0;
};

Pictures pictures_of(const CompareReport& report) {
  std::vector<std::span<const Vec3>> results;
  std::vector<PatternOfPatch> patterns;
  if (report.design_least_stretch) {
    patterns.push_back({report.input.positions(), report.design_least_stretch->pattern});
  }
  for (const ComparedMethod& method : report.runs) {
    if (!method.evolve) continue;
    const auto& positions = method.evolve->result.positions;
    results.emplace_back(positions);
    if (has_pattern(report, method)) patterns.push_back({positions, method.unfold->pattern});
  }
  Pictures pictures;
  pictures.patches =
      patch_pictures(report.input, results, ColorMap::diverging, k_compare_picture_width);
  if (report.design_least_stretch) {
    pictures.strain_limit = strain_map_limit(report.design_least_stretch->strain);
    pictures.patterns = strain_pictures(report.input.mesh(), patterns, pictures.strain_limit,
                                        k_compare_picture_width);
  }
  return pictures;
}

std::string strain_text(const UnfoldReport& unfold) {
  return percent_text(unfold.strain.rms) + " rms, " + percent_text(unfold.strain.max) +
         " at worst; area " + decimals_text(unfold.pattern.area_ratio, 3) + " of the patch's" +
         (unfold.pattern.overlaps ? "; overlaps itself" : "") +
         (unfold.pattern.flipped_triangles > 0 ? "; flipped triangles" : "");
}

std::string pictures_of_one(const Image& patch, const Image* pattern, const std::string& name) {
  std::string html = "<div class=\"pair\">\n" +
                     html_picture(patch, "Patch, " + name + ", coloured by angle defect", "Patch");
  if (pattern != nullptr) {
    html += html_picture(*pattern, "Pattern, " + name + ", coloured by strain", "Pattern");
  }
  return html + "</div>\n";
}

std::string figures_of_run(const ComparedMethod& method, const std::string& unit) {
  const EvolveReport& evolve = *method.evolve;
  const Deviation& deviation = evolve.deviation;
  constexpr double degrees = 57.295779513082320877;
  std::string html = "<dl class=\"run\">\n";
  if (method.unfold) html += html_entry("Strain", strain_text(*method.unfold));
  return html +
         html_entry("Deviation", significant_text(deviation.rms, 2) + " " + unit + " rms (" +
                                     percent_text(deviation.rms_over_diagonal) + " of size), " +
                                     significant_text(deviation.max, 2) + " " + unit + " at most") +
         html_entry("Smallest angle",
                    significant_text(degrees * evolve.after.figures.min_angle, 3) + "°") +
         html_entry("Run", effort_text(evolve.result)) +
         html_entry("Ended as", stop_text(evolve.result.stop)) +
         html_entry("Options", options_text(method.run.method)) + "</dl>\n";
}

std::string card(const std::string& heading, const std::string& words, const std::string& content) {
  return "<section class=\"keep\">\n<h2>" + heading + "</h2>\n<p>" + escape_markup(words) +
         "</p>\n" + content + "</section>\n";
}

std::string scales(const Pictures& pictures) {
  std::string html = legend(fields_of(ColorMap::diverging),
                            defect_labels(ColorMap::diverging, pictures.patches.limit));
  if (!pictures.patterns.empty()) {
    const std::string limit = fixed_text(100.0 * pictures.strain_limit, 3) + "\u00A0%";
    html += legend(fields_of(ColorMap::diverging),
                   {"shorter <b>−" + limit + "</b>", "<b>0</b>", "longer <b>+" + limit + "</b>"});
  }
  return html;
}

std::string cards_section(const CompareReport& report) {
  const Pictures pictures = pictures_of(report);
  const std::string unit = report.design_least_stretch
                               ? std::string(to_string(report.design_least_stretch->unit))
                               : "model units";
  std::size_t patch = 0, pattern = 0;
  const auto next_pattern = [&](bool has_one) {
    return has_one ? &pictures.patterns.at(pattern++) : nullptr;
  };
  const Topology& topology = report.before.inspection.topology;
  std::string html =
      card("input",
           count_text(topology.vertices) + " vertices, " + count_text(topology.inner_vertices) +
               " of them inner; all pictures have its view and its scales",
           pictures_of_one(pictures.patches.before,
                           next_pattern(report.design_least_stretch.has_value()), "input") +
               scales(pictures));
  for (std::size_t i = 0; i < report.runs.size(); ++i) {
    const ComparedMethod& method = report.runs[i];
    const std::string name = escape_markup(name_of(method.run.method));
    if (!method.evolve) continue;  // the table says why
    html += card(run_swatch(i) + name, verdict_text(report, method),
                 pictures_of_one(pictures.patches.after.at(patch++),
                                 next_pattern(has_pattern(report, method)), name) +
                     figures_of_run(method, unit));
  }
  return "<div class=\"cards\">\n" + html + "</div>\n";
}

std::string key_list(const std::vector<DirectionKey>& keys) {
  std::string html = "<ul class=\"key\">\n";
  for (const DirectionKey& key : keys) {
    html +=
        "<li><svg viewBox=\"0 0 1 1\" aria-hidden=\"true\"><rect width=\"1\" height=\"1\" "
        "fill=\"" +
        hex_text(key.color) + "\"/></svg>" + escape_markup(key.text) + "</li>\n";
  }
  return html + "</ul>\n";
}

std::string directions_section(const CompareReport& report) {
  const auto directions = laplacian_directions(report.input);
  const DirectionPictures pictures =
      direction_pictures(report.input.mesh(), directions, 2 * k_compare_picture_width);
  const auto column = [](const DirectionPicture& picture) {
    return "<div>" +
           html_picture(picture.image, picture.title,
                        "<b>" + escape_markup(picture.title) + "</b>") +
           key_list(picture.keys) + "</div>\n";
  };
  return "<section class=\"keep\">\n<h2>Where Laplacian directions help</h2>\n<p>Of the input: "
         "what "
         "each vertex is, and whether a small step along its Laplacian vector lowers the ring "
         "energy. Where it does not, methods that move along Laplacian directions are stuck, "
         "however much there is to flatten.</p>\n<div class=\"pair\">\n" +
         column(pictures.classes) + column(pictures.directions) + "</div>\n</section>\n";
}

}  // namespace

std::string html_report(const CompareReport& report) {
  const PatchViewer viewer = html_viewer(report);
  return html_page(
      {.kind = "comparison", .name = report.name, .verdict = headline(report), .data = viewer.data},
      table_section(report) + viewer.html + charts_section(report) + cards_section(report) +
          directions_section(report));
}

}  // namespace planish
