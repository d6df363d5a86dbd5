#include <utility>

#include <planish/core/version.h>

#include "flatten/product/piece_verdict.h"
#include "report/json_parts.h"

namespace planish {

namespace {

Json seam_side(const ProductReport& report, const MeasuredSeam& seam, std::size_t number) {
  const SeamSide& side = seam.seam.sides[number];
  return {{"patch", report.patches[side.patch].name},
          {"first_vertex", side.vertices.front()},
          {"last_vertex", side.vertices.back()},
          {"vertices", side.vertices.size()},
          {"length", seam.in_pattern[number]},
          {"first_share", side.first_share},
          {"last_share", side.last_share},
          {"length_on_model", seam.on_model[number]}};
}

/// 1 or 2.
Json side_number(const std::optional<std::size_t>& side) {
  return side ? Json(*side + 1) : Json(nullptr);
}

Json seam_entry(const ProductReport& report, const MeasuredSeam& seam, std::size_t number) {
  Json json = {{"number", number},
               {"name", seam.name.empty() ? Json(nullptr) : Json(seam.name)},
               {"length_on_model", seam.on_model[0]}};
  json["sides"] = {seam_side(report, seam, 0), seam_side(report, seam, 1)};
  const auto difference = seam.difference();
  json["difference"] = difference;
  json["difference_share"] = difference ? Json(*difference / seam.on_model[0]) : Json(nullptr);
  json["matched"] = seam.seam.is_curve() ? "curve" : "vertices";
  json["longer"] = side_number(seam.longer());
  json["difference_on_model"] = seam.difference_on_model();
  json["longer_on_model"] = side_number(seam.longer_on_model());
  return json;
}

Json checks_of(const PatchResult& patch) {
  Json checks = Json::array();
  for (const PieceCheck& check : piece_checks(patch))
    checks.push_back({{"what", to_string(check.what)}, {"met", check.met}, {"text", check.text}});
  return checks;
}

Json patch_entry(const PatchResult& patch, const std::string& folder, const WrittenFiles& files) {
  const auto& finished = patch.finished;
  Json json = {
      {"name", patch.name},
      {"folder", folder},
      {"source", patch.words.source.empty() ? Json(nullptr) : Json(patch.words.source)},
      {"material", patch.words.material.empty() ? Json(nullptr) : Json(patch.words.material)},
      {"quantity", patch.words.quantity == 0 ? Json(nullptr) : Json(patch.words.quantity)},
      {"vertices", patch.vertices},
      {"triangles", patch.triangles}};
  json["unfold"] = finished ? Json(finished->unfold) : Json(nullptr);
  json["stop"] = finished ? Json(to_string(finished->stop)) : Json(nullptr);
  json["deviation"] = finished ? Json(finished->deviation) : Json(nullptr);
  const Outcome outcome = patch.outcome();
  json["met"] = outcome.usable();
  json.update(Json(outcome));
  json["checks"] = checks_of(patch);
  json["rejected_strain"] = finished ? Json(finished->rejected) : Json(nullptr);
  json["files"] = finished ? Json(files) : Json(nullptr);
  if (finished && finished->twin_of) json["twin"] = *finished->twin_of;
  json["error"] = patch.failure;
  return json;
}

/// Where the pieces lie, in the order of nest().
Json placements_of(const std::vector<NestPlacement>& placements,
                   const std::vector<std::string>& names) {
  Json list = Json::array();
  for (const NestPlacement& placement : placements) {
    list.push_back({{"patch", names[placement.piece]},
                    {"copy", placement.copy + 1},
                    {"sheet", placement.sheet + 1},
                    {"angle", placement.angle},
                    {"x", placement.shift.x},
                    {"y", placement.shift.y}});
  }
  return list;
}

Json near_borders_of(const ProductReport& report) {
  Json list = Json::array();
  for (const NearBorders& near : report.near_borders) {
    list.push_back(
        {{"patches", {report.patches[near.patches[0]].name, report.patches[near.patches[1]].name}},
         {"length", near.length}});
  }
  return list;
}

}  // namespace

void add_layout(const std::string& material, const NestJob& job, const Nesting& nesting,
                LayoutReport& layout) {
  Nesting& all = layout.nesting;
  if (layout.materials.empty()) layout.sheets = job.sheets;
  layout.materials.push_back({material, job.sheets, all.sheets, nesting.sheets, nesting.used_length,
                              nesting.used_share()});
  for (NestPlacement placement : nesting.placements) {
    placement.piece += layout.names.size();
    placement.sheet += all.sheets;
    all.placements.push_back(placement);
  }
  all.sheets += nesting.sheets;
  all.used_length = nesting.used_length;
  all.piece_area += nesting.piece_area;
  all.sheet_area += nesting.sheet_area;
  for (const NestPatch& patch : job.patches)
    layout.names.push_back(patch.name);
}

Json materials_of(const std::vector<MaterialLayout>& materials) {
  Json list = Json::array();
  for (const MaterialLayout& some : materials) {
    list.push_back({{"material", some.material},
                    {"sheet_width", some.sheets.width},
                    {"sheet_length", some.sheets.length},
                    {"first_sheet", some.first + 1},
                    {"sheets", some.count},
                    {"used_length", some.used_length},
                    {"used_share", some.used_share}});
  }
  return list;
}

void to_json(Json& json, const LayoutReport& layout) {
  const NestOptions& sheets = layout.sheets;
  json = {{"sheet_width", sheets.width},
          {"sheet_length", sheets.length},
          {"gap", sheets.gap},
          {"margin", sheets.margin},
          {"folded", sheets.folded},
          {"in_holes", sheets.in_holes},
          {"turn", to_string(sheets.turns)}};
  if (layout.failure) {
    json["error"] = *layout.failure;
    return;
  }
  json["sheets"] = layout.nesting.sheets;
  json["used_length"] = layout.nesting.used_length;
  json["used_share"] = layout.nesting.used_share();
  json["waste"] = 1.0 - layout.nesting.used_share();
  json["materials"] = materials_of(layout.materials);
  json["left_out"] = layout.left_out;
  json["files"] = layout.files;
  json["placements"] = placements_of(layout.nesting.placements, layout.names);
  json["error"] = nullptr;
}

std::string json_report(const ProductReport& report, const std::string& name,
                        const ProductFiles& files, const std::optional<LayoutReport>& layout,
                        const std::optional<MoreFigures>& cut) {
  Json patches = Json::array(), seams = Json::array();
  for (std::size_t p = 0; p < report.patches.size(); ++p)
    patches.push_back(patch_entry(report.patches[p], files.folders[p], files.files[p]));
  for (std::size_t s = 0; s < report.seams.size(); ++s)
    seams.push_back(seam_entry(report, report.seams[s], s + 1));
  const Json json = {{"name", name},
                     {"version", k_version},
                     {"unit", to_string(report.unit)},
                     {"verdict", product_verdict(report)},
                     {"patches", std::move(patches)},
                     {"seams", std::move(seams)},
                     {"near_borders", near_borders_of(report)},
                     {"nesting", layout},
                     {"cut", cut}};
  return json_document(json) + '\n';
}

}  // namespace planish
