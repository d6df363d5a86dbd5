#include "model/project_file.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <system_error>
#include <utility>

#include <planish/core/error.h>

#include "flags/units.h"
#include "model/json_file.h"
#include "model/sha256.h"
#include "platform/path.h"
#include "shell/file_name.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

// What the files are called that the flags of a project name, as in web/app/project.js.
constexpr const char* k_seams = "seams.obj";
constexpr const char* k_notches = "notches.obj";

/// In the shortest digits that read back to it.
std::string number_text(const Json& number) {
  return field_text(Field(number.get<double>()));
}

/// Lines or points over the model, as an .obj has them.
class Drawing {
 public:
  /// @param statement "l" of a line, "p" of points
  void add(const Json& points, const char* statement) {
    std::string line = statement;
    for (const Json& point : points) {
      text_ += "v";
      for (const Json& x : point)
        text_ += " " + number_text(x);
      text_ += "\n";
      line += " " + std::to_string(++count_);
    }
    text_ += line + "\n";
  }

  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::size_t count_ = 0;
};

/// Words of a project, checked.
class Project {
 public:
  explicit Project(const Json& json) : json_(json) {
    // First: one of another version has other keys.
    const Json version = json.value("version", Json());
    if (version != k_project_version) {
      refuse("version", "is " + version.dump().substr(0, 20) + "; this program reads version " +
                            std::to_string(k_project_version));
    }
    static const std::vector<std::string> keys = {
        "kind",     "version", "model",     "hash",  "unit",      "lines",   "names", "without",
        "material", "strain",  "allowance", "paper", "symmetric", "notches", "parts", "grain"};
    const JsonEntry strict(json, "", keys);
  }

  /// The text of a key; empty where there is none.
  std::string text(const std::string& key) const {
    const Json value = json_.value(key, Json(""));
    if (!value.is_string()) refuse(key, "must be a text in quotes");
    return one_line(value, key);
  }

  /// A file of the model, which lies beside the project.
  struct File {
    std::string name, hash;
  };

  /// The model's file, and where it is a product of several ones the others.
  std::vector<File> files() const {
    std::vector<File> all = {file(text("model"), text("hash"), "model")};
    const Json& parts = list("parts");
    for (std::size_t k = 0; k < parts.size(); ++k) {
      static const std::vector<std::string> keys = {"model", "hash"};
      const JsonEntry part(parts[k], "parts[" + std::to_string(k) + "]", keys);
      all.push_back(
          file(part.required_text("model"), part.text("hash").value_or(""), part.where("model")));
    }
    return all;
  }

  /// @param take gets the points of each line of the kind
  template <class Take>
  void for_lines(const char* how, const Take& take) const {
    const Json& lines = list("lines");
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const std::string where = "lines[" + std::to_string(k) + "]";
      static const std::vector<std::string> keys = {"kind", "points"};
      const JsonEntry line(lines[k], where, keys);
      const std::string kind = line.required_text("kind");
      if (kind != "shortest" && kind != "drawn")
        refuse(line.where("kind"), "must be \"shortest\" or \"drawn\"");
      const Json& points = line.required("points");
      check_points(points, line.where("points"), 2);
      if (kind == how) take(points);
    }
  }

  const Json& notches() const {
    const Json& points = list("notches");
    check_points(points, "notches", 0);
    return points;
  }

  std::vector<Field> without() const {
    std::vector<Field> names;
    for (const Json& name : list("without"))
      names.emplace_back(one_line(name, "without"));
    return names;
  }

  /// "OLD=NEW" of each piece with another name.
  std::vector<Field> renamed() const {
    const Json names = json_.value("names", Json::object());
    if (!names.is_object()) refuse("names", "must be an object: {...}");
    std::vector<Field> pairs;
    for (const auto& [old, name] : names.items()) {
      const std::string word = one_line(name, "names." + old);
      if (old.find('=') < old.size()) refuse("names." + old, "has a = in it");
      if (!word.empty() && word != old) pairs.emplace_back(old + "=" + word);
    }
    return pairs;
  }

 private:
  static File file(std::string name, std::string hash, const std::string& where) {
    if (name.empty() || name == "." || name == ".." || name.find_first_of("/\\:") < name.size())
      refuse(where, "must be the name of a file beside the project");
    return {std::move(name), std::move(hash)};
  }

  const Json& list(const std::string& key) const {
    static const Json none = Json::array();
    const auto found = json_.find(key);
    if (found == json_.end()) return none;
    if (!found->is_array()) refuse(key, "must be a list: [...]");
    return *found;
  }

  static std::string one_line(const Json& value, const std::string& where) {
    if (!value.is_string()) refuse(where, "must be a text in quotes");
    std::string text = value.get<std::string>();
    for (const char c : text) {
      if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
        refuse(where, "must be one line, without control characters");
    }
    return text;
  }

  static void check_points(const Json& points, const std::string& where, std::size_t least) {
    if (!points.is_array() || points.size() < least)
      refuse(where, "must be a list of " + std::to_string(least) + " points or more");
    for (const Json& point : points) {
      bool is_point = point.is_array() && point.size() == 3;
      for (std::size_t k = 0; is_point && k < 3; ++k)
        is_point = point[k].is_number() && std::isfinite(point[k].get<double>());
      if (!is_point) refuse(where, "must hold points of three numbers: [x, y, z]");
    }
  }

  const Json& json_;
};

