#include <planish/report/html_report.h>

#include "core/figure_text.h"
#include "draw/text/markup_text.h"
#include "report/charts/frontier_chart.h"
#include "report/page/html_parts.h"

namespace planish {

namespace {

std::string cell(const std::string& text) {
  return "<td>" + escape_markup(text) + "</td>";
}

std::string row(const std::string& name, const EdgeStrain& strain, const Deviation& deviation,
                Unit unit, const std::string& rest) {
  return "<tr><th>" + escape_markup(name) + "</th>" + cell(percent_text(strain.rms)) +
         cell(percent_text(strain.max)) + cell(percent_text(deviation.rms_over_diagonal)) +
         cell(length_text(deviation.max, unit)) + rest + "</tr>\n";
}

std::string figure_cell(const std::optional<double>& value) {
  return cell(value ? significant_text(*value, 3) : "–");
}

std::string fairness_cells(const Fairness& fairness) {
  return figure_cell(fairness.bending_ratio) + figure_cell(fairness.bending_added) +
         cell(fairness.is_smooth() ? "✓ yes" : "no");
}

std::string name_of_point(const Candidate& point) {
  const bool is_auto = std::holds_alternative<Auto>(point.method);
  return (is_auto ? "auto, " : "") + candidate_name(point) +
         (point.dominated ? " (dominated)" : "");
}

std::string table(const FrontierReport& report) {
  std::string html =
      "<table class=\"compare\">\n<thead><tr><th>Method and stop</th><th>Strain, rms</th>"
      "<th>Strain, largest</th><th>Deviation, rms<small>of the diagonal</small></th>"
      "<th>Deviation, largest</th><th>Bending<small>of the design's</small></th><th>Bending "
      "added<small>of the "
      "design's</small></th><th>Smooth</th><th>Sweeps</th><th>Time<small>s</small></th><th>Ended "
      "as</th></tr></thead>\n"
      "<tbody>\n" +
      row("as designed", report.design.strain, {}, report.unit,
          figure_cell(report.design.fairness.bending_ratio) +
              "<td></td><td></td><td></td><td></td><td></td>");
  for (const auto* points : {&report.curve, &report.others}) {
    for (const Candidate& point : *points) {
      html += row(name_of_point(point), point.strain, point.deviation, report.unit,
                  fairness_cells(point.fairness) + cell(count_text(point.sweeps)) +
                      cell(significant_text(point.seconds, 2)) +
                      cell(std::string(stop_text(point.stop))));
    }
  }
  return html + "</tbody>\n</table>\n";
}

std::string limit_words(const FrontierReport& report) {
  if (!report.limits.any()) {
    return "What every step towards flattenable costs: look for the bend, where more deviation "
           "begins to buy little strain.";
  }
  const auto within = report.first_within_limit();
  const std::string limit = percent_text(report.limits.both_ways());
  if (!within) return "No point of the curve keeps the limit of " + limit + ".";
  const Deviation& deviation = report.curve[*within].deviation;
  return "The limit of " + limit + " is kept if the form may move by " +
         length_text(deviation.max, report.unit) + ", by " +
         length_text(deviation.rms, report.unit) + " as a rule.";
}

}  // namespace

std::string html_report(const FrontierReport& report) {
  const std::string chart = frontier_chart(report);
  return html_page(
      {"frontier", report.name, limit_words(report)},
      "<section class=\"keep\">\n<h2>Strain against deviation</h2>\n<p>Strain "
      "of the pattern in per cent, logarithmic, over the rms deviation of the patch from what "
      "it was. The names along the line are the rms strain asked for. The line goes through "
      "what "
      "no nearer point beats; other points are dots. Dominated is a point if another has less "
      "strain, deviation or bending, and no more of the others. Dots with the name of another "
      "method are rms strain. Below and further left is better. The lower edge of the chart "
      "stands for 0.001 % or less.</p>\n" +
          (chart.empty() ? "<p>Nothing to show: no vertex had to move.</p>\n" : chart) +
          "</section>\n<section>\n<h2>All points</h2>\n<div class=\"scroll\">\n" + table(report) +
          "</div>\n</section>\n");
}

}  // namespace planish
