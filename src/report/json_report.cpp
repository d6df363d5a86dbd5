#include <cmath>
#include <type_traits>

#include <planish/core/version.h>
#include <planish/core/ways_on.h>
#include <planish/report/json_report.h>

#include <planish_json/json.h>

#include "report/enumerator_name.h"
#include "report/json_parts.h"
#include "report/several_files.h"

namespace planish {

namespace {

Json to_json(const MoreFigures& more) {
  Json json = Json::object();
  for (const auto& [name, figure] : more.figures)
    json[name] = std::visit([](auto value) { return Json(value); }, figure);
  return json;
}

std::string document_of(Json json, const std::vector<MoreFigures>& more = {}) {
  for (const MoreFigures& some : more)
    json[some.key] = to_json(some);
  return json_document(json) + '\n';
}

Json to_json(const LevelRecord& level) {
  return {{"inner_vertices", level.inner_vertices},
          {"merit_before", level.merit_before},
          {"merit", level.merit},
          {"strain", level.strain}};
}

Json to_json(const std::vector<SweepRecord>& history) {
  Json list = Json::array();
  for (const SweepRecord& record : history) {
    Json json = {{"sweep", record.sweep},   {"e_max", record.e_max}, {"e_avg", record.e_avg},
                 {"energy", record.energy}, {"moved", record.moved}, {"seconds", record.seconds}};
    if (record.level) json["level"] = to_json(*record.level);
    if (record.in_double) json["in_double"] = true;
    list.push_back(std::move(json));
  }
  return list;
}

Json to_json(const BorderFreedom& border) {
  if (border.rule == BorderFreedom::Rule::within) return border.distance;
  return enumerator_name(border.rule);
}

Json options_of(const std::optional<Method>& method) {
  Json options = Json::object();
  if (!method) return options;
  const auto add = [&](std::string_view name, const auto& value, auto&&...) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, BorderFreedom>) {
      options[std::string(name)] = to_json(value);
    } else if constexpr (std::is_enum_v<Value>) {
      options[std::string(name)] = enumerator_name(value);
    } else {
      options[std::string(name)] = value;
    }
  };
  std::visit([&](auto some) { describe(some, add); }, *method);
  return options;
}

Json to_json(const std::optional<OriginalSize>& size) {
  if (!size) return nullptr;
  return {{"vertices", size->vertices}, {"triangles", size->triangles}};
}

Json to_json(const BoundaryChange& border) {
  return {{"max", border.max},
          {"length_before", border.length_before},
          {"length_after", border.length_after}};
}

Json to_json(const std::optional<double>& figure) {
  return figure ? Json(*figure) : Json(nullptr);
}

Json to_json(const std::optional<Fold>& fold) {
  if (!fold) return nullptr;
  return {{"degrees", fold->degrees},
          {"edge", {fold->from, fold->to}},
          {"at", {fold->at.x, fold->at.y, fold->at.z}}};
}

Json to_json(const std::optional<FormChange>& change) {
  if (!change) return nullptr;
  const auto place = [](Vec3 at) { return Json{at.x, at.y, at.z}; };
  return {{"ripple", change->ripple},           {"fold", change->fold},
          {"fold_at", place(change->fold_at)},  {"dent", change->dent},
          {"dent_at", place(change->dent_at)},  {"uneven_turn", change->uneven_turn},
          {"relief_lost", change->relief_lost}, {"edge_lost", change->edge_lost}};
}

/// The figures of a result beside its design, but for the sharp share.
void add_fairness(const Fairness& fairness, Json& json) {
  json["bending_ratio"] = to_json(fairness.bending_ratio);
  json["bending_added"] = to_json(fairness.bending_added);
  json["bending_lost"] = to_json(fairness.bending_lost);
  json["normal_turn"] = to_json(fairness.normal_turn);
  json["border_turn"] = to_json(fairness.border_turn);
  json["sharpest_fold"] = to_json(fairness.sharpest_fold);
  json["form_change"] = to_json(fairness.form_change);
  json["smooth"] = fairness.is_smooth();
  json["form_kept"] = fairness.keeps_form();
}

}  // namespace

