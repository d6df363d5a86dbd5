#include "layout/nest.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <utility>

#include "flags/quantities.h"
#include "flags/units.h"
#include "output/pattern_notes.h"
#include "platform/path.h"
#include "shell/failures.h"
#include "shell/nearest.h"
#include "shell/safe_names.h"
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
  if (sheets.folded) return "cloth folded to a width of " + fixed(sheets.width, 1) + " mm";
  if (!sheets.length) return "a roll of width " + fixed(sheets.width, 1) + " mm";
  return counted(count, "sheet") + " " + fixed(sheets.width, 1) + " mm wide and " +
         fixed(*sheets.length, 1) + " mm long";
}

std::string use_text(const NestOptions& sheets, const Nesting& nesting) {
  const double used = nesting.used_share();
  return fixed(nesting.used_length, 1) + " mm" + (sheets.length ? " of the last" : "") + " used, " +
         percent(used) + " of the area in pieces, " + percent(1.0 - used) + " waste";
}

std::string layout_text(const std::string& material, const NestOptions& sheets,
                        const Nesting& nesting) {
  return counted(nesting.placements.size(), "piece") + (material.empty() ? "" : " of " + material) +
         (nesting.placements.size() == 1 ? " fits on " : " fit on ") +
         material_text(sheets, nesting.sheets) + ": " + use_text(sheets, nesting) + "\n";
}

/// @param stem of their names: "layout"
std::vector<OutputFile> layout_files(const std::vector<Drawing>& sheets, const NestRequest& request,
                                     const std::filesystem::path& folder, const std::string& stem) {
  std::vector<OutputFile> files;
  for (std::size_t s = 0; s < sheets.size(); ++s) {
    const std::string number = sheets.size() > 1 ? "-" + std::to_string(s + 1) : "";
    const Drawing cut_once = without_common_lines(sheets[s]);
    for (const PatternFormat format : request.formats) {
      const bool is_apparel =
          format == PatternFormat::dxf && request.output.dxf.profile != DxfProfile::generic;
      files.push_back({folder / path_of(stem + number + "." + std::string(to_string(format))),
                       pattern_file(is_apparel ? sheets[s] : cut_once, format, request.output)});
    }
  }
  return files;
}

}  // namespace

