#include "product/nest.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include <planish_json/json.h>

#include "flags/quantities.h"
#include "flags/units.h"
#include "platform/path.h"
#include "shell/failures.h"
#include "shell/text.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

constexpr std::array k_turns = {Turns::half, Turns::none, Turns::quarter, Turns::free};

std::vector<std::string> turn_names() {
  std::vector<std::string> names;
  names.reserve(k_turns.size());
  for (const Turns turns : k_turns)
    names.emplace_back(to_string(turns));
  return names;
}

Turns turns_from(const Arguments& arguments) {
  const std::vector<std::string> names = turn_names();
  const std::string name = known_name("turn", arguments.value_or("--turn", names.front()), names);
  for (const Turns turns : k_turns) {
    if (name == to_string(turns)) return turns;
  }
  return k_turns.front();
}

/// Millimetres, as nest() has it: 10 km.
constexpr double k_longest = 1e7;

/// Millimetres.
double nest_length(const Arguments& arguments, const std::string& flag, const std::string& text,
                   double least) {
  const double scale = millimetres_per(unit_from(arguments));
  const Range range = {.min = least, .max = k_longest / scale};
  return scale * quantity_value(flag, text, Quantity::length, range, arguments);
}

/// Where the pieces lie, in the order of nest().
Json placements_json(const NestJob& job, const Nesting& nesting) {
  Json list = Json::array();
  for (const NestPlacement& placement : nesting.placements) {
    list.push_back({{"patch", job.patches[placement.piece].name},
                    {"copy", placement.copy + 1},
                    {"sheet", placement.sheet + 1},
                    {"angle", placement.angle},
                    {"x", placement.shift.x},
                    {"y", placement.shift.y}});
  }
  return list;
}

Json left_out_json(const NestJob& job) {
  Json names = Json::array();
  for (const NestPatch& patch : job.patches) {
    if (patch.pattern.empty()) names.push_back(patch.name);
  }
  return names;
}

Json request_json(const NestOptions& sheets) {
  return {{"sheet_width", sheets.width},
          {"sheet_length", sheets.length ? Json(*sheets.length) : Json(nullptr)},
          {"gap", sheets.gap},
          {"margin", sheets.margin},
          {"turn", to_string(sheets.turns)}};
}

Json nesting_json(const NestJob& job, const Nesting& nesting,
                  const std::vector<OutputFile>& files) {
  Json json = request_json(job.sheets);
  json["sheets"] = nesting.sheets;
  json["used_length"] = nesting.used_length;
  json["used_share"] = nesting.used_share();
  json["left_out"] = left_out_json(job);
  json["files"] = Json::array();
  for (const OutputFile& file : files)
    json["files"].push_back(utf8_of(file.path));
  json["placements"] = placements_json(job, nesting);
  json["error"] = nullptr;
  return json;
}

std::string material_text(const NestOptions& sheets, std::size_t count) {
  if (!sheets.length) return "a roll of width " + fixed(sheets.width, 1) + " mm";
  return counted(count, "sheet") + " " + fixed(sheets.width, 1) + " mm wide and " +
         fixed(*sheets.length, 1) + " mm long";
}

std::string use_text(const NestOptions& sheets, const Nesting& nesting) {
  return fixed(nesting.used_length, 1) + " mm" + (sheets.length ? " of the last" : "") + " used, " +
         percent(nesting.used_share()) + " of the area in pieces";
}

std::string nesting_text(const NestJob& job, const Nesting& nesting) {
  std::string text = "\n" + counted(nesting.placements.size(), "piece") +
                     (nesting.placements.size() == 1 ? " fits on " : " fit on ") +
                     material_text(job.sheets, nesting.sheets) + ": " +
                     use_text(job.sheets, nesting) + "\n";
  for (const Json& name : left_out_json(job))
    text += "  without " + name.get<std::string>() + "\n";
  return text;
}

std::vector<OutputFile> layout_files(const NestJob& job, const Nesting& nesting,
                                     const NestRequest& request,
                                     const std::filesystem::path& folder,
                                     const std::string& title) {
  std::vector<OutputFile> files;
  for (std::size_t s = 0; s < nesting.sheets; ++s) {
    const Drawing sheet = nest_sheet(job, nesting, s, title);
    const std::string number = nesting.sheets > 1 ? "-" + std::to_string(s + 1) : "";
    for (const PatternFormat format : request.formats) {
      files.push_back({folder / path_of("layout" + number + "." + std::string(to_string(format))),
                       pattern_file(sheet, format, request.output)});
    }
  }
  return files;
}

}  // namespace

