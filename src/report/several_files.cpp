#include "report/several_files.h"

#include <utility>

#include <planish/core/version.h>

#include "report/json_parts.h"

namespace planish {

namespace {

/// In quotes where a comma, a quote or a line end would break the line.
std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text)
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string header_of(const std::vector<Cell>& columns, bool with_output) {
  std::string line = "path";
  for (const Cell& column : columns)
    line += "," + std::string(column.name);
  return line + (with_output ? ",output" : "") + ",error,message\n";
}

std::string line_of(const FileReport& file, const TableLine& line, bool with_output) {
  std::string text = csv_text(file.path);
  for (const Cell& cell : line.cells)
    text += ',' + csv_text(cell.text);
  if (with_output) text += ',' + csv_text(file.output);
  const Failure failure = line.failure ? *line.failure : file.failure.value_or(Failure{});
  return text + ',' + failure.code + ',' + csv_text(failure.message) + '\n';
}

Json to_json(const FileReport& file, bool with_output) {
  Json json = {{"path", file.path}};
  json.update(file.figures);
  if (with_output) json["output"] = file.output.empty() ? Json(nullptr) : Json(file.output);
  json["error"] = file.failure ? to_json(*file.failure) : Json(nullptr);
  return json;
}

}  // namespace

std::string several_csv(std::span<const FileReport> files, const std::vector<Cell>& columns,
                        bool with_output) {
  std::string csv = header_of(columns, with_output);
  for (const FileReport& file : files) {
    if (file.lines.empty()) csv += line_of(file, {columns}, with_output);
    for (const TableLine& line : file.lines)
      csv += line_of(file, line, with_output);
  }
  return csv;
}

std::string several_json(std::span<const FileReport> files, bool with_output,
                         const std::string& csv) {
  Json list = Json::array();
  for (const FileReport& file : files)
    list.push_back(to_json(file, with_output));
  return json_document({{"version", k_version},
                        {"files", std::move(list)},
                        {"csv", csv.empty() ? Json(nullptr) : Json(csv)}}) +
         '\n';
}

Json measured_figures(const MeasuredPatch& patch, const std::optional<StrainAsDesigned>& strain,
                      std::span<const Caution> cautions, Unit unit) {
  Json json = to_json(patch);
  json.update(strain_and_limits(strain));
  json["cautions"] = to_json(cautions, unit);
  return json;
}

Json evolved_figures(const EvolveReport& report, std::span<const Caution> cautions, Unit unit) {
  Json json = to_json(report);
  json["cautions"] = to_json(cautions, unit);
  return json;
}

Json unfolded_figures(const UnfoldReport& report, std::span<const Caution> cautions) {
  Json json = to_json(report);
  json.update(to_json(report.outcome()));
  json["cautions"] = to_json(cautions, report.unit);
  return json;
}

Json caution_figures(std::span<const Caution> cautions, Unit unit) {
  return to_json(cautions, unit);
}

Json compared_figures(const CompareReport& report) {
  return to_json(report);
}

}  // namespace planish
