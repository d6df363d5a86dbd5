#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <planish/flatten/product.h>
#include <planish/pattern/nest.h>
#include <planish/pattern/pattern_options.h>

#include "shell/command.h"
#include "shell/session.h"

namespace planish::cli {

/// One setting of a piece, as "allowance=12mm".
struct PieceSetting {
  std::string key;    ///< as check_piece_key() has them
  std::string value;  ///< as behind the flag of that name; "none": without that flag
};

/// What is asked for a piece by its name.
struct NamedSettings {
  std::string piece;  ///< also of what is made of it: "NAME-1", "NAME, mirrored"
  std::vector<PieceSetting> settings;
  std::string from;  ///< what errors call the place: "--piece front"
};

/// What is asked for one patch in the end: what the flags say, then a product file, then --piece;
/// the last one counts.
struct PieceRequest {
  PatternOptions annotations = {};         ///< without notches on seams
  std::optional<Turns> turns = {};         ///< on sheets; none: those of all
  std::optional<std::string> name = {};    ///< another name than the one it has
  std::map<std::string, std::string> own;  ///< its settings; of a file with a hash of what it holds
};

/// --piece
Flag piece_flag();

/// What --piece says, in the order in which it is given.
/// @throws UsageError for what is no NAME:KEY=VALUE, and for unknown keys
std::vector<NamedSettings> piece_settings_from(const Arguments& arguments);

/// The arguments with --without for the pieces that --piece leaves out.
/// @throws UsageError where such a piece has other settings too; as piece_settings_from()
Arguments without_pieces_out(const Arguments& arguments);

/// Whether a piece of a product file stays out, as the file says or --piece in its place.
bool stays_out(const NamedSettings& in_file, const Arguments& arguments);

/// What is asked for each patch. Sets what of it flattening needs: limits, folds, quantities.
/// @param in_file of a product file, whose paths are relative to where the program runs
/// @param usual what the flags ask of all
/// @throws UsageError for a piece that is not there, and names the nearest one; for settings that
///   contradict each other; Error as annotations_from() and check_pattern_options()
std::vector<PieceRequest> piece_requests(std::vector<ProductPatch>& patches,
                                         std::span<const NamedSettings> in_file,
                                         const PatternOptions& usual, const Arguments& arguments,
                                         Session& session);

}  // namespace planish::cli