FlagGroup nest_flags() {
  return {"How the pieces are laid on material",
          {{"--sheet", "WIDTH[xLENGTH]",
            "lay all pieces on a roll as wide as 1500mm, or on sheets like 1500mmx1000mm"},
           {"--nest-gap",
            "LENGTH",
            "left between pieces (default 5mm)",
            0,
            false,
            {.range = {.min = 0.0}, .standard = "5mm"}},
           {"--nest-margin",
            "LENGTH",
            "left free along the edges of the sheet (default 0)",
            0,
            false,
            {.range = {.min = 0.0}, .standard = "0"}},
           {"--turn",
            "KIND",
            "how pieces may be turned against their grain: " + list_of(turn_names()) +
                " (default half)",
            0,
            false,
            {.choices = turn_names(), .standard = "half"}}}};
}

std::optional<NestOptions> sheets_from(const Arguments& arguments) {
  if (!arguments.has("--sheet")) {
    for (const char* flag : {"--nest-gap", "--nest-margin", "--turn"}) {
      if (!arguments.has(flag)) continue;
      throw UsageError("flag " + std::string(flag) + " goes with --sheet only");
    }
    return std::nullopt;
  }
  constexpr double above_zero = std::numeric_limits<double>::min();
  const std::string& text = arguments.flags.at("--sheet");
  const std::size_t sign = text.find('x');
  NestOptions sheets;
  sheets.width = nest_length(arguments, "--sheet", text.substr(0, sign), above_zero);
  if (sign != std::string::npos) {
    sheets.length = nest_length(arguments, "--sheet", text.substr(sign + 1), above_zero);
  }
  const auto length_or = [&](const char* flag, double usual) {
    return arguments.has(flag) ? nest_length(arguments, flag, arguments.flags.at(flag), 0.0)
                               : usual;
  };
  sheets.gap = length_or("--nest-gap", sheets.gap);
  sheets.margin = length_or("--nest-margin", sheets.margin);
  const double shorter = std::min(sheets.width, sheets.length.value_or(sheets.width));
  check_range("--nest-margin", sheets.margin, {0.0, 0.5 * shorter});
  sheets.turns = turns_from(arguments);
  return sheets;
}

SheetFit fit_alone(NestPatch patch, Unit unit, const NestOptions& sheets) {
  const NestJob job{{std::move(patch)}, unit, sheets};
  try {
    const Nesting nesting = *nest(nest_pieces(job), sheets, [](double) { return true; });
    return {true, material_text(sheets, nesting.sheets), "alone, " + use_text(sheets, nesting)};
  } catch (const Error& error) {
    if (error.code() != ErrorCode::piece_too_large) return {};
    return {false, material_text(sheets, 1), error.what()};
  }
}

NestOutcome nest_patches(std::vector<NestPatch> patches, Unit unit, const NestRequest& request,
                         const std::filesystem::path& folder, const std::string& title,
                         Session& session) {
  NestJob job{std::move(patches), unit, request.sheets};
  const std::vector<NestPiece> pieces = nest_pieces(job);
  const auto nesting = nest(pieces, job.sheets, [&](double share) {
    session.show_progress("laying pieces on sheets", share, title);
    return !session.interrupted();
  });
  if (!nesting) throw Interrupted();
  NestOutcome outcome{layout_files(job, *nesting, request, folder, title), {}, {}};
  outcome.json = json_text(nesting_json(job, *nesting, outcome.files), -1);
  outcome.text = nesting_text(job, *nesting);
  outcome.material = material_text(job.sheets, nesting->sheets);
  outcome.use = use_text(job.sheets, *nesting);
  return outcome;
}

NestOutcome try_nest_patches(std::vector<NestPatch> patches, Unit unit, const NestRequest& request,
                             const std::filesystem::path& folder, const std::string& title,
                             Session& session) {
  try {
    return nest_patches(std::move(patches), unit, request, folder, title, session);
  } catch (const Error&) {
    NestOutcome outcome;
    outcome.failure = current_failure();
    Json json = request_json(request.sheets);
    json["error"] = {{"code", outcome.failure->code}, {"message", outcome.failure->message}};
    outcome.json = json_text(json, -1);
    return outcome;
  }
}

std::string json_with_nesting(const std::string& report,
                              const std::optional<NestOutcome>& outcome) {
  Json json = Json::parse(report);
  json["nesting"] = outcome ? Json::parse(outcome->json) : Json(nullptr);
  return json_text(json) + "\n";
}

CommandResult with_nesting_checked(CommandResult outcome,
                                   const std::optional<NestOutcome>& nesting) {
  if (!nesting || !nesting->failure) return outcome;
  outcome.exit_code = k_exit_failed;
  if (!outcome.complaint.empty()) outcome.complaint += "\n";
  outcome.complaint += "the pieces could not be laid on sheets: " + nesting->failure->message;
  return outcome;
}

}  // namespace planish::cli