Json to_json(const EvolveReport& report) {
  Json after = to_json(report.after);
  after["sharp_share"] = report.fairness.sharp_share;
  Json json = {
      {"method", report.method_name()},           {"options", options_of(report.method)},
      {"sweeps", report.result.history.size()},   {"stop", to_string(report.result.stop)},
      {"threads", report.result.threads},         {"seconds", report.result.seconds},
      {"before", to_json(report.before)},         {"after", std::move(after)},
      {"deviation", to_json(report.deviation)},   {"remeshed_from", to_json(report.remeshed_from)},
      {"history", to_json(report.result.history)}};
  add_fairness(report.fairness, json);
  if (report.border) json["border"] = to_json(*report.border);
  if (const auto& smoothed = report.smoothed_first)
    json["smoothed_first"] = {{"length", smoothed->length}, {"moved", to_json(smoothed->moved)}};
  return json;
}

namespace {

Json to_json(const std::optional<UnfoldReport>& report) {
  return report ? to_json(*report) : Json(nullptr);
}

Json to_json(const CompareReport& report, const ComparedMethod& method) {
  Json json = method.evolve ? to_json(*method.evolve)
                            : Json{{"method", name_of(method.run.method)},
                                   {"options", options_of(method.run.method)}};
  json["unfold"] = to_json(method.unfold);
  json["verdict"] = verdict_text(report, method);
  json["error"] = nullptr;
  if (method.failure) json["error"] = to_json(*method.failure);
  return json;
}

Json to_json(const Candidate& candidate) {
  Json json = {{"name", candidate_name(candidate)},
               {"pick", candidate.pick ? Json(*candidate.pick) : Json(nullptr)},
               {"strain", to_json(candidate.strain)},
               {"limits_kept", candidate.limits_kept},
               {"deviation", to_json(candidate.deviation)},
               {"flattenable", candidate.flattenable},
               {"sharp_share", candidate.fairness.sharp_share}};
  add_fairness(candidate.fairness, json);
  return json;
}

/// Lengths in millimetres.
Json to_json(const Way& way, Unit unit) {
  const double scale = millimetres_per(unit);
  Json json = {
      {"estimated", way.estimated},
      {"reached", way.reached},
      {"strain", to_json(way.strain)},
      {"deviation", {{"rms", scale * way.deviation.rms}, {"max", scale * way.deviation.max}}},
      {"folds", way.sharpest_fold()},
      {"form_kept", way.keeps_form()}};
  if (!way.material.empty()) json["material"] = way.material;
  json["limit"] = way.limit();
  json["kind"] = way.limits.rms > 0.0 ? "rms" : way.limits.max > 0.0 ? "max" : "p99";
  return json;
}

Json to_json(const std::vector<Way>& ways, Unit unit) {
  Json list = Json::array();
  for (const Way& way : ways)
    list.push_back(to_json(way, unit));
  return list;
}

/// Those of a run, the result marked.
Json to_json(const std::vector<Candidate>& candidates) {
  Json list = Json::array();
  for (const Candidate& candidate : candidates) {
    Json json = to_json(candidate);
    json["result"] = &candidate == &candidates.back();
    list.push_back(std::move(json));
  }
  return list;
}

Json points_of(const std::vector<Candidate>& candidates) {
  Json list = Json::array();
  for (const Candidate& candidate : candidates) {
    Json json = {{"method", name_of(candidate.method)}, {"options", options_of(candidate.method)},
                 {"sweeps", candidate.sweeps},          {"stop", to_string(candidate.stop)},
                 {"seconds", candidate.seconds},        {"dominated", candidate.dominated}};
    json.update(to_json(candidate));
    list.push_back(std::move(json));
  }
  return list;
}

Json limit_of(const FrontierReport& report) {
  if (!report.limit) return nullptr;
  const auto first = report.first_within_limit();
  return {{"max_strain", *report.limit},
          {"kind", report.limit_of_area ? "p99" : "max"},
          {"first_within", first ? Json(*first) : Json(nullptr)}};
}

}  // namespace

