#pragma once

#include <optional>
#include <span>
#include <vector>

#include <planish/report/json_report.h>

#include <planish_json/json.h>

/// Null where there is no value.
template <class Value>
struct nlohmann::adl_serializer<std::optional<Value>> {
  template <class Json>
  static void to_json(Json& json, const std::optional<Value>& value) {
    json = value ? Json(*value) : Json(nullptr);
  }
};

namespace planish {

// What reports are made of, as JSON: a list of them, or one that may be missing, is JSON too.

void to_json(Json& json, Vec2 at);
void to_json(Json& json, Vec3 at);
void to_json(Json& json, const Problem& problem);
void to_json(Json& json, const Obstruction& obstruction);
void to_json(Json& json, const StrainAsDesigned& strain);
void to_json(Json& json, const Deviation& deviation);
void to_json(Json& json, const EdgeStrain& strain);
void to_json(Json& json, const LimitCheck& check);
void to_json(Json& json, const Overlap& overlap);
void to_json(Json& json, const OpenedCrossings& opened);
void to_json(Json& json, const SweepRecord& record);
void to_json(Json& json, const EvolveReport& report);
void to_json(Json& json, const UnfoldReport& report);
void to_json(Json& json, const CompareReport& report);
void to_json(Json& json, const Failure& failure);
void to_json(Json& json, const TwinOf& twin);
/// "limits_met", "usable" and "missed".
void to_json(Json& json, const Outcome& outcome);
void to_json(Json& json, const LayoutReport& layout);
void to_json(Json& json, const MoreFigures& more);
void to_json(Json& json, const MeasuredPatch& patch);
/// A point of a frontier: its run, and the figures of a candidate.
Json point_of(const Candidate& candidate);
Json to_json(std::span<const Caution> cautions, Unit unit);
/// "strain" and "limits" of a measured patch: null and empty where it cannot be laid flat.
Json strain_and_limits(const std::optional<StrainAsDesigned>& strain);

}  // namespace planish
