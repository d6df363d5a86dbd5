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

std::string document_of(Json json, const std::vector<MoreFigures>& more = {}) {
  for (const MoreFigures& some : more)
    json[some.key] = some;
  return json_document(json) + '\n';
}

Json freedom_of(const BorderFreedom& border) {
  if (border.rule == BorderFreedom::Rule::within) return border.distance;
  return enumerator_name(border.rule);
}

Json options_of(const std::optional<Method>& method) {
  Json options = Json::object();
  if (!method) return options;
  const auto add = [&](std::string_view name, const auto& value, auto&&...) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, BorderFreedom>) {
      options[std::string(name)] = freedom_of(value);
    } else if constexpr (std::is_enum_v<Value>) {
      options[std::string(name)] = enumerator_name(value);
    } else {
      options[std::string(name)] = value;
    }
  };
  std::visit([&](auto some) { describe(some, add); }, *method);
  return options;
}

}  // namespace

void to_json(Json& json, const MoreFigures& more) {
  json = Json::object();
  for (const auto& [name, figure] : more.figures)
    json[name] = std::visit([](auto value) { return Json(value); }, figure);
}

void to_json(Json& json, const LevelRecord& level) {
  json = {{"inner_vertices", level.inner_vertices},
          {"merit_before", level.merit_before},
          {"merit", level.merit},
          {"strain", level.strain}};
}

void to_json(Json& json, const SweepRecord& record) {
  json = {{"sweep", record.sweep},   {"e_max", record.e_max}, {"e_avg", record.e_avg},
          {"energy", record.energy}, {"moved", record.moved}, {"seconds", record.seconds}};
  if (record.level) json["level"] = *record.level;
  if (record.in_double) json["in_double"] = true;
}

void to_json(Json& json, const OriginalSize& size) {
  json = {{"vertices", size.vertices}, {"triangles", size.triangles}};
}

void to_json(Json& json, const BoundaryChange& border) {
  json = {{"max", border.max},
          {"length_before", border.length_before},
          {"length_after", border.length_after}};
}

void to_json(Json& json, const Fold& fold) {
  json = {{"degrees", fold.degrees}, {"edge", {fold.from, fold.to}}, {"at", fold.at}};
}

void to_json(Json& json, const FormChange& change) {
  json = {{"ripple", change.ripple},           {"fold", change.fold},
          {"fold_at", change.fold_at},         {"dent", change.dent},
          {"dent_at", change.dent_at},         {"uneven_turn", change.uneven_turn},
          {"relief_lost", change.relief_lost}, {"edge_lost", change.edge_lost}};
}

namespace {

/// The figures of a result beside its design, but for the sharp share.
void add_fairness(const Fairness& fairness, Json& json) {
  json["bending_ratio"] = fairness.bending_ratio;
  json["bending_added"] = fairness.bending_added;
  json["bending_lost"] = fairness.bending_lost;
  json["normal_turn"] = fairness.normal_turn;
  json["border_turn"] = fairness.border_turn;
  json["sharpest_fold"] = fairness.sharpest_fold;
  json["form_change"] = fairness.form_change;
  json["smooth"] = fairness.is_smooth();
  json["form_kept"] = fairness.keeps_form();
}

}  // namespace

void to_json(Json& json, const EvolveReport& report) {
  Json after = report.after;
  after["sharp_share"] = report.fairness.sharp_share;
  json = {{"method", report.method_name()},
          {"options", options_of(report.method)},
          {"sweeps", report.result.history.size()},
          {"stop", to_string(report.result.stop)},
          {"threads", report.result.threads},
          {"seconds", report.result.seconds},
          {"before", report.before},
          {"after", std::move(after)},
          {"deviation", report.deviation},
          {"remeshed_from", report.remeshed_from},
          {"history", report.result.history}};
  add_fairness(report.fairness, json);
  if (report.border) json["border"] = *report.border;
  if (const auto& smoothed = report.smoothed_first)
    json["smoothed_first"] = {{"length", smoothed->length}, {"moved", smoothed->moved}};
}

void to_json(Json& json, const Candidate& candidate) {
  json = {{"name", candidate_name(candidate)},
          {"pick", candidate.preset},
          {"strain", candidate.strain},
          {"limits_kept", candidate.limits_kept},
          {"deviation", candidate.deviation},
          {"flattenable", candidate.flattenable},
          {"sharp_share", candidate.fairness.sharp_share}};
  add_fairness(candidate.fairness, json);
}

