#include "model/project_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include <planish_json/json.h>

#include "flags/units.h"
#include "model/material_file.h"
#include "model/project_file.h"
#include "model/sha256.h"
#include "platform/path.h"
#include "shell/file_name.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

/// The numbers of "1,2,3", or nothing.
std::optional<Json> point_of(const std::string& word) {
  Json point = Json::array();
  std::istringstream stream(word);
  for (std::string part; std::getline(stream, part, ',');) {
    const auto number = field_number(Field(part));
    if (!number || !std::isfinite(*number)) return std::nullopt;
    point.push_back(*number);
  }
  if (point.size() != 3) return std::nullopt;
  return point;
}

/// The points of a value "line 0,0,1 0,1,1" of --cut, or nothing.
std::optional<Json> line_of(const std::string& value) {
  std::istringstream stream(value);
  std::string word;
  Json points = Json::array();
  for (stream >> word; word == "line" && stream >> word; word = "line") {
    const auto point = point_of(word);
    if (!point) return std::nullopt;
    points.push_back(*point);
  }
  if (points.size() < 2) return std::nullopt;
  return points;
}

/// The points that the statements "l" or "p" of a drawing list, each in its order.
std::vector<Json> lists_in(const std::string& drawing) {
  std::vector<Json> vertices, lists;
  std::istringstream rows(drawing);
  for (std::string row; std::getline(rows, row);) {
    std::istringstream words(row);
    std::string kind, word;
    words >> kind;
    Json numbers = Json::array();
    while (words >> word) {
      const double number = *field_number(Field(word));
      numbers.push_back(kind == "v" ? Json(number)
                                    : vertices.at(static_cast<std::size_t>(number) - 1));
    }
    (kind == "v" ? vertices : lists).push_back(std::move(numbers));
  }
  return lists;
}

/// Takes flag by flag into the project. What it has no place for is listed.
class ProjectWriter {
 public:
  explicit ProjectWriter(const Arguments& arguments) : arguments_(arguments) {}

  /// @param operands names and hashes of the model's files, the first one of the model
  PageProject written(Json files) {
    json_["kind"] = k_project_kind;
    json_["version"] = k_project_version;
    json_.update(files.front());
    files.erase(0);
    if (!files.empty()) json_["parts"] = std::move(files);
    json_["unit"] = arguments_.stated_unit && !arguments_.has("--unit")
                        ? ""
                        : std::string(to_string(unit_from(arguments_)));
    for (const char* key : {"material", "strain", "allowance", "paper", "symmetric", "grain"})
      json_[key] = "";
    for (const char* key : {"lines", "without", "notches"})
      json_[key] = Json::array();
    json_["names"] = Json::object();
    std::vector<std::string> left_out;
    for (const auto& [flag, fields] : arguments_.flags) {
      if (!takes(flag, fields)) left_out.push_back(flag);
    }
    const std::string name = stem_of(json_["model"].get<std::string>()) + ".planish.json";
    return {name, json_text(json_, 1), std::move(left_out)};
  }

 private:
  bool takes(const std::string& flag, const std::vector<Field>& fields) {
    // What changes no pattern, and what a project says in other words.
    constexpr std::array<std::string_view, 11> without_place = {
        "--json", "--quiet",  "--open",    "--resume",   "--threads", "--output",
        "--unit", "--colors", "--formats", "--textured", "--product"};
    if (std::find(without_place.begin(), without_place.end(), flag) != without_place.end())
      return true;
    static const std::map<std::string, const char*, std::less<>> texts = {
        {"--material", "material"},
        {"--max-strain", "strain"},
        {"--allowance", "allowance"},
        {"--paper", "paper"}};
    if (const auto found = texts.find(flag);
        found != texts.end() && !is_material_file(arguments_.text(flag))) {
      json_[found->second] = arguments_.text(flag);
      return true;
    }
    if (flag == "--cut") return takes_lines(fields);
    if (flag == "--seam-notches") return takes_notches();
    if (flag == "--grain") return takes_grain();
    if (flag == "--symmetric" || flag == "--mirror-surface") return takes_symmetry();
    if (flag == "--without") return takes_names_out(flag);
    return flag == "--rename" && takes_new_names(flag);
  }

  bool takes_lines(const std::vector<Field>& values) {
    Json& lines = json_["lines"];
    bool are_all = true;
    for (const Field& value : values) {
      const std::string text = field_text(value);
      const auto drawn = arguments_.files.find(text);
      if (drawn != arguments_.files.end()) {
        for (Json& points : lists_in(drawn->second))
          lines.push_back({{"kind", "drawn"}, {"points", std::move(points)}});
      } else if (auto points = line_of(text)) {
        lines.push_back({{"kind", "shortest"}, {"points", std::move(*points)}});
      } else {
        are_all = false;
      }
    }
    return are_all;
  }

  bool takes_notches() {
    const auto drawn = arguments_.files.find(arguments_.text("--seam-notches"));
    if (drawn == arguments_.files.end()) return false;
    json_["notches"] = lists_in(drawn->second).front();
    return true;
  }

  /// A direction on the model; no angle.
  bool takes_grain() {
    const auto way = point_of(arguments_.text("--grain"));
    if (!way) return false;
    std::string text;
    for (const Json& x : *way)
      text += (text.empty() ? "" : ",") + field_text(Field(x.get<double>()));
    json_["grain"] = text;
    return true;
  }

  /// A plane that is named goes with half of the surface taken for both.
  bool takes_symmetry() {
    const std::string plane = arguments_.text("--symmetric");
    if ((plane == "auto") == arguments_.has("--mirror-surface")) return false;
    json_["symmetric"] = plane;
    return true;
  }

  bool takes_names_out(const std::string& flag) {
    for (const Field& name : arguments_.fields(flag))
      json_["without"].push_back(field_text(name));
    return true;
  }

  bool takes_new_names(const std::string& flag) {
    for (const Field& pair : arguments_.fields(flag)) {
      const std::string text = field_text(pair);
      const std::size_t middle = text.find('=');
      if (middle == std::string::npos) return false;
      json_["names"][text.substr(0, middle)] = text.substr(middle + 1);
    }
    return true;
  }

  const Arguments& arguments_;
  Json json_;
};

/// Name and hash of a file; nothing where it is none of a model.
std::optional<Json> file_of(const std::string& path) {
  std::error_code ignored;
  if (lower_extension(path) == ".json" || !fs::is_regular_file(path_of(path), ignored))
    return std::nullopt;
  std::ifstream stream(path_of(path), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) return std::nullopt;
  return Json{{"model", utf8_of(path_of(path).filename())}, {"hash", sha256(bytes)}};
}

}  // namespace

PageProject project_of(const Arguments& arguments) {
  if (arguments.operands.size() > 1 && !arguments.has("--product")) return {};
  Json files = Json::array();
  for (const std::string& path : arguments.operands) {
    auto file = file_of(path);
    if (!file) return {};
    files.push_back(std::move(*file));
  }
  return ProjectWriter(arguments).written(std::move(files));
}

}  // namespace planish::cli
