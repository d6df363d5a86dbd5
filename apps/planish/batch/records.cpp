#include "batch/records.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <planish/core/version.h>

#include "model/sha256.h"
#include "output/kept_files.h"
#include "platform/path.h"
#include "report/json_parts.h"
#include "shell/file_name.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

/// Flags that change nothing of what is made of an input.
constexpr std::array<std::string_view, 9> k_idle_flags = {
    "--output", "--threads", "--quiet", "--json",         "--resume",
    "--inputs", "--shard",   "--csv",   "--keep-failures"};

/// Keys of a record that identify the run: it is kept where they are the same.
constexpr std::array k_causes = {"version", "sha256", "options", "option_files"};

void add_file(const std::string& path, Json& files) {
  std::error_code ignored;
  if (path.empty() || !fs::is_regular_file(path_of(path), ignored)) return;
  if (const auto content = kept_content(fs::canonical(path_of(path), ignored)))
    files[path] = sha256(*content);
}

Json record_without_result(const ListedInput& input, const std::string& hash,
                           const ListSettings& settings) {
  return {{"schema", k_json_schema},
          {"version", k_version},
          {"number", input.number},
          {"of", settings.inputs},
          {"line", input.line == 0 ? Json(nullptr) : Json(input.line)},
          {"path", input.path},
          {"sha256", hash.empty() ? Json(nullptr) : Json(hash)},
          {"folder", input.folder},
          {"options", settings.options},
          {"option_files", settings.option_files},
          {"patch", nullptr},
          {"figures", nullptr},
          {"missed", Json::array()},
          {"notes", Json::array()},
          {"seconds", nullptr},
          {"exit", k_exit_failed},
          {"error", nullptr},
          {"kept", false}};
}

void add_result(const Json& report, int exit_code, Json& record) {
  record["patch"] = report.value("name", Json());
  record["figures"] = figures_in(flattened_columns(), report);
  record["missed"] = report.value("missed", Json::array());
  record["exit"] = exit_code;
}

/// Of a piece of an input of several, its figures are in the report of its own.
void add_piece(const Json& piece, Json& record) {
  record["patch"] = piece["name"];
  record["missed"] = piece.value("missed", Json::array());
  record["error"] = piece["error"];
  if (!piece["error"].is_null()) return;
  const std::string path = piece["files"].value("report_json", std::string());
  add_result(kept_json(path_of(path)),
             piece.value("usable", false) ? k_exit_done : k_exit_target_missed, record);
  record["patch"] = piece["name"];
}

/// Whether all that a table shows of it is what it should be: anybody may have written it.
bool is_record(const Json& json) {
  const auto are_plain = [](const Json& figures) {
    return std::all_of(figures.begin(), figures.end(),
                       [](const Json& figure) { return figure.is_primitive(); });
  };
  const auto is_failure = [](const Json& error) {
    return error.contains("code") && error["code"].is_string() && error.contains("message") &&
           error["message"].is_string();
  };
  const auto is_whole = [&](const char* key) {
    return json.contains(key) && json[key].is_number_unsigned();
  };
  const auto is_one_of = [&](const char* key, auto... types) {
    return json.contains(key) && ((json[key].type() == types) || ...);
  };
  using Type = Json::value_t;
  return json.is_object() && is_whole("number") && is_whole("of") && is_whole("exit") &&
         is_one_of("path", Type::string) && is_one_of("version", Type::string) &&
         is_one_of("sha256", Type::string, Type::null) &&
         is_one_of("patch", Type::string, Type::null) &&
         is_one_of("figures", Type::object, Type::null) && is_one_of("missed", Type::array) &&
         are_plain(json["figures"]) && is_one_of("error", Type::object, Type::null) &&
         (json["error"].is_null() || is_failure(json["error"]));
}

/// The records of a record file; none where it is not one.
std::vector<Json> records_in(const Json& file) {
  if (!file.is_object() || !file.contains("records") || !file["records"].is_array()) return {};
  const Json& records = file["records"];
  const bool are_records = std::all_of(records.begin(), records.end(), is_record);
  return are_records ? std::vector<Json>(records.begin(), records.end()) : std::vector<Json>();
}