FlagGroup nest_flags() {
  return {"How the pieces are laid on the material",
          {{"--sheet",
            "[MATERIAL=]WIDTH[xLENGTH]",
            "lay all pieces on a roll, as 1500mm, or on sheets, as 1500mmx1000mm; cotton=1400mm is "
            "for pieces of that material; may be repeated, or separated by commas",
            0,
            false,
            {.repeats = true}},
           {"--nest-gap",
            "LENGTH",
            "free distance between pieces (default 5mm)",
            0,
            false,
            {.range = {.min = 0.0}, .standard = "5mm"}},
           {"--nest-margin",
            "LENGTH",
            "free distance along the edges of the sheet (default 0)",
            0,
            false,
            {.range = {.min = 0.0}, .standard = "0"}},
           {"--nest-in-holes", "", "let small pieces lie in the holes of larger ones"},
           {"--folded-cloth", "",
            "the roll is folded along its length: pieces are cut in pairs, and halves with their "
            "fold on the fold of the cloth"},
           {"--turn",
            "KIND",
            "how far pieces may be turned from their grain: " + list_of(names_of(k_turns)) +
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

/// As "1500mm" and "1500mmx1000mm".
NestOptions sheet_size(const Arguments& arguments, const std::string& text,
                       const NestOptions& usual) {
  constexpr double above_zero = std::numeric_limits<double>::min();
  const std::size_t sign = text.find('x');
  NestOptions sheets = usual;
  sheets.width = sheet_width(arguments, text.substr(0, sign));
  if (sign != std::string::npos) {
    if (sheets.folded) throw UsageError("--folded-cloth goes with rolls only, as --sheet 1500mm");
    sheets.length = nest_length(arguments, "--sheet", text.substr(sign + 1), above_zero);
  }
  if (sheets.folded) sheets.width *= 0.5;
  const double shorter = std::min(sheets.width, sheets.length.value_or(sheets.width));
  check_range("--nest-margin", sheets.margin, {0.0, 0.5 * shorter});
  return sheets;
}

const NestOptions& SheetSizes::of(const std::string& material) const {
  const auto own = of_material.find(material);
  if (own != of_material.end()) return own->second;
  if (usual) return *usual;
  throw Error(ErrorCode::unknown_name,
              "--sheet has no size for " +
                  (material.empty() ? "pieces without a material" : "\"" + material + "\"") +
                  "; give one for all others too, as --sheet 1500mm");
}

std::optional<SheetSizes> sheets_from(const Arguments& arguments) {
  if (!arguments.has("--sheet")) {
    for (const char* flag :
         {"--nest-gap", "--nest-margin", "--nest-in-holes", "--folded-cloth", "--turn"}) {
      if (!arguments.has(flag)) continue;
      throw UsageError("flag " + std::string(flag) + " goes with --sheet only");
    }
    return std::nullopt;
  }
  NestOptions all;
  const auto length_or = [&](const char* flag, double usual) {
    return arguments.has(flag) ? nest_length(arguments, flag, arguments.value(flag), 0.0) : usual;
  };
  all.gap = length_or("--nest-gap", all.gap);
  all.margin = length_or("--nest-margin", all.margin);
  all.turns = turns_from(arguments);
  all.folded = arguments.has("--folded-cloth");
  all.in_holes = arguments.has("--nest-in-holes");
  SheetSizes sheets;
  for (const Field& field : arguments.fields("--sheet")) {
    const std::string text = field_text(field);
    const std::size_t sign = text.rfind('=');
    const bool is_named = sign != std::string::npos;
    const std::string material = is_named ? text.substr(0, sign) : "";
    const NestOptions size = sheet_size(arguments, is_named ? text.substr(sign + 1) : text, all);
    if (is_named ? sheets.of_material.contains(material) : sheets.usual.has_value())
      throw UsageError("--sheet has two sizes for " + (is_named ? material : "all materials"));
    if (is_named)
      sheets.of_material[material] = size;
    else
      sheets.usual = size;
  }
  return sheets;
}

namespace {

/// The patches as they are laid, on cloth that lies double or not.
DoubleCloth as_laid(std::vector<NestPatch> patches, Unit unit, bool is_folded) {
  if (is_folded) return on_double_cloth(std::move(patches));
  return {with_mirror_images(with_folds_opened(std::move(patches), unit))};
}

/// Says which pieces are no pairs.
void note_single(const std::vector<DoubleCloth::Single>& single, Session& session) {
  for (const DoubleCloth::Single& piece : single) {
    const std::string count =
        piece.copies == 1 ? "one copy" : std::to_string(piece.copies) + " copies";
    session.note(piece.name + ": cut " + count + " from one layer of the folded cloth alone, as " +
                 (piece.copies == 1 ? "it has" : "they have") + " no mirror image");
  }
}

}  // namespace

SheetFit fit_alone(NestPatch patch, Unit unit, const SheetSizes& sizes) {
  try {
    const NestOptions& sheets = sizes.of(patch.annotations.label.fabric);
    const NestJob job{as_laid({std::move(patch)}, unit, sheets.folded).patches, unit, sheets};
    try {
      const Nesting nesting = nest(nest_pieces(job), sheets);
      return {true, material_text(sheets, nesting.sheets), "alone, " + use_text(sheets, nesting)};
    } catch (const Error& error) {
      if (error.code() != ErrorCode::piece_too_large) return {};
      return {false, material_text(sheets, 1), error.what()};
    }
  } catch (const Error&) {
    return {};
  }
}

namespace {

const std::string& material_of(const NestPatch& patch) {
  return patch.annotations.label.fabric;
}

/// Materials in the order of the patches.
std::vector<std::string> materials_of(const std::vector<NestPatch>& patches) {
  std::vector<std::string> materials;
  for (const NestPatch& patch : patches) {
    if (patch.pattern.empty()) continue;
    const std::string& material = material_of(patch);
    if (std::find(materials.begin(), materials.end(), material) == materials.end())
      materials.push_back(material);
  }
  return materials;
}

/// Refuses sheets of a material that no piece has.
void check_materials(const SheetSizes& sheets, const std::vector<std::string>& materials) {
  for (const auto& [material, size] : sheets.of_material) {
    if (std::find(materials.begin(), materials.end(), material) != materials.end()) continue;
    std::vector<std::string> named = materials;
    std::erase(named, "");
    throw Error(ErrorCode::unknown_name,
                "--sheet: no piece is of \"" + material + "\"" + nearest_hint(material, named) +
                    (named.empty() ? "; --material or --fabric names it"
                                   : " (there are " + list_of_some(named) + ")"));
  }
}

/// Where a piece could be divided: a line across the middle of its length, for --cut.
std::string dividing_line(const NestPatch& patch, const NestPiece& piece) {
  const NestPlacement turn{.angle = piece.angle};
  const std::vector<std::vector<Index>> loops = Patch(patch.mesh).border_loops();
  std::vector<Vec2> places;
  places.reserve(patch.pattern.size());
  for (const Vec2 p : patch.pattern)
    places.push_back(turn(p));
  double left = std::numeric_limits<double>::infinity(), right = -left;
  for (const Vec2 p : places) {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
  }
  const double middle = 0.5 * (left + right);
  std::optional<Index> lowest, highest;
  for (const std::vector<Index>& loop : loops) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Index a = loop[k], b = loop[(k + 1) % loop.size()];
      if ((places[a].x < middle) == (places[b].x < middle)) continue;
      if (!lowest || places[a].y < places[*lowest].y) lowest = a;
      if (!highest || places[a].y > places[*highest].y) highest = a;
    }
  }
  if (!lowest || *lowest == *highest) return {};
  const auto text = [&](Index v) {
    const Vec3& p = patch.mesh.positions[v];
    return short_number(p.x) + "," + short_number(p.y) + "," + short_number(p.z);
  };
  return "; across the middle of its length: --cut \"line " + text(*lowest) + " " + text(*highest) +
         "\"";
}

/// As nest(), but says of a piece that fits on no sheet where it could be divided.
Nesting nest_job(const NestJob& job, const Context& context) {
  const std::vector<NestPiece> pieces = nest_pieces(job);
  try {
    return nest(pieces, job.sheets, context);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::piece_too_large) throw;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      try {
        nest({&pieces[p], 1}, job.sheets);
      } catch (const Error& own) {
        throw Error(own.code(), own.message() + dividing_line(job.patches[p], pieces[p]));
      }
    }
    throw;
  }
}

/// What the names of its files begin with. One layout alone is "layout".
std::vector<std::string> stems_of(const std::vector<std::string>& materials) {
  if (materials.size() < 2) return {"layout"};
  std::vector<std::string> stems = safe_names(materials);
  for (std::size_t m = 0; m < materials.size(); ++m)
    stems[m] = materials[m].empty() ? "layout" : "layout-" + stems[m];
  return stems;
}

}  // namespace