std::string line_word(const Json& points) {
  std::string word = "line";
  for (const Json& point : points) {
    for (std::size_t k = 0; k < 3; ++k)
      word += (k == 0 ? " " : ",") + number_text(point[k]);
  }
  return word;
}

void take_lines(const Project& project, Arguments& arguments) {
  std::vector<Field> cuts;
  project.for_lines("shortest", [&](const Json& points) { cuts.emplace_back(line_word(points)); });
  Drawing drawing;
  project.for_lines("drawn", [&](const Json& points) { drawing.add(points, "l"); });
  if (!drawing.text().empty()) {
    cuts.emplace_back(k_seams);
    arguments.files[k_seams] = drawing.text();
  }
  if (cuts.empty()) return;
  std::vector<Field>& all = arguments.flags["--cut"];
  all.insert(all.begin(), cuts.begin(), cuts.end());
}

void take_notches(const Project& project, Arguments& arguments) {
  const Json& points = project.notches();
  if (points.empty() || arguments.has("--seam-notches")) return;
  Drawing drawing;
  drawing.add(points, "p");
  arguments.files[k_notches] = drawing.text();
  arguments.flags["--seam-notches"] = {k_notches};
}

void take_flags(const Project& project, Arguments& arguments) {
  constexpr std::array<std::pair<const char*, const char*>, 7> flags = {
      {{"--unit", "unit"},
       {"--symmetric", "symmetric"},
       {"--material", "material"},
       {"--max-strain", "strain"},
       {"--allowance", "allowance"},
       {"--paper", "paper"},
       {"--grain", "grain"}}};
  for (const auto& [flag, key] : flags) {
    const std::string value = project.text(key);
    if (value.empty() || arguments.has(flag)) continue;
    if (key == std::string_view("unit") && !unit_of_word(value))
      refuse(key, "is \"" + value + "\" but must be mm, cm, dm, m or in");
    arguments.flags[flag] = {value};
    // Where the plane is named, the model is not symmetric itself.
    if (key == std::string_view("symmetric") && value != "auto")
      arguments.flags["--mirror-surface"];
  }
  // All that the app offers for download.
  if (!arguments.has("--formats")) arguments.flags["--formats"] = {"svg,dxf,pdf,plt"};
  arguments.flags["--textured"];
  for (auto [flag, names] :
       {std::pair("--rename", project.renamed()), std::pair("--without", project.without())}) {
    if (!names.empty() && !arguments.has(flag)) arguments.flags[flag] = std::move(names);
  }
}

/// A file of a project's model, which has to be the one that its lines were drawn on.
std::string model_beside(const fs::path& project, const Project::File& file) {
  const auto& [name, hash] = file;
  const fs::path path = project.parent_path() / path_of(name);
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) {
    throw Error(ErrorCode::file_not_found,
                "the project is of the model " + name + ", which has to lie beside it");
  }
  if (hash.empty()) return utf8_of(path);
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (sha256(bytes) != hash) {
    throw Error(ErrorCode::malformed_file, "the project is of another " + name +
                                               " than the one beside it, where its lines would lie "
                                               "elsewhere");
  }
  return utf8_of(path);
}

/// What a JSON file holds, where it says that it is a project.
std::optional<Json> project_in(const std::string& path) {
  std::error_code ignored;
  if (lower_extension(path) != ".json" || !fs::is_regular_file(path_of(path), ignored))
    return std::nullopt;
  try {
    Json json = read_json_file(path, "a project file");
    if (json.is_object() && json.value("kind", Json()) == k_project_kind) return json;
  } catch (const Error&) {
    // A product file reports what is wrong with it itself.
  }
  return std::nullopt;
}

}  // namespace

Arguments with_project(const Command& command, Arguments arguments) {
  if (command.name != "flatten" || arguments.operands.size() != 1) return arguments;
  const std::string file = arguments.operands.front();
  const std::optional<Json> json = project_in(file);
  if (!json) return arguments;
  try {
    const Project project(*json);
    take_lines(project, arguments);
    take_notches(project, arguments);
    take_flags(project, arguments);
    const std::vector<Project::File> files = project.files();
    arguments.operands.clear();
    for (const Project::File& some : files)
      arguments.operands.push_back(model_beside(path_of(file), some));
    if (files.size() > 1) {
      arguments.flags["--product"];
      // Else the folder would have the name of one part.
      if (!arguments.has("--output")) arguments.flags["--output"] = {stem_of(file) + "-pattern"};
    }
  } catch (const Error& error) {
    throw Error(error.code(), error.message(), {.path = file});
  }
  return arguments;
}

}  // namespace planish::cli