std::string json_report(const MeasuredPatch& patch, const std::optional<StrainAsDesigned>& strain,
                        const std::vector<Caution>& cautions, Unit unit,
                        const std::vector<MoreFigures>& more) {
  return document_of(measured_figures(patch, strain, cautions, unit), more);
}

std::string json_report(const EvolveReport& report, const std::vector<Caution>& cautions, Unit unit,
                        const std::vector<MoreFigures>& more) {
  return document_of(evolved_figures(report, cautions, unit), more);
}

std::string json_report(const UnfoldReport& report, const std::vector<Caution>& cautions,
                        const std::vector<MoreFigures>& more) {
  return document_of(unfolded_figures(report, cautions), more);
}

std::string json_report(const FlattenReport& report, const WrittenFiles& files,
                        const std::vector<MoreFigures>& more,
                        const std::optional<LayoutReport>& layout) {
  Json json = {{"name", report.name},
               {"version", k_version},
               {"evolve", to_json(report.evolve)},
               {"unfold", to_json(report.unfold)},
               {"unfold_before", to_json(report.unfold_before)},
               {"as_designed", to_json(report.as_designed)},
               {"limits", to_json(report.unfold.limits)},
               {"candidates", to_json(report.candidates())},
               {"ways", to_json(report.ways, report.unfold.unit)},
               {"cautions", to_json(report.cautions, report.unfold.unit)},
               {"files", Json(files)}};
  json.update(to_json(report.outcome()));
  if (report.rejected) json["rejected_strain"] = to_json(*report.rejected);
  if (report.twin_of) json["twin"] = to_json(*report.twin_of);
  for (const MoreFigures& some : more)
    json[some.key] = to_json(some);
  if (layout) json["nesting"] = to_json(*layout);
  return document_of(json);
}

Json to_json(const CompareReport& report) {
  Json runs = Json::array();
  for (const ComparedMethod& method : report.runs)
    runs.push_back(to_json(report, method));
  const auto best = best_run(report);
  return {{"name", report.name},
          {"version", k_version},
          {"input", to_json(report.before)},
          {"unfold_before", to_json(report.unfold_before)},
          {"best", best ? Json(name_of(report.runs[*best].run.method)) : Json(nullptr)},
          {"runs", std::move(runs)},
          {"cautions", to_json(report.cautions, report.unit)}};
}

std::string json_report(const CompareReport& report) {
  return document_of(to_json(report));
}

std::string json_report(const FrontierReport& report) {
  Json failures = Json::array();
  for (const FrontierFailure& failed : report.failures) {
    failures.push_back({{"method", name_of(failed.method)},
                        {"options", options_of(failed.method)},
                        {"error", to_json(failed.failure)}});
  }
  return document_of({{"name", report.name},
                      {"version", k_version},
                      {"unit", to_string(report.unit)},
                      {"strain_before", to_json(report.design.strain)},
                      {"design", to_json(report.design)},
                      {"limit", limit_of(report)},
                      {"curve", points_of(report.curve)},
                      {"others", points_of(report.others)},
                      {"failures", std::move(failures)},
                      {"cautions", to_json(report.cautions, report.unit)}});
}

std::string json_report(const Error& error) {
  const ErrorPlace& place = error.place();
  Json json = {{"code", to_string(error.code())},
               {"message", error.message() + ". " + std::string(way_on(error.code()))}};
  if (!place.path.empty()) json["path"] = place.path;
  if (place.line) json["line"] = *place.line;
  if (place.byte) json["byte"] = *place.byte;
  if (place.first) json["first"] = *place.first;
  if (place.count) json["count"] = *place.count;
  return document_of({{"error", std::move(json)}});
}

}  // namespace planish
