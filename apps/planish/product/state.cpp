#include "product/state.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>

#include <planish/core/version.h>
#include <planish/io/read_mesh.h>

#include <planish_json/json.h>

#include "core/fnv_hash.h"
#include "platform/path.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char* k_job_file = "job.json";

/// Flags that do not change the results of a patch. Those of seams act through its notches, which
/// are compared on their own.
constexpr std::array<std::string_view, 12> k_idle_flags = {
    "--output", "--threads",  "--quiet",       "--json", "--resume",         "--require-target",
    "--sheet",  "--nest-gap", "--nest-margin", "--turn", "--seam-tolerance", "--seam-notches"};

template <class Value>
void add_value(FnvHash& hash, const Value& value) {
  std::array<char, sizeof(Value)> bytes{};
  std::memcpy(bytes.data(), &value, sizeof(Value));
  hash.add({bytes.data(), bytes.size()});
}

std::string hash_of(std::string_view bytes) {
  FnvHash hash;
  hash.add(bytes);
  return hash_text(hash.value());
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

Json to_json(const std::vector<Notch>& notches) {
  Json list = Json::array();
  for (const Notch& notch : notches) {
    const auto& place = std::get<PlaceOnEdge>(notch.place);  // as all on seams are
    list.push_back(
        {place.from, place.to, place.share, std::string(to_string(notch.kind)), notch.is_double});
  }
  return list;
}

std::string text_of(const Json& json) {
  return json_text(json) + "\n";
}

std::optional<std::string> content_of(const fs::path& path) {
  std::error_code none;
  // What stands there may be anybody's: nothing that has no end or is elsewhere.
  if (!fs::is_regular_file(fs::symlink_status(path, none))) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::string content{std::istreambuf_iterator<char>(file), {}};
  return file.bad() ? std::nullopt : std::optional(std::move(content));
}

/// What a file says in JSON; null where it says nothing of the kind.
Json json_in(const fs::path& path) {
  const auto content = content_of(path);
  Json json = content ? parse_shallow(*content) : Json(nullptr);
  return json.is_object() ? json : Json(nullptr);
}

bool are_as_written(const Json& files, const fs::path& folder) {
  if (!files.is_object() || files.empty()) return false;
  for (const auto& [name, hash] : files.items()) {
    const fs::path file = path_of(name);
    if (file.filename() != file) return false;
    const auto content = content_of(folder / file);
    if (!content || !hash.is_string() || hash != hash_of(*content)) return false;
  }
  return true;
}

bool are_limits(const Json& limits) {
  return limits.is_array() && std::all_of(limits.begin(), limits.end(), [](const Json& limit) {
           return limit.at("kept").is_boolean();
         });
}

bool is_twin(const Json& twin) {
  return twin.at("of").is_string() && twin.at("mirrored").is_boolean();
}

/// Whether the text is a report with all values that product/text.h prints for a patch.
bool is_report(const std::string& text) try {
  const Json report = parse_shallow(text);
  const Json& unfold = report.at("unfold");
  const Json& evolve = report.at("evolve");
  return unfold.at("width").is_number() && unfold.at("height").is_number() &&
         unfold.at("unit").is_string() && unfold.at("overlaps").is_boolean() &&
         unfold.at("strain").at("rms").is_number() && unfold.at("strain").at("max").is_number() &&
         evolve.at("stop").is_string() && evolve.at("deviation").is_object() &&
         report.at("files").is_object() && are_limits(report.at("limits")) &&
         (!report.contains("twin") || is_twin(report.at("twin")));
} catch (const Json::exception&) {
  return false;
}

/// @pre is_report()
bool is_of_twin(const std::string& text) {
  return parse_shallow(text).contains("twin");
}

std::vector<Vec2> in_the_plane(const std::vector<Vec3>& positions) {
  std::vector<Vec2> pattern;
  pattern.reserve(positions.size());
  for (const Vec3& p : positions)
    pattern.push_back({p.x, p.y});
  return pattern;
}

}  // namespace

std::string job_of(const ProductPatch& patch, const PatternOptions& annotations,
                   const Arguments& arguments, const ProductPatch* twin_of) {
  Json flags = Json::object();
  for (const auto& [flag, value] : arguments.flags) {
    if (std::find(k_idle_flags.begin(), k_idle_flags.end(), flag) == k_idle_flags.end()) {
      flags[flag] = value;
    }
  }
  Json job = {{"version", k_version},
              {"name", patch.name},
              {"format", to_string(patch.format)},
              {"mesh", hash_of(patch.mesh)},
              {"notches", to_json(annotations.notches)},
              {"flags", std::move(flags)}};
  if (twin_of != nullptr)
    job["twin_of"] = {{"name", twin_of->name}, {"mesh", hash_of(twin_of->mesh)}};
  return text_of(job);
}

OutputFile job_file(const std::string& job, const std::vector<OutputFile>& files,
                    const fs::path& folder) {
  Json json = Json::parse(job);
  json["files"] = Json::object();
  for (const OutputFile& file : files) {
    json["files"][utf8_of(file.path.lexically_relative(folder))] = hash_of(file.content);
  }
  return {folder / k_job_file, text_of(json)};
}

std::optional<PatchResults> finished_results(const std::string& job, const fs::path& folder) {
  Json found = json_in(folder / k_job_file);
  if (found.is_null() || !found.contains("files")) return std::nullopt;
  const Json files = std::move(found["files"]);
  found.erase("files");
  if (text_of(found) != job || !are_as_written(files, folder)) return std::nullopt;
  const auto report = content_of(folder / "report.json");
  const auto format = std::find_if(k_mesh_formats.begin(), k_mesh_formats.end(), [&](MeshFormat f) {
    return files.contains("flat." + std::string(to_string(f)));
  });
  if (!report || !is_report(*report)) return std::nullopt;
  if (format == k_mesh_formats.end()) return std::nullopt;
  try {
    const std::string extension = "." + std::string(to_string(*format));
    const auto mesh_in = [&](const std::string& name) {
      return read_mesh(folder / path_of(name + extension)).mesh;
    };
    TriMesh processed = mesh_in("processed");
    const TriMesh flat = mesh_in("flat");
    if (processed.positions.size() != flat.positions.size()) return std::nullopt;
    return PatchResults{*report, std::move(processed), in_the_plane(flat.positions),
                        is_of_twin(*report)};
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace planish::cli
