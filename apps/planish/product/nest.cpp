#include "product/nest.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <utility>

#include "flags/quantities.h"
#include "flags/units.h"
#include "output/pattern_notes.h"
#include "platform/path.h"
#include "shell/failures.h"
#include "shell/text.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

Turns turns_from(const Arguments& arguments) {
  if (!arguments.has("--turn")) return k_turns.front();
  return value_named("turn", arguments.text("--turn"), k_turns);
}

/// Millimetres, as nest() has it: 10 km.
constexpr double k_longest = 1e7;

/// Millimetres.
double nest_length(const Arguments& arguments, const std::string& flag, const Field& field,
                   double least) {
  const double scale = millimetres_per(unit_from(arguments));
  const Range range = {.min = least, .max = k_longest / scale};
  return scale * quantity_value(flag, field, Quantity::length, range, arguments);
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

std::string nesting_text(const LayoutReport& layout) {
  const Nesting& nesting = layout.nesting;
  std::string text = "\n" + counted(nesting.placements.size(), "piece") +
                     (nesting.placements.size() == 1 ? " fits on " : " fit on ") +
                     material_text(layout.sheets, nesting.sheets) + ": " +
                     use_text(layout.sheets, nesting) + "\n";
  for (const std::string& name : layout.left_out)
    text += "  without " + name + "\n";
  return text;
}

std::vector<OutputFile> layout_files(const std::vector<Drawing>& sheets, const NestRequest& request,
                                     const std::filesystem::path& folder) {
  std::vector<OutputFile> files;
  for (std::size_t s = 0; s < sheets.size(); ++s) {
    const std::string number = sheets.size() > 1 ? "-" + std::to_string(s + 1) : "";
    const Drawing cut_once = without_common_lines(sheets[s]);
    for (const PatternFormat format : request.formats) {
      const bool is_apparel =
          format == PatternFormat::dxf && request.output.dxf.profile != DxfProfile::generic;
      files.push_back({folder / path_of("layout" + number + "." + std::string(to_string(format))),
                       pattern_file(is_apparel ? sheets[s] : cut_once, format, request.output)});
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
            "how pieces may be turned against their grain: " + list_of(names_of(k_turns)) +
                " (default half)",
            0,
            false,
            {.choices = names_of(k_turns), .standard = "half"}}}};
}

/// The width in millimetres. A number without a unit is in that of the mesh, which is not what is
/// meant where it gives a sheet wider than any on sale.
double sheet_width(const Arguments& arguments, const std::string& text) {
  constexpr double above_zero = std::numeric_limits<double>::min(), widest = 20'000.0;
  const double width = nest_length(arguments, "--sheet", text, above_zero);
  const bool has_unit = text.find_first_not_of("0123456789.+-eE") != std::string::npos;
  if (width > widest && !has_unit) {
    throw UsageError("--sheet is " + fixed(width / 1000.0, 0) +
                     " m wide, as numbers are in the unit of --unit: write " + text +
                     "mm if millimetres are meant");
  }
  return width;
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
  const std::string text = arguments.text("--sheet");
  const std::size_t sign = text.find('x');
  NestOptions sheets;
  sheets.width = sheet_width(arguments, text.substr(0, sign));
  if (sign != std::string::npos) {
    sheets.length = nest_length(arguments, "--sheet", text.substr(sign + 1), above_zero);
  }
  const auto length_or = [&](const char* flag, double usual) {
    return arguments.has(flag) ? nest_length(arguments, flag, arguments.value(flag), 0.0) : usual;
  };
  sheets.gap = length_or("--nest-gap", sheets.gap);
  sheets.margin = length_or("--nest-margin", sheets.margin);
  const double shorter = std::min(sheets.width, sheets.length.value_or(sheets.width));
  check_range("--nest-margin", sheets.margin, {0.0, 0.5 * shorter});
  sheets.turns = turns_from(arguments);
  return sheets;
}

namespace {

/// Says where pieces of several materials are laid on the same one.
void note_materials(const std::vector<NestPatch>& patches, Session& session) {
  std::set<std::string> materials;
  for (const NestPatch& patch : patches) {
    const std::string& fabric = patch.annotations.label.fabric;
    if (!fabric.empty()) materials.insert(fabric);
  }
  if (materials.size() < 2) return;
  const std::vector<std::string> names(materials.begin(), materials.end());
  session.note("pieces of several materials lie on the same sheets: " + list_of(names) +
               "; to lay each by itself, flatten its pieces apart");
}

}  // namespace

