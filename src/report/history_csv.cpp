#include <initializer_list>
#include <string_view>

#include <planish/report/json_report.h>

#include "core/number_text.h"

namespace planish {

namespace {

// A field for every number behind what stands there.
void append_numbers(std::string& csv, std::initializer_list<double> values) {
  for (const double value : values) {
    csv += ',';
    append_number(csv, value);
  }
}

constexpr std::string_view k_level_columns = "level_vertices,merit_before,merit,level_strain";

// Empty fields where there is no level.
void append_level(std::string& csv, const std::optional<LevelRecord>& level) {
  if (!level) {
    csv += ",,,,";
    return;
  }
  csv += ',' + std::to_string(level->inner_vertices);
  append_numbers(csv, {level->merit_before, level->merit, level->strain});
}

}  // namespace

std::string history_csv(const std::vector<SweepRecord>& history) {
  std::string csv = "sweep,e_max,e_avg,energy,moved,seconds," + std::string(k_level_columns) + "\n";
  for (const SweepRecord& record : history) {
    csv += std::to_string(record.sweep);
    append_numbers(csv, {record.e_max, record.e_avg, record.energy});
    csv += ',' + std::to_string(record.moved);
    append_numbers(csv, {record.seconds});
    append_level(csv, record.level);
    csv += '\n';
  }
  return csv;
}

std::string history_csv(const CompareReport& report) {
  std::string csv =
      "method,sweep,seconds,e_max,e_avg,energy,moved," + std::string(k_level_columns) + "\n";
  for (const ComparedMethod& method : report.runs) {
    if (!method.evolve) continue;
    for (const SweepRecord& record : method.evolve->result.history) {
      csv += std::string(name_of(method.run.method)) + ',' + std::to_string(record.sweep);
      append_numbers(csv, {record.seconds, record.e_max, record.e_avg, record.energy});
      csv += ',' + std::to_string(record.moved);
      append_level(csv, record.level);
      csv += '\n';
    }
  }
  return csv;
}

}  // namespace planish