std::vector<Json> records_of_lines(std::string_view text, const std::string& path) {
  std::vector<Json> records;
  for (std::size_t line = 1; text.find('\n') != std::string_view::npos; ++line) {
    const std::size_t end = text.find('\n');
    const std::string own(text.substr(0, end));
    text.remove_prefix(end + 1);
    if (own.find_first_not_of(" \t\r") == std::string::npos) continue;
    records.push_back(parse_shallow(own));
    if (!is_record(records.back())) {
      throw Error(ErrorCode::malformed_file, "is no record of planish flatten --inputs",
                  {.path = path, .line = line});
    }
  }
  return records;
}

std::vector<Column> record_columns() {
  std::vector<Column> columns = columns_of("sha256 patch");
  for (const Column& figure : flattened_columns())
    columns.push_back({figure.name, Json::json_pointer("/figures/" + figure.name)});
  for (Column& column : columns_of("missed exit"))
    columns.push_back(std::move(column));
  return columns;
}

std::string joined(const Json& words) {
  std::string text;
  for (const Json& word : words) {
    if (word.is_string()) text += (text.empty() ? "" : " ") + word.get<std::string>();
  }
  return text;
}

}  // namespace

ListSettings settings_of(const Arguments& arguments, std::size_t inputs) {
  ListSettings settings;
  settings.inputs = inputs;
  for (const auto& [flag, value] : arguments.flags) {
    if (std::find(k_idle_flags.begin(), k_idle_flags.end(), flag) != k_idle_flags.end()) continue;
    settings.options[flag] = arguments.text(flag);
    add_file(arguments.text(flag), settings.option_files);
    for (const Field& field : arguments.fields(flag))
      add_file(field_text(field), settings.option_files);
  }
  return settings;
}

std::vector<Json> records_of(const ListedInput& input, const InputOutcome& outcome,
                             const ListSettings& settings) {
  Json common = record_without_result(input, outcome.hash, settings);
  common["notes"] = outcome.notes;
  common["seconds"] = outcome.seconds;
  if (outcome.failure) {
    common["exit"] = outcome.result.exit_code;
    common["error"] = *outcome.failure;
    return {common};
  }
  const Json report = parse_shallow(outcome.result.json);
  if (!report.contains("patches")) {
    add_result(report, outcome.result.exit_code, common);
    return {common};
  }
  std::vector<Json> records;
  for (const Json& piece : report["patches"])
    add_piece(piece, records.emplace_back(common));
  return records;
}

OutputFile record_file(const std::vector<Json>& records, const fs::path& folder) {
  Json files = hashes_of_files(folder);
  files.erase(k_record_file);
  return {folder / k_record_file,
          json_document({{"records", records}, {"files", std::move(files)}}) + '\n'};
}

std::optional<std::vector<Json>> kept_records(const ListedInput& input, const std::string& hash,
                                              const ListSettings& settings,
                                              const fs::path& folder) {
  const Json file = kept_json(folder / k_record_file);
  std::vector<Json> records = records_in(file);
  if (records.empty() || !file.contains("files")) return std::nullopt;
  const Json expected = record_without_result(input, hash, settings);
  for (Json& record : records) {
    const bool is_the_same = std::all_of(k_causes.begin(), k_causes.end(), [&](const char* key) {
      return record.value(key, Json()) == expected[key];
    });
    const std::string path = record["path"];
    if (!is_the_same || stem_of(path) != stem_of(input.path) || !record["error"].is_null())
      return std::nullopt;
    for (const char* place : {"number", "of", "line", "path", "folder"})
      record[place] = expected[place];
    record["kept"] = true;
  }
  return are_as_written(file["files"], folder) ? std::optional(std::move(records)) : std::nullopt;
}

std::vector<Json> read_records(const std::string& text, const std::string& path) {
  const Json file = parse_shallow(text);
  if (file.is_object() && file.contains("records")) {
    std::vector<Json> records = records_in(file);
    if (records.empty())
      throw Error(ErrorCode::malformed_file, "is no record of planish flatten --inputs",
                  {.path = path});
    return records;
  }
  return records_of_lines(text, path);
}

std::string record_line(const Json& record) {
  return json_text(record, -1);
}

int exit_of(const Json& record) {
  return record["exit"].get<int>();
}

std::string record_table_header() {
  return several_csv_header(record_columns(), false);
}

std::string record_table_line(const Json& record) {
  static const std::vector<Column> k_columns = record_columns();
  FileReport file{record["path"], record};
  file.figures["missed"] = joined(record["missed"]);
  return several_csv_lines(file, k_columns, false);
}

}  // namespace planish::cli
