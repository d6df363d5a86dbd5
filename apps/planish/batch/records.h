#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <planish/flatten/flatten.h>
#include <planish/io/write_file.h>

#include <planish_json/json.h>

#include "batch/input_list.h"
#include "report/several_files.h"
#include "shell/command.h"

namespace planish::cli {

// A record says what became of one patch of an input of many: a line of JSON, and a line of a
// table. docs/command-line.md has its keys.

/// The file with the records of an input, in the folder of what was made of it.
inline constexpr const char* k_record_file = "record.json";

/// What all inputs of a run have in common, and what is made of them depends on.
struct ListSettings {
  Json options = Json::object();       ///< flag -> value
  Json option_files = Json::object();  ///< path in a value -> SHA-256 of the file
  std::size_t inputs = 0;              ///< in all shards
};

/// @param inputs how many there are
ListSettings settings_of(const Arguments& arguments, std::size_t inputs);

/// What a run on one input came to.
struct InputOutcome {
  std::string hash = {};                ///< SHA-256 of the input; empty where it cannot be read
  CommandResult result = {};            ///< of the verb
  std::optional<Failure> failure = {};  ///< instead of a result
  std::vector<std::string> notes = {};  ///< and warnings, on the way
  double seconds = 0.0;
};

/// The records of an input, one for each of its patches; one alone where none could be read.
std::vector<Json> records_of(const ListedInput& input, const InputOutcome& outcome,
                             const ListSettings& settings);

/// The file with the records of an input and the hashes of all that was written of it.
/// @param folder of the input
OutputFile record_file(const std::vector<Json>& records, const std::filesystem::path& folder);

/// The records that an earlier run left in the folder of an input, marked as kept, where nothing
/// that they depend on has changed, no patch failed, and every file is as it was written.
/// @param hash of the input
std::optional<std::vector<Json>> kept_records(const ListedInput& input, const std::string& hash,
                                              const ListSettings& settings,
                                              const std::filesystem::path& folder);

/// The records of a text: those of a record file, or a line each. Of a last line that has no end,
/// as a run leaves that is killed, nothing is taken.
/// @param path of the text, for errors
/// @throws Error malformed_file for what is no record
std::vector<Json> read_records(const std::string& text, const std::string& path);

/// The line of a record, without its end.
std::string record_line(const Json& record);

/// Of a record: 0, 1, 2 or 3, as the exit code of a run on this patch alone.
int exit_of(const Json& record);

/// The table of records: a header, and the line of each.
std::string record_table_header();
std::string record_table_line(const Json& record);

}  // namespace planish::cli
