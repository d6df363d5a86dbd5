#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <planish/flatten/flatten.h>
#include <planish/report/json_report.h>
#include <planish/sheet/nest_sheet.h>

#include "output/pattern_output.h"
#include "shell/command.h"
#include "shell/session.h"

namespace planish::cli {

/// All ways in which pieces may be turned, the usual one first.
inline constexpr std::array k_turns = {Turns::half, Turns::none, Turns::quarter, Turns::free};

/// The sheets that pieces are cut from. All have the same gap, margin and turns.
struct SheetSizes {
  std::optional<NestOptions> usual = {};           ///< for all other materials
  std::map<std::string, NestOptions> of_material;  ///< by the material's name

  /// @throws Error unknown_name where there are none for the material
  const NestOptions& of(const std::string& material) const;
  /// What holds for all of them.
  const NestOptions& any() const { return usual ? *usual : of_material.begin()->second; }
};

/// How patches are laid on sheets, and how that is written.
struct NestRequest {
  SheetSizes sheets;
  std::vector<PatternFormat> formats;
  PatternOutput output;
};

/// --sheet and how pieces lie on it: gaps, margins, holes, folded cloth, turns.
FlagGroup nest_flags();

/// What the flags ask for; nothing without --sheet.
/// @throws UsageError, Error option_out_of_range
std::optional<SheetSizes> sheets_from(const Arguments& arguments);

/// Whether patches fit on sheets of one material, in words.
struct SheetFit {
  bool fits = false;
  std::string material;  ///< what it is laid on
  std::string use;       ///< how much of it they take, or why they do not fit
};

/// What came of laying patches on sheets.
struct NestOutcome {
  std::vector<Drawing> sheets;         ///< a drawing of each
  std::vector<OutputFile> files;       ///< of these, in every format
  LayoutReport layout;                 ///< or why there is none
  std::string text;                    ///< as people read it
  std::vector<SheetFit> layouts = {};  ///< of each material
};

/// In one sentence.
std::string words_of(const std::vector<SheetFit>& layouts);

/// From any thread. Without a material where it is not known: laying all patches then says why.
SheetFit fit_alone(NestPatch patch, Unit unit, const SheetSizes& sheets);

/// Lays patches on sheets, those of each material on sheets of their own.
/// @param folder of the drawings
/// @throws Cancelled; Error as nest(), nest_pieces(), nest_sheet() and SheetSizes::of()
NestOutcome nest_patches(std::vector<NestPatch> patches, Unit unit, const NestRequest& request,
                         const std::filesystem::path& folder, const std::string& title,
                         Session& session);

/// The same, but an Error is not thrown: it is in NestOutcome's layout as its failure.
NestOutcome try_nest_patches(std::vector<NestPatch> patches, Unit unit, const NestRequest& request,
                             const std::filesystem::path& folder, const std::string& title,
                             Session& session);

/// All patches on pages to be joined.
struct ProductPages {
  std::vector<OutputFile> files;        ///< one; none where it failed
  std::string text = {};                ///< as people read it
  std::optional<Failure> failure = {};  ///< why there are none
};

/// Lays patches on pages of paper. Where that fails there are no files, and `failure` says why.
/// @param sheets of --sheet, for the gap and the turns; without them pieces turn freely
/// @param output with pages
/// @throws Cancelled
ProductPages product_pages(std::vector<NestPatch> patches, Unit unit, const NestOptions* sheets,
                           const PatternOutput& output, const std::filesystem::path& folder,
                           const std::string& title, Session& session);

/// Ends with exit code 1 where the patches could not be laid on the sheets.
CommandResult with_nesting_checked(CommandResult outcome,
                                   const std::optional<NestOutcome>& nesting);
/// The same of pages.
CommandResult with_pages_checked(CommandResult outcome, const ProductPages& pages);

}  // namespace planish::cli
