#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <planish/flatten/compare.h>

#include <planish_json/json.h>

namespace planish {

/// A column of a table: its name, and where its figure stands in what --json prints.
struct Column {
  std::string name;
  Json::json_pointer path;
};

/// What a verb has found out about one of several files.
struct FileReport {
  std::string path;                     ///< as it was named
  Json figures = Json::object();        ///< what the verb prints of one file with --json
  std::string output = {};              ///< path of what was written; empty where nothing was
  std::optional<Failure> failure = {};  ///< why something above is missing; often none
};

/// Of names with their paths, "name=path" or both alike, one behind the other; paths begin in
/// `folder`.
std::vector<Column> columns_of(std::string_view words, const std::string& folder = "/");

/// The columns of a verb.
std::vector<Column> measured_columns();
std::vector<Column> evolved_columns();
std::vector<Column> unfolded_columns();
std::vector<Column> compared_columns();
std::vector<Column> flattened_columns();

/// The figures that columns have, by their names; of checks whether all are kept, null of none.
Json figures_in(const std::vector<Column>& columns, const Json& figures);

/// Of a line with these figures; empty where the figure is not known.
std::string cell_text(const Column& column, const Json& figures);

/// A header line, then one for each of a list of figures, as comma-separated values.
std::string csv_of(const std::vector<Column>& columns, const Json& lines);

/// What the verbs print of one file with --json, but for the schema.
Json measured_figures(const MeasuredPatch& patch, const std::optional<StrainAsDesigned>& strain,
                      std::span<const Caution> cautions, Unit unit);
Json evolved_figures(const EvolveReport& report, std::span<const Caution> cautions, Unit unit);
Json unfolded_figures(const UnfoldReport& report, std::span<const Caution> cautions);

/// A header line, then the lines of each file, as docs/command-line.md has them: path, cells,
/// output if the verb has one, error and message. A file has a line, or one for each of its "runs".
std::string several_csv(std::span<const FileReport> files, const std::vector<Column>& columns,
                        bool with_output);

/// The header line of these, and the lines of one file.
std::string several_csv_header(const std::vector<Column>& columns, bool with_output);
std::string several_csv_lines(const FileReport& file, const std::vector<Column>& columns,
                              bool with_output);

/// One object with "files", a list as docs/command-line.md has it, and "csv".
/// @param csv path of the table; empty where none was written
std::string several_json(std::span<const FileReport> files, bool with_output,
                         const std::string& csv);

}  // namespace planish
