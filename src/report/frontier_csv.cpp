#include <planish/flatten/frontier.h>

#include "report/json_parts.h"
#include "report/several_files.h"

namespace planish {

std::string frontier_csv(const FrontierReport& report) {
  Json points = Json::array({point_of(report.design)});
  for (const auto* more : {&report.curve, &report.others}) {
    for (const Candidate& point : *more)
      points.push_back(point_of(point));
  }
  points.front()["method"] = "design";
  points.front()["options"] = Json::object();
  for (Json& point : points) {
    for (const char* limit : {"max_strain", "max_rms_strain"}) {
      if (point["options"].value(limit, 0.0) == 0.0) point["options"][limit] = nullptr;
    }
  }
  return csv_of(
      columns_of("method max_strain=options/max_strain strain_rms=strain/rms strain_p99=strain/p99 "
                 "strain_max=strain/max deviation_rms=deviation/rms deviation_max=deviation/max "
                 "rms_over_diagonal=deviation/rms_over_diagonal flattenable bending_ratio "
                 "bending_added smooth sweeps stop seconds max_rms_strain=options/max_rms_strain "
                 "prefer=options/prefer dominated"),
      points);
}

}  // namespace planish
