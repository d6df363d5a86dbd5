#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>
#include <tuple>

#include "batch/named_files.h"
#include "batch/records.h"
#include "commands/commands.h"
#include "output/kept_files.h"
#include "platform/path.h"
#include "report/product/html_table.h"
#include "shell/failures.h"
#include "shell/output_folder.h"
#include "shell/session.h"
#include "shell/text.h"
#include "shell/values.h"
#include "text/written_text.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

std::string content_of(const std::string& path) {
  std::error_code ignored;
  const auto content = kept_content(fs::canonical(path_of(path), ignored));
  if (content) return *content;
  if (!fs::exists(path_of(path), ignored)) {
    throw Error(ErrorCode::file_not_found, "cannot be read: there is no such file or folder",
                {.path = path});
  }
  throw Error(ErrorCode::file_unreadable, "cannot be read", {.path = path});
}

void add_records_of(const std::string& path, std::vector<Json>& records) {
  for (Json& record : read_records(content_of(path), path))
    records.push_back(std::move(record));
}

/// Those in the folders of the inputs.
void add_records_in(const std::string& folder, std::vector<Json>& records) {
  std::error_code failure;
  std::vector<fs::path> entries = entries_of(path_of(folder), failure);
  if (failure) throw Error(ErrorCode::file_unreadable, failure.message(), {.path = folder});
  std::sort(entries.begin(), entries.end());
  const std::size_t before = records.size();
  for (const fs::path& entry : entries) {
    std::error_code ignored;
    const fs::path file = entry / path_of(k_record_file);
    if (fs::is_regular_file(file, ignored)) add_records_of(utf8_of(file), records);
  }
  if (records.size() == before) {
    throw Error(ErrorCode::file_unreadable,
                "the folder holds no results of flatten --inputs: in its folders is no " +
                    std::string(k_record_file),
                {.path = folder});
  }
}

std::string patch_of(const Json& record) {
  return record["patch"].is_string() ? record["patch"].get<std::string>() : std::string();
}

/// In the order of the list. Of an input that was worked on several times the last counts.
std::vector<Json> in_order(std::vector<Json> records) {
  const auto key = [](const Json& record) {
    return std::tuple(record["number"].get<unsigned long long>(),
                      record["path"].get<std::string>());
  };
  // Records of one run on an input follow each other, and no two have one patch.
  std::map<std::tuple<unsigned long long, std::string>, std::vector<Json>> inputs;
  std::map<std::tuple<unsigned long long, std::string>, std::size_t> last;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const auto input = key(records[r]);
    std::vector<Json>& own = inputs[input];
    const bool is_there = std::any_of(own.begin(), own.end(), [&](const Json& other) {
      return patch_of(other) == patch_of(records[r]);
    });
    const bool follows = !own.empty() && last[input] + 1 == r;
    if (is_there || !follows) own.clear();
    last[input] = r;
    own.push_back(std::move(records[r]));
  }
  std::vector<Json> ordered;
  for (auto& [input, own] : inputs)
    std::move(own.begin(), own.end(), std::back_inserter(ordered));
  return ordered;
}

/// Numbers of the inputs of a list that have no record.
std::vector<std::string> missing_of(const std::vector<Json>& records) {
  std::set<unsigned long long> there;
  unsigned long long all = 0;
  for (const Json& record : records) {
    there.insert(record["number"].get<unsigned long long>());
    all = std::max(all, record["of"].get<unsigned long long>());
  }
  std::vector<std::string> missing;
  constexpr unsigned long long k_most = 1'000'000;  // anybody may have written "of"
  for (unsigned long long number = 1; number <= std::min(all, k_most); ++number) {
    if (!there.contains(number)) missing.push_back(std::to_string(number));
  }
  return missing;
}

struct Counts {
  std::size_t patches = 0, failed = 0, missed = 0;
  double seconds = 0.0;
  std::map<std::string, std::size_t> errors = {};  ///< by their codes
};

Counts counts_of(const std::vector<Json>& records) {
  Counts counts;
  for (const Json& record : records) {
    ++counts.patches;
    if (record.contains("seconds") && record["seconds"].is_number())
      counts.seconds += record["seconds"].get<double>();
    if (!record["error"].is_null()) {
      ++counts.failed;
      ++counts.errors[record["error"]["code"].get<std::string>()];
    } else if (exit_of(record) != k_exit_done) {
      ++counts.missed;
    }
  }
  return counts;
}

Json json_of(const Counts& counts) {
  Json errors = Json::object();
  for (const auto& [code, count] : counts.errors)
    errors[code] = count;
  return {{"patches", counts.patches},
          {"failed", counts.failed},
          {"missed", counts.missed},
          {"seconds", counts.seconds},
          {"errors", std::move(errors)}};
}

