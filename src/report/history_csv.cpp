#include <planish/report/json_report.h>

#include "report/json_parts.h"
#include "report/several_files.h"

namespace planish {

namespace {

std::vector<Column> sweep_columns(const std::string& figures) {
  return columns_of(figures +
                    " level_vertices=level/inner_vertices merit_before=level/merit_before "
                    "merit=level/merit level_strain=level/strain");
}

}  // namespace

std::string history_csv(const std::vector<SweepRecord>& history) {
  return csv_of(sweep_columns("sweep e_max e_avg energy moved seconds"), history);
}

std::string history_csv(const CompareReport& report) {
  Json sweeps = Json::array();
  for (const ComparedMethod& method : report.runs) {
    if (!method.evolve) continue;
    for (Json sweep : Json(method.evolve->result.history)) {
      sweep["method"] = name_of(method.run.method);
      sweeps.push_back(std::move(sweep));
    }
  }
  return csv_of(sweep_columns("method sweep seconds e_max e_avg energy moved"), sweeps);
}

}  // namespace planish