SheetFit fit_alone(NestPatch patch, Unit unit, const NestOptions& sheets) {
  const NestJob job{with_mirror_images(with_folds_opened({std::move(patch)}, unit)), unit, sheets};
  try {
    const Nesting nesting = nest(nest_pieces(job), sheets);
    return {true, material_text(sheets, nesting.sheets), "alone, " + use_text(sheets, nesting)};
  } catch (const Error& error) {
    if (error.code() != ErrorCode::piece_too_large) return {};
    return {false, material_text(sheets, 1), error.what()};
  }
}

NestOutcome nest_patches(std::vector<NestPatch> patches, Unit unit, const NestRequest& request,
                         const std::filesystem::path& folder, const std::string& title,
                         Session& session) {
  note_materials(patches, session);
  NestJob job{with_mirror_images(with_folds_opened(std::move(patches), unit)), unit,
              request.sheets};
  const std::vector<NestPiece> pieces = nest_pieces(job);
  Nesting nesting = nest(pieces, job.sheets, session.job_context(title));
  NestOutcome outcome;
  for (std::size_t s = 0; s < nesting.sheets; ++s)
    outcome.sheets.push_back(nest_sheet(job, nesting, s, title));
  outcome.files = layout_files(outcome.sheets, request, folder);
  outcome.layout = layout_report(job, std::move(nesting));
  for (const OutputFile& file : outcome.files)
    outcome.layout.files.push_back(utf8_of(file.path));
  const Nesting& laid = outcome.layout.nesting;
  outcome.text = nesting_text(outcome.layout);
  outcome.material = material_text(job.sheets, laid.sheets);
  outcome.use = use_text(job.sheets, laid);
  return outcome;
}

NestOutcome try_nest_patches(std::vector<NestPatch> patches, Unit unit, const NestRequest& request,
                             const std::filesystem::path& folder, const std::string& title,
                             Session& session) {
  try {
    return nest_patches(std::move(patches), unit, request, folder, title, session);
  } catch (const Error&) {
    NestOutcome outcome;
    outcome.layout.sheets = request.sheets;
    outcome.layout.failure = current_failure();
    return outcome;
  }
}

ProductPages product_pages(std::vector<NestPatch> patches, Unit unit, const NestOptions* sheets,
                           const PatternOutput& output, const std::filesystem::path& folder,
                           const std::string& title, Session& session) {
  NestJob job{with_mirror_images(with_folds_opened(std::move(patches), unit)), unit,
              sheets != nullptr ? *sheets : NestOptions{.turns = Turns::free}};
  PatternOutput written = output;
  written.pages->one_page = true;
  const std::string& paper = written.pages->paper.name;
  ProductPages pages;
  try {
    const Drawing sheet =
        page_sheet(std::move(job), *written.pages, title, session.job_context(title));
    pages.files.push_back(
        {folder / path_of("garment-" + paper + ".pdf"), tiled_file(sheet, written)});
    pages.text = "\n" + counted(sheet.pieces.size(), "piece") + " on " +
                 counted(static_cast<std::size_t>(pages_in(pages.files.front().content)), "page") +
                 " of " + paper + ", the map among them\n";
  } catch (const Error&) {
    pages.failure = current_failure();
  }
  return pages;
}

namespace {

CommandResult failed(CommandResult outcome, const std::string& what, const Failure& failure) {
  outcome.exit_code = k_exit_failed;
  if (!outcome.complaint.empty()) outcome.complaint += "\n";
  outcome.complaint += "the pieces could not be laid on " + what + ": " + failure.message;
  return outcome;
}

}  // namespace

CommandResult with_nesting_checked(CommandResult outcome,
                                   const std::optional<NestOutcome>& nesting) {
  if (!nesting || !nesting->layout.failure) return outcome;
  return failed(std::move(outcome), "sheets", *nesting->layout.failure);
}

CommandResult with_pages_checked(CommandResult outcome, const ProductPages& pages) {
  return pages.failure ? failed(std::move(outcome), "pages", *pages.failure) : outcome;
}

}  // namespace planish::cli
