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

/// The figures of each line: of the file, or of each of its runs beside the input's.
std::vector<Json> lines_of(const Json& figures) {
  if (!figures.contains("runs")) return {figures};
  std::vector<Json> lines = figures["runs"];
  for (Json& line : lines) {
    line["unfold_before"] = figures["unfold_before"];
    line["best"] = line["method"] == figures["best"];
  }
  return lines;
}

std::string line_of(const FileReport& file, const Json& figures, const std::vector<Column>& columns,
                    bool with_output) {
  std::string text = csv_text(file.path);
  for (const Column& column : columns)
    text += ',' + csv_text(cell_text(column, figures));
  if (with_output) text += ',' + csv_text(file.output);
  Failure failure = file.failure.value_or(Failure{});
  if (figures.contains("error") && figures["error"].is_object())
    failure = {figures["error"]["code"], figures["error"]["message"]};
  return text + ',' + failure.code + ',' + csv_text(failure.message) + '\n';
}

Json entry_of(const FileReport& file, bool with_output) {
  Json json = {{"path", file.path}};
  json.update(file.figures);
  if (with_output) json["output"] = file.output.empty() ? Json(nullptr) : Json(file.output);
  json["error"] = file.failure;
  return json;
}

}  // namespace

std::string several_csv_header(const std::vector<Column>& columns, bool with_output) {
  std::string csv = "path";
  for (const Column& column : columns)
    csv += "," + column.name;
  return csv + (with_output ? ",output,error,message\n" : ",error,message\n");
}

std::string several_csv_lines(const FileReport& file, const std::vector<Column>& columns,
                              bool with_output) {
  std::string csv;
  for (const Json& figures : lines_of(file.figures))
    csv += line_of(file, figures, columns, with_output);
  return csv;
}

std::string several_csv(std::span<const FileReport> files, const std::vector<Column>& columns,
                        bool with_output) {
  std::string csv = several_csv_header(columns, with_output);
  for (const FileReport& file : files)
    csv += several_csv_lines(file, columns, with_output);
  return csv;
}

std::string several_json(std::span<const FileReport> files, bool with_output,
                         const std::string& csv) {
  Json list = Json::array();
  for (const FileReport& file : files)
    list.push_back(entry_of(file, with_output));
  return json_document({{"version", k_version},
                        {"files", std::move(list)},
                        {"csv", csv.empty() ? Json(nullptr) : Json(csv)}}) +
         '\n';
}

Json measured_figures(const MeasuredPatch& patch, const std::optional<StrainAsDesigned>& strain,
                      std::span<const Caution> cautions, Unit unit) {
  Json json = patch;
  json.update(strain_and_limits(strain));
  json["cautions"] = to_json(cautions, unit);
  return json;
}

Json evolved_figures(const EvolveReport& report, std::span<const Caution> cautions, Unit unit) {
  Json json = report;
  json["cautions"] = to_json(cautions, unit);
  return json;
}

Json unfolded_figures(const UnfoldReport& report, std::span<const Caution> cautions) {
  Json json = report;
  json.update(Json(report.outcome()));
  json["cautions"] = to_json(cautions, report.unit);
  return json;
}

}  // namespace planish
