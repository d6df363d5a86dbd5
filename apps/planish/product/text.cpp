#include "product/text.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <planish/core/version.h>

#include <planish_json/json.h>

#include "flatten/twin_report.h"
#include "shell/file_name.h"
#include "shell/text.h"

namespace planish::cli {

namespace {

constexpr std::size_t k_name_width = 20;

Json seam_side(const ProductJob& job, const SeamSide& side, const std::optional<double>& length) {
  Json json = {{"patch", job.patches[side.patch].name},
               {"first_vertex", side.vertices.front()},
               {"last_vertex", side.vertices.back()},
               {"vertices", side.vertices.size()}};
  json["length"] = length ? Json(*length) : Json(nullptr);
  return json;
}

Json seam_entry(const ProductJob& job, const SeamLengths& seam, std::size_t number) {
  Json json = {{"number", number}, {"length_on_model", seam.on_model}};
  json["sides"] = {seam_side(job, seam.seam.sides[0], seam.in_pattern[0]),
                   seam_side(job, seam.seam.sides[1], seam.in_pattern[1])};
  const auto difference = seam.difference();
  json["difference"] = difference ? Json(*difference) : Json(nullptr);
  json["difference_share"] = difference ? Json(*difference / seam.on_model) : Json(nullptr);
  return json;
}

Json patch_entry(const ProductPatch& patch, const PatchOutcome& outcome) {
  Json json = {{"name", patch.name},
               {"folder", patch.folder},
               {"vertices", patch.mesh.positions.size()},
               {"triangles", patch.mesh.triangles.size()}};
  const Json report = Json::parse(outcome.report, nullptr, false);
  json["unfold"] = report.is_object() ? report["unfold"] : Json(nullptr);
  json["stop"] = report.is_object() ? report["evolve"]["stop"] : Json(nullptr);
  json["deviation"] = report.is_object() ? report["evolve"]["deviation"] : Json(nullptr);
  json["files"] = report.is_object() ? report["files"] : Json(nullptr);
  if (report.is_object() && report.contains("twin")) json["twin"] = report["twin"];
  json["error"] = nullptr;
  if (outcome.failure) {
    json["error"] = {{"code", outcome.failure->code}, {"message", outcome.failure->message}};
  }
  return json;
}

bool any_limit_is_missed(const Json& limits) {
  return std::any_of(limits.begin(), limits.end(),
                     [](const Json& limit) { return !limit["kept"].get<bool>(); });
}

/// A tick where all limits are kept, a cross where one is not.
std::string limits_mark(const Json& limits) {
  if (limits.empty()) return {};
  return any_limit_is_missed(limits) ? "  \u2717 limit" : "  \u2713 limit";
}

/// Whose mirror image it is, or what it is equal to; empty for all others.
std::string twin_words(const Json& report) {
  if (!report.contains("twin")) return {};
  const Json& twin = report["twin"];
  return "  " + twin_text({twin["of"].get<std::string>(), twin["mirrored"].get<bool>()});
}

/// A name cut to the width of its column.
std::string short_name(const std::string& name) {
  return name.size() <= k_name_width ? name : beginning(name, k_name_width - 1) + "~";
}

}  // namespace

std::optional<double> SeamLengths::difference() const {
  if (!in_pattern[0] || !in_pattern[1]) return std::nullopt;
  return std::abs(*in_pattern[0] - *in_pattern[1]);
}

std::vector<SeamLengths> measure_seams(const std::vector<PatchOutcome>& outcomes,
                                       std::vector<Seam> seams, Unit unit) {
  const double scale = millimetres_per(unit);
  std::vector<SeamLengths> measured;
  measured.reserve(seams.size());
  for (Seam& seam : seams) {
    SeamLengths lengths;
    const SeamSide& first = seam.sides[0];
    const std::vector<Vec3>& positions = outcomes[first.patch].mesh.positions;
    lengths.on_model = scale * length_of(first, std::span<const Vec3>(positions));
    for (std::size_t s = 0; s < 2; ++s) {
      const std::vector<Vec2>& pattern = outcomes[seam.sides[s].patch].pattern;
      if (pattern.empty()) continue;
      lengths.in_pattern[s] = scale * length_of(seam.sides[s], std::span<const Vec2>(pattern));
    }
    lengths.seam = std::move(seam);
    measured.push_back(std::move(lengths));
  }
  return measured;
}

std::string product_json(const ProductJob& job, const std::vector<PatchOutcome>& outcomes,
                         const std::vector<SeamLengths>& seams) {
  Json patches = Json::array(), list = Json::array();
  for (std::size_t p = 0; p < outcomes.size(); ++p)
    patches.push_back(patch_entry(job.patches[p], outcomes[p]));
  for (std::size_t s = 0; s < seams.size(); ++s)
    list.push_back(seam_entry(job, seams[s], s + 1));
  const Json json = {{"name", stem_of(job.path)},
                     {"version", k_version},
                     {"unit", to_string(job.options.unit)},
                     {"patches", std::move(patches)},
                     {"seams", std::move(list)}};
  return json_document(json) + "\n";
}

bool missed_target(const PatchOutcome& outcome) {
  const Json report = Json::parse(outcome.report, nullptr, false);
  return report.is_object() &&
         report["evolve"]["stop"] != std::string(to_string(StopReason::reached_target));
}

bool missed_limit(const PatchOutcome& outcome) {
  const Json report = Json::parse(outcome.report, nullptr, false);
  return report.is_object() && any_limit_is_missed(report["limits"]);
}

std::string patch_line(const ProductPatch& patch, const PatchOutcome& outcome) {
  const std::string name = left(short_name(patch.name), k_name_width) + " ";
  if (outcome.failure) return name + "failed: " + outcome.failure->message;
  const Json report = Json::parse(outcome.report, nullptr, false);
  if (!report.is_object()) return name + "not done";
  const Json& unfold = report["unfold"];
  return name + right(digits(unfold["width"].get<double>()), 7) + " x " +
         right(digits(unfold["height"].get<double>()), 7) + " " +
         unfold["unit"].get<std::string>() + "  strain rms " +
         right(percent(unfold["strain"]["rms"].get<double>()), 8) + ", largest " +
         right(percent(unfold["strain"]["max"].get<double>()), 8) + limits_mark(report["limits"]) +
         (unfold["overlaps"].get<bool>() ? "  overlaps itself" : "") + twin_words(report) +
         (outcome.resumed ? "  kept" : "");
}

std::string twins_text(const std::vector<PatchOutcome>& outcomes) {
  const auto count = std::count_if(outcomes.begin(), outcomes.end(),
                                   [](const PatchOutcome& outcome) { return outcome.is_twin; });
  if (count == 0) return {};
  return "\nOf " + std::to_string(outcomes.size()) + " patches " + std::to_string(count) +
         (count == 1 ? " is" : " are") + " made from another one, of the same shape or mirrored.\n";
}

std::string seams_text(const ProductJob& job, const std::vector<SeamLengths>& seams) {
  if (seams.empty()) return "\nNo two borders lie at the same places: there are no seams.\n";
  std::string text = "\nSeams, in mm:   model     pattern of both sides   difference\n";
  for (std::size_t s = 0; s < seams.size(); ++s) {
    const SeamLengths& seam = seams[s];
    const auto length = [](const std::optional<double>& value) {
      return right(value ? fixed(*value, 2) : "-", 11);
    };
    const auto difference = seam.difference();
    text += right(std::to_string(s + 1), 4) + "  " + right(fixed(seam.on_model, 2), 15) + " " +
            length(seam.in_pattern[0]) + " " + length(seam.in_pattern[1]) + "   " +
            (difference ? right(fixed(*difference, 2), 8) + "  " +
                              fixed(100.0 * *difference / seam.on_model, 3) + " %"
                        : right("-", 8)) +
            "\n      " + job.patches[seam.seam.sides[0].patch].name + " - " +
            job.patches[seam.seam.sides[1].patch].name + "\n";
  }
  return text;
}

}  // namespace planish::cli
