#include "product/state.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <utility>

#include <planish/core/version.h>
#include <planish/io/read_mesh.h>

#include <planish_json/json.h>

#include "core/fnv_hash.h"
#include "flags/limit_flags.h"
#include "flags/material_flag.h"
#include "output/kept_files.h"
#include "platform/path.h"
#include "product/figures.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char* k_job_file = "job.json";

/// Flags that do not change the results of a patch. Those of seams act through its notches and what
/// is sewn, which are compared on their own.
constexpr std::array<std::string_view, 17> k_idle_flags = {
    "--output",         "--threads",      "--quiet",    "--json",        "--resume",
    "--require-target", "--sheet",        "--nest-gap", "--nest-margin", "--turn",
    "--seam-tolerance", "--seam-notches", "--product",  "--open",        "--piece",
    "--folded-cloth",   "--nest-in-holes"};

template <class Value>
void add_value(FnvHash& hash, const Value& value) {
  std::array<char, sizeof(Value)> bytes{};
  std::memcpy(bytes.data(), &value, sizeof(Value));
  hash.add({bytes.data(), bytes.size()});
}

std::string hash_of(const TriMesh& mesh) {
  FnvHash hash;
  add_value(hash, mesh.positions.size());
  for (const Vec3& p : mesh.positions)
    add_value(hash, p);
  for (const Triangle& t : mesh.triangles)
    add_value(hash, t);
  return hash_text(hash.value());
}

std::string hash_of(const SewnBorder& border) {
  FnvHash hash;
  add_value(hash, border.has_seams);
  for (const std::array<Index, 2>& edge : border.free_edges)
    add_value(hash, edge);
  for (const EdgeLength& edge : border.lengths) {
    add_value(hash, edge.edge);
    add_value(hash, edge.length);
  }
  return hash_text(hash.value());
}

Json to_json(const std::vector<Notch>& notches) {
  Json list = Json::array();
  for (const Notch& notch : notches) {
    const auto [from, to] = notch.edge.value_or(std::array<Index, 2>{});
    list.push_back({from, to, notch.fraction, std::string(to_string(notch.kind)), notch.is_double});
  }
  return list;
}

Json to_json(const std::vector<SeamNumber>& numbers) {
  Json list = Json::array();
  for (const SeamNumber& seam : numbers)
    list.push_back({seam.number, seam.vertex, seam.partner, static_cast<int>(seam.end)});
  return list;
}

Json to_json(const PatchJob& job) {
  Json flags = Json::object();
  for (const auto& [flag, value] : job.flags)
    flags[flag] = value;
  Json json = {{"version", k_version},
               {"name", job.name},
               {"format", to_string(job.format)},
               {"mesh", job.mesh},
               {"border", job.border},
               {"notches", to_json(job.notches)},
               {"seam_numbers", to_json(job.seam_numbers)},
               {"flags", std::move(flags)}};
  if (job.twin_of) json["twin_of"] = {{"name", job.twin_of->name}, {"mesh", job.twin_of->mesh}};
  return json;
}

std::string text_of(const Json& json) {
  return json_text(json) + "\n";
}

std::string text_of(const StrainLimits& limits) {
  std::string text;
  for (const LimitCheck& check : check_limits(EdgeStrain{}, limits))
    text += (text.empty() ? "" : ", ") + std::string(figure_name(check.what)) + " " +
            shortest(check.limit);
  return text;
}

std::vector<Vec2> in_the_plane(const std::vector<Vec3>& positions) {
  std::vector<Vec2> pattern;
  pattern.reserve(positions.size());
  for (const Vec3& p : positions)
    pattern.push_back({p.x, p.y});
  return pattern;
}

/// The format that the meshes of a folder are in.
std::optional<MeshFormat> format_among(const Json& files) {
  for (const MeshFormat format : k_mesh_formats) {
    if (files.contains("flat." + std::string(to_string(format)))) return format;
  }
  return std::nullopt;
}

}  // namespace

PatchJob job_of(const ProductPatch& patch, MeshFormat format, const PatternOptions& annotations,
                const SewnBorder& border, const Arguments& arguments, const ProductPatch* twin_of,
                const std::map<std::string, std::string>& settings) {
  PatchJob job{patch.name,          format,
               hash_of(patch.mesh), hash_of(border),
               annotations.notches, annotations.seam_numbers};
  for (const auto& [flag, value] : arguments.flags) {
    if (std::find(k_idle_flags.begin(), k_idle_flags.end(), flag) == k_idle_flags.end()) {
      job.flags[flag] = arguments.text(flag);
    }
  }
  if (!arguments.has("--unit") && arguments.stated_unit)
    job.flags["--unit"] = to_string(*arguments.stated_unit);
  // What a product file says. No flag is called so.
  for (const auto& [key, value] : settings)
    if (key != "turn") job.flags["piece " + key] = value;
  if (!patch.words.material.empty()) job.flags["material"] = patch.words.material;
  if (patch.limits) job.flags["limits"] = text_of(*patch.limits);
  // What a file of a material says now, wherever it lies.
  if (arguments.has("--material")) {
    job.flags["--material"] = material_name_from(arguments);
    job.flags["limits"] = text_of(patch.limits.value_or(limits_from(arguments)));
  }
  if (patch.words.quantity > 0) job.flags["quantity"] = std::to_string(patch.words.quantity);
  if (twin_of != nullptr) job.twin_of = {twin_of->name, hash_of(twin_of->mesh)};
  return job;
}

OutputFile job_file(const PatchJob& job, const FinishedPatch& results,
                    const std::vector<OutputFile>& files, const fs::path& folder) {
  Json json = to_json(job);
  json["figures"] = figures_json(results);
  json["files"] = Json::object();
  for (const OutputFile& file : files) {
    json["files"][utf8_of(file.path.lexically_relative(folder))] = content_hash(file.content);
  }
  return {folder / k_job_file, text_of(json)};
}

std::optional<FinishedPatch> finished_results(const PatchJob& job, const fs::path& folder) {
  Json found = kept_json(folder / k_job_file);
  if (found.is_null() || !found.contains("files") || !found.contains("figures"))
    return std::nullopt;
  const Json files = std::move(found["files"]);
  const Json figures = std::move(found["figures"]);
  found.erase("files");
  found.erase("figures");
  if (text_of(found) != text_of(to_json(job)) || !are_as_written(files, folder))
    return std::nullopt;
  const auto format = format_among(files);
  std::optional<FinishedPatch> results = patch_of_figures(figures);
  if (!results || !format || !files.contains("report.json")) return std::nullopt;
  try {
    const std::string extension = "." + std::string(to_string(*format));
    const auto mesh_in = [&](const std::string& name) {
      return read_mesh(folder / path_of(name + extension)).mesh;
    };
    results->processed = mesh_in("processed");
    results->unfold.pattern.positions = in_the_plane(mesh_in("flat").positions);
  } catch (const Error&) {
    return std::nullopt;
  }
  const bool is_whole =
      results->processed.positions.size() == results->unfold.pattern.positions.size();
  return is_whole ? std::move(results) : std::nullopt;
}

}  // namespace planish::cli
