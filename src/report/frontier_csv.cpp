#include <planish/flatten/frontier.h>

#include "core/number_text.h"
#include "report/enumerator_name.h"

namespace planish {

namespace {

void append_limit(std::string& csv, double limit) {
  if (limit > 0.0) append_number(csv, limit);
}

void append_point(std::string& csv, const Candidate& point) {
  csv += std::string(point.is_design() ? "design" : name_of(point.method)) + ',';
  const auto* options = point.is_design() ? nullptr : std::get_if<Auto>(&point.method);
  append_limit(csv, options != nullptr ? options->max_strain : 0.0);
  for (const double value :
       {point.strain.rms, point.strain.p99, point.strain.max, point.deviation.rms,
        point.deviation.max, point.deviation.rms_over_diagonal}) {
    csv += ',';
    append_number(csv, value);
  }
  const auto yes_or_no = [](bool yes) { return yes ? ",1" : ",0"; };
  csv += yes_or_no(point.flattenable);
  for (const auto& figure : {point.fairness.bending_ratio, point.fairness.bending_added}) {
    csv += ',';
    if (figure) append_number(csv, *figure);
  }
  csv += yes_or_no(point.fairness.is_smooth());
  csv += ',' + std::to_string(point.sweeps) + ',' + std::string(to_string(point.stop)) + ',';
  append_number(csv, point.seconds);
  csv += ',';
  append_limit(csv, options != nullptr ? options->max_rms_strain : 0.0);
  csv += ',';
  if (options != nullptr) csv += enumerator_name(options->prefer);
  csv += yes_or_no(point.dominated);
  csv += '\n';
}

}  // namespace

std::string frontier_csv(const FrontierReport& report) {
  std::string csv =
      "method,max_strain,strain_rms,strain_p99,strain_max,deviation_rms,deviation_max,"
      "rms_over_diagonal,flattenable,bending_ratio,bending_added,smooth,sweeps,stop,seconds,"
      "max_rms_strain,prefer,dominated\n";
  append_point(csv, report.design);
  for (const auto* points : {&report.curve, &report.others}) {
    for (const Candidate& point : *points)
      append_point(csv, point);
  }
  return csv;
}

}  // namespace planish
