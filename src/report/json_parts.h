#pragma once

#include <optional>
#include <span>
#include <vector>

#include <planish/report/json_report.h>

#include <planish_json/json.h>

namespace planish {

// What several reports have, as JSON.

Json to_json(const Deviation& deviation);
Json to_json(const EdgeStrain& strain);
/// Null where there is none.
Json to_json(const std::optional<EdgeStrain>& strain);
Json to_json(const std::vector<StrainLimitCheck>& checks);
Json to_json(std::span<const Caution> cautions, Unit unit);
Json to_json(const EvolveReport& report);
Json to_json(const UnfoldReport& report);
Json to_json(const CompareReport& report);
Json to_json(const Failure& failure);
Json to_json(const TwinOf& twin);
/// "limits_met", "usable" and "missed".
Json to_json(const Outcome& outcome);
Json to_json(const LayoutReport& layout);
Json to_json(const MeasuredPatch& patch);
/// "strain" and "limits" of a measured patch: null and empty where it cannot be laid flat.
Json strain_and_limits(const std::optional<StrainAsDesigned>& strain);

}  // namespace planish