namespace {

Json run_of(const CompareReport& report, const ComparedMethod& method) {
  Json json = {{"method", name_of(method.run.method)}, {"options", options_of(method.run.method)}};
  if (method.evolve) json = *method.evolve;
  json["unfold"] = method.unfold;
  json["verdict"] = verdict_text(report, method);
  json["error"] = method.failure;
  return json;
}

/// Lengths in millimetres.
Json way_of(const Way& way, Unit unit) {
  const double scale = millimetres_per(unit);
  Json json = {
      {"estimated", way.estimated},
      {"reached", way.reached},
      {"strain", way.strain},
      {"deviation", {{"rms", scale * way.deviation.rms}, {"max", scale * way.deviation.max}}},
      {"folds", way.sharpest_fold()},
      {"form_kept", way.keeps_form()}};
  if (!way.material.empty()) json["material"] = way.material;
  json["limit"] = way.limit();
  json["kind"] = way.limits.rms > 0.0 ? "rms" : way.limits.max > 0.0 ? "max" : "p99";
  return json;
}

Json ways_of(const std::vector<Way>& ways, Unit unit) {
  Json list = Json::array();
  for (const Way& way : ways)
    list.push_back(way_of(way, unit));
  return list;
}

/// Those of a run, the result marked.
Json marked(const std::vector<Candidate>& candidates) {
  Json list = candidates;
  for (Json& candidate : list)
    candidate["result"] = &candidate == &list.back();
  return list;
}

Json limit_of(const FrontierReport& report) {
  if (!report.limits.any()) return nullptr;
  return {{"max_strain", report.limits.both_ways()},
          {"kind", report.limits.p99 > 0.0 ? "p99" : "max"},
          {"first_within", report.first_within_limit()}};
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
               {"evolve", report.evolve},
               {"unfold", report.unfold},
               {"unfold_before", report.design_least_stretch},
               {"as_designed", report.design_pattern},
               {"limits", report.unfold.limits},
               {"candidates", marked(report.candidates())},
               {"ways", ways_of(report.ways, report.unfold.unit)},
               {"cautions", to_json(report.cautions, report.unfold.unit)},
               {"files", Json(files)}};
  json.update(Json(report.outcome()));
  if (report.rejected) json["rejected_strain"] = *report.rejected;
  if (report.twin_of) json["twin"] = *report.twin_of;
  for (const MoreFigures& some : more)
    json[some.key] = some;
  if (layout) json["nesting"] = *layout;
  return document_of(json);
}

void to_json(Json& json, const CompareReport& report) {
  Json runs = Json::array();
  for (const ComparedMethod& method : report.runs)
    runs.push_back(run_of(report, method));
  const auto best = best_run(report);
  json = {{"name", report.name},
          {"version", k_version},
          {"input", report.before},
          {"unfold_before", report.design_least_stretch},
          {"best", best ? Json(name_of(report.runs[*best].run.method)) : Json(nullptr)},
          {"runs", std::move(runs)},
          {"cautions", to_json(report.cautions, report.unit)}};
}

std::string json_report(const CompareReport& report) {
  return document_of(report);
}

Json point_of(const Candidate& candidate) {
  Json json = {{"method", name_of(candidate.method)}, {"options", options_of(candidate.method)},
               {"sweeps", candidate.sweeps},          {"stop", to_string(candidate.stop)},
               {"seconds", candidate.seconds},        {"dominated", candidate.dominated}};
  json.update(Json(candidate));
  return json;
}

std::string json_report(const FrontierReport& report) {
  const auto points = [](const std::vector<Candidate>& candidates) {
    Json list = Json::array();
    for (const Candidate& candidate : candidates)
      list.push_back(point_of(candidate));
    return list;
  };
  Json failures = Json::array();
  for (const FrontierFailure& failed : report.failures) {
    failures.push_back({{"method", name_of(failed.method)},
                        {"options", options_of(failed.method)},
                        {"error", failed.failure}});
  }
  return document_of({{"name", report.name},
                      {"version", k_version},
                      {"unit", to_string(report.unit)},
                      {"strain_before", report.design.strain},
                      {"design", report.design},
                      {"limit", limit_of(report)},
                      {"curve", points(report.curve)},
                      {"others", points(report.others)},
                      {"failures", std::move(failures)},
                      {"cautions", to_json(report.cautions, report.unit)}});
}

std::string json_report(const Error& error) {
  const SourceLocation& place = error.place();
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