std::string words_of(const std::vector<SheetFit>& layouts) {
  std::string words;
  for (const SheetFit& some : layouts)
    words += (words.empty() ? "" : "; ") + some.material + ": " + some.use;
  return words;
}

NestOutcome nest_patches(std::vector<NestPatch> patches, Unit unit, const NestRequest& request,
                         const std::filesystem::path& folder, const std::string& title,
                         Session& session) {
  const std::vector<std::string> materials = materials_of(patches);
  check_materials(request.sheets, materials);
  const std::vector<std::string> stems = stems_of(materials);
  NestOutcome outcome;
  outcome.text = "\n";
  DoubleCloth laid = as_laid(std::move(patches), unit, request.sheets.any().folded);
  note_single(laid.single, session);
  patches = std::move(laid.patches);
  for (std::size_t m = 0; m < materials.size(); ++m) {
    const std::string& material = materials[m];
    NestJob job{{}, unit, request.sheets.of(material)};
    for (const NestPatch& patch : patches) {
      if (!patch.pattern.empty() && material_of(patch) == material) job.patches.push_back(patch);
    }
    Nesting nesting = nest_job(job, session.job_context(title));
    std::vector<Drawing> sheets;
    const bool is_one = materials.size() == 1 || material.empty();
    for (std::size_t s = 0; s < nesting.sheets; ++s)
      sheets.push_back(nest_sheet(job, nesting, s, is_one ? title : title + ", " + material));
    std::vector<OutputFile> files = layout_files(sheets, request, folder, stems[m]);
    const std::string named = materials.size() == 1 ? "" : material;
    outcome.text += layout_text(named, job.sheets, nesting);
    outcome.layouts.push_back(
        {true, (named.empty() ? "" : named + " on ") + material_text(job.sheets, nesting.sheets),
         use_text(job.sheets, nesting)});
    std::move(sheets.begin(), sheets.end(), std::back_inserter(outcome.sheets));
    std::move(files.begin(), files.end(), std::back_inserter(outcome.files));
    add_layout(material, job, nesting, outcome.layout);
  }
  for (const NestPatch& patch : patches) {
    if (!patch.pattern.empty()) continue;
    outcome.layout.left_out.push_back(patch.name);
    outcome.text += "  without " + patch.name + "\n";
  }
  for (const OutputFile& file : outcome.files)
    outcome.layout.files.push_back(utf8_of(file.path));
  return outcome;
}

NestOutcome try_nest_patches(std::vector<NestPatch> patches, Unit unit, const NestRequest& request,
                             const std::filesystem::path& folder, const std::string& title,
                             Session& session) {
  try {
    return nest_patches(std::move(patches), unit, request, folder, title, session);
  } catch (const Error&) {
    NestOutcome outcome;
    outcome.layout.sheets = request.sheets.any();
    outcome.layout.failure = current_failure();
    return outcome;
  }
}

ProductPages product_pages(std::vector<NestPatch> patches, Unit unit, const NestOptions* sheets,
                           const PatternOutput& output, const std::filesystem::path& folder,
                           const std::string& title, Session& session) {
  NestJob job{with_mirror_images(with_folds_opened(std::move(patches), unit)), unit,
              sheets != nullptr ? *sheets : NestOptions{.turns = Turns::free}};
  job.sheets.folded = false;
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
