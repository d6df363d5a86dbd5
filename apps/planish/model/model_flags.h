#pragma once

#include <optional>
#include <string>

#include <planish/core/unit.h>
#include <planish/io/model.h>

#include "shell/command.h"
#include "shell/session.h"

namespace planish::cli {

/// The flags that choose and repair the pieces of a file, shared by all verbs that read a mesh:
/// --divide, --only, --weld and more.
FlagGroup model_flags();

/// @throws UsageError for what is no length and for unknown names, Error option_out_of_range
ModelOptions model_options_from(const Arguments& arguments);

/// @throws Error unknown_name, and no_triangles where the options leave nothing of the file
void check_model(const Model& model, const ModelOptions& options, const std::string& path);

/// Reads a mesh as Session::read() does, multiplies its coordinates by --scale, and prepares it as
/// the flags ask. Prints a note for every change that it makes.
/// @throws Error as Session::read(), prepare_model() and check_model()
Model read_model(const std::string& path, const Arguments& arguments, Session& session);

/// The same for one of several files: --only and --without may name pieces of the other files, so
/// the result may be empty.
/// @param name for pieces that have no name in the file
/// @param unit of the file where a product file states it; overrides --unit and the file itself
Model read_model_of_several(const std::string& path, const std::string& name,
                            std::optional<Unit> unit, const Arguments& arguments, Session& session);

/// read_model() for verbs that work on the whole mesh. Pieces get vertices of their own, except
/// with --strict, which leaves the mesh as it is.
TriMesh read_whole(const std::string& path, const Arguments& arguments, Session& session);

/// read_model() for verbs that take one piece.
/// @throws Error several_components where the file holds several, naming them
Model read_piece(const std::string& path, const Arguments& arguments, Session& session);

}  // namespace planish::cli