std::string verdict_of(const Counts& counts) {
  return std::to_string(counts.patches) +
         " patches: " + std::to_string(counts.patches - counts.failed - counts.missed) +
         " as asked for, " + std::to_string(counts.missed) + " miss something, " +
         std::to_string(counts.failed) + " failed.";
}

std::vector<std::string> facts_of(const Counts& counts, const std::vector<std::string>& missing) {
  std::vector<std::string> facts;
  if (!missing.empty())
    facts.push_back("No result of " + counted(missing.size(), "input") +
                    ", by their numbers in the list: " + list_of_some(missing) + ".");
  for (const auto& [code, count] : counts.errors)
    facts.push_back(code + ": " + std::to_string(count) + ".");
  facts.push_back(fixed(counts.seconds, 1) + " s of work in all.");
  return facts;
}

std::vector<std::string> row_of(const Json& record) {
  const auto figure = [&](const char* name) -> std::string {
    if (!record["figures"].is_object()) return {};
    const Json value = record["figures"].value(name, Json());
    if (value.is_string()) return value.get<std::string>();
    return value.is_number() ? digits(value.get<double>(), 3) : std::string();
  };
  const auto share = [&](const char* name) -> std::string {
    if (!record["figures"].is_object()) return {};
    const Json value = record["figures"].value(name, Json());
    return value.is_number() ? percent(value.get<double>()) : std::string();
  };
  std::string missed;
  for (const Json& word : record["missed"]) {
    if (word.is_string()) missed += (missed.empty() ? "" : ", ") + word.get<std::string>();
  }
  const Json& error = record["error"];
  const std::string words = error.is_null() ? missed : error["message"].get<std::string>();
  const std::string sign = !error.is_null() ? "failed" : exit_of(record) == k_exit_done ? "✓" : "✗";
  return {record["path"].get<std::string>(),
          patch_of(record),
          sign,
          figure("vertices"),
          share("strain_rms"),
          share("strain_max"),
          figure("width"),
          figure("height"),
          figure("unit"),
          figure("deviation_max"),
          words};
}

CommandResult run_collect(const Arguments& arguments, Session& session) {
  std::vector<Json> records;
  for (const std::string& path : arguments.operands) {
    if (is_folder(path))
      add_records_in(path, records);
    else
      add_records_of(path, records);
  }
  records = in_order(std::move(records));
  const std::vector<std::string> missing = missing_of(records);
  const Counts counts = counts_of(records);
  const std::string& first = arguments.operands.front();
  const fs::path beside = is_folder(first) ? path_of(first) : path_of(first).parent_path();
  const fs::path folder =
      output_folder(arguments.text("--output", utf8_of(beside.empty() ? path_of(".") : beside)));
  std::string table = record_table_header();
  TablePage page{.name = utf8_of(beside.filename()),
                 .verdict = verdict_of(counts),
                 .facts = facts_of(counts, missing),
                 .heads = {"Input", "Patch", "", "Vertices", "Strain, rms", "Strain, largest",
                           "Width", "Height", "Unit", "Largest move", "Missed or failed"},
                 .rows = {}};
  for (const Json& record : records) {
    table += record_table_line(record);
    page.rows.push_back(row_of(record));
  }
  const std::vector<OutputFile> files = {{folder / path_of("patches.csv"), std::move(table)},
                                         {folder / path_of("patches.html"), html_table_page(page)}};
  std::string text = page.verdict + "\n";
  for (const std::string& fact : page.facts)
    text += fact + "\n";
  Json json = json_of(counts);
  json["missing"] = missing.size();
  json["csv"] = utf8_of(files[0].path);
  json["page"] = utf8_of(files[1].path);
  CommandResult outcome = {text + written_text(files), json_document(json) + '\n'};
  if (!missing.empty()) {
    outcome.exit_code = k_exit_failed;
    outcome.complaint = "no result of " + counted(missing.size(), "input") + " of the list";
  }
  session.write(files);
  return outcome;
}

}  // namespace

Command collect_command() {
  return {"collect",
          "join results of flatten --inputs into one table and page",
          "RESULTS ... [-o FOLDER]",
          "Takes folders that flatten --inputs wrote into, or files with the lines of JSON that it "
          "printed. Writes patches.csv, the same table that one run over all inputs writes, and "
          "patches.html. Ends with exit code 1 if an input of the list has no result.",
          {"RESULTS"},
          {{"Output", {{"--output", "FOLDER", "where to write (default: the first folder)", 'o'}}}},
          {"planish collect out", "planish collect shard-*.jsonl -o joined"},
          run_collect,
          false,
          true,
          {{.extensions = {"jsonl"}}}};
}

}  // namespace planish::cli
