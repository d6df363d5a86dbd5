#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <planish/flatten/compare.h>

#include <planish_json/json.h>

namespace planish {

/// A figure under the name of its column; empty where it is not known.
struct Cell {
  std::string_view name;
  std::string text = {};
};

/// A line of a table of several files, without path, output and failure.
struct TableLine {
  std::vector<Cell> cells;
  std::optional<Failure> failure = {};  ///< of this line alone
};

/// What a verb has found out about one of several files.
struct FileReport {
  std::string path;                     ///< as it was named
  std::vector<TableLine> lines = {};    ///< none where nothing is known
  Json figures = Json::object();        ///< what the verb prints of one file with --json
  std::string output = {};              ///< path of what was written; empty where nothing was
  std::optional<Failure> failure = {};  ///< why something above is missing; often none
};

/// The columns of a verb, without texts, where it is asked for nothing (nullptr); else its figures.
std::vector<Cell> measured_cells(const MeasuredPatch* patch, const StrainAsDesigned* strain);
std::vector<Cell> evolved_cells(const EvolveReport* report);
std::vector<Cell> unfolded_cells(const UnfoldReport* report);
std::vector<Cell> compared_cells(const CompareReport* report, const ComparedMethod* run);

/// What the verbs print of one file with --json, but for the schema.
Json measured_figures(const MeasuredPatch& patch, const std::optional<StrainAsDesigned>& strain,
                      std::span<const Caution> cautions, Unit unit);
Json evolved_figures(const EvolveReport& report, std::span<const Caution> cautions, Unit unit);
Json unfolded_figures(const UnfoldReport& report, std::span<const Caution> cautions);
Json caution_figures(std::span<const Caution> cautions, Unit unit);
Json compared_figures(const CompareReport& report);

/// A header line, then the lines of each file, as docs/command-line.md has them: path, cells,
/// output if the verb has one, error and message. A file without lines gets an empty one.
std::string several_csv(std::span<const FileReport> files, const std::vector<Cell>& columns,
                        bool with_output);

/// One object with "files", a list as docs/command-line.md has it, and "csv".
/// @param csv path of the table; empty where none was written
std::string several_json(std::span<const FileReport> files, bool with_output,
                         const std::string& csv);

}  // namespace planish
