#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "report/several_files.h"
#include "shell/command.h"
#include "shell/session.h"

namespace planish::cli {

/// One of several files while a verb works on it.
struct WorkFile {
  FileReport report;              ///< what --json prints, and the table
  std::string text = {};          ///< for people, behind its name: a line, or some
  bool misses = false;            ///< what was asked for: exit code 3
  std::vector<OutputFile> files;  ///< to be written
};

/// What a verb does with several files.
struct SeveralFiles {
  std::vector<Column> columns;  ///< of its table
  std::string_view heads;       ///< of the figures for people, behind the name
  /// "no pattern of" and "keeps the limit", around "2 of 3 files".
  std::string_view missed_before, missed_behind;
  /// Of the output of an input; empty for a folder. None where the verb writes nothing but figures.
  std::function<std::string(const std::string& input)> extension = {};
  /// Fills in what it finds out; what it throws is the file's failure.
  /// @param place of what is to be written; empty where nothing is
  std::function<void(WorkFile& file, const std::filesystem::path& place)> work = {};
};

/// --csv, for verbs that take several files.
Flag csv_flag();

/// --output-format, for verbs that write one file for each of several.
/// @param names of formats
Flag output_format_flag(std::vector<std::string> names, const std::string& standard);

/// The format that it names, if it is there.
/// @throws UsageError for unknown names, and without several files or --output
std::optional<std::string> output_format_from(const Arguments& arguments,
                                              const std::vector<std::string>& names);

/// Whether a table is asked for: of several inputs, of a folder, or with --csv.
bool takes_several(const Arguments& arguments);

/// @throws UsageError where one of the flags is there, which go with one file only
void refuse_single_file_flags(const Arguments& arguments, std::span<const char* const> flags);

/// The run over those files of which --only and --without take something, where these flags are
/// there: a name may be of any of the files. Notes tell which are passed over.
/// @throws UsageError, Error unknown_name where none of them has a name, no_triangles where nothing
/// is taken of any
Arguments with_files_that_are_asked_for(const Arguments& arguments, Session& session);

/// Works on all files, and on all mesh files of folders, one after the other. A file that fails
/// does not end the others; the exit code is 1 at the end, or 3 where one misses what was asked
/// for. Outputs are written into the folder --output, each as soon as it is there.
/// @throws UsageError where an output would replace an input, Error file_unwritable; Cancelled as
/// long as nothing is written
CommandResult run_several(const SeveralFiles& job, const Arguments& arguments, Session& session);

}  // namespace planish::cli
