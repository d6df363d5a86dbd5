#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <planish/core/unit.h>
#include <planish/io/model.h>

#include "shell/command.h"
#include "shell/session.h"

namespace planish::cli {

/// The flags that choose and repair the pieces of a file, shared by all verbs that read a mesh:
/// --divide, --only, --weld and more.
FlagGroup model_flags();

/// @param known names of which some may have commas: those in --only and --without are taken whole
/// @throws UsageError for what is no length and for unknown names, Error option_out_of_range
ModelOptions model_options_from(const Arguments& arguments,
                                std::span<const std::string> known = {});

/// The names in a file before it is prepared: of objects, groups and materials, and its own.
std::vector<std::string> names_in(const ReadResult& file, const std::string& name);

/// @throws UsageError, Error unknown_name where --only or --without has another name than those
void check_asked_names(const Arguments& arguments, std::span<const std::string> names);

/// @throws Error unknown_name, and no_triangles where the flags leave nothing of the file
void check_model(const Model& model, const Arguments& arguments, const std::string& path);

/// Reads a mesh as Session::read() does, multiplies its coordinates by --scale, and prepares it as
/// the flags ask. One piece that is inside out against those left out is turned over, but with
/// --strict. Prints a note for every change that it makes.
/// @throws Error as Session::read(), prepare_model() and check_model()
Model read_model(const std::string& path, const Arguments& arguments, Session& session);

/// One of several files of a product.
struct FileOfSeveral {
  std::string path;
  std::string name;  ///< for pieces that have no name in the file
  /// Where a product file states it; overrides --unit and the file itself.
  std::optional<Unit> unit = {};
  std::vector<std::string> known = {};  ///< names with commas that pieces get later
};

/// read_model() for one of several files: --only and --without may name pieces of the other files,
/// so the result may be empty. No piece is turned over.
Model read_model_of_several(const FileOfSeveral& file, const Arguments& arguments,
                            Session& session);

/// read_model() for verbs that work on the whole mesh. Pieces get vertices of their own, except
/// with --strict, which leaves the mesh as it is.
TriMesh read_whole(const std::string& path, const Arguments& arguments, Session& session);

/// read_model() for verbs that take one piece.
/// @throws Error several_components where the file holds several, naming them
Model read_piece(const std::string& path, const Arguments& arguments, Session& session);

}  // namespace planish::cli
