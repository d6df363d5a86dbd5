#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <planish/mesh/tri_mesh.h>

#include "shell/command.h"

namespace planish::cli {

/// --cut, for verbs that take a patch.
Flag cut_flag();

/// What --cut did to a mesh.
struct CutDone {
  std::size_t edges = 0;
  double length = 0.0;  ///< model units
};

/// The mesh as the verb is to work on it: cut open where --cut says so, which is told.
struct CutInput {
  TriMesh mesh;
  std::optional<CutDone> cut = {};
};

/// @throws Error as read_cuts() and cut_open()
CutInput cut_as_asked(TriMesh mesh, const std::string& path, const Arguments& arguments,
                      Session& session);

/// A report with what --cut did as "cut": {"edges", "length"}, or as it is without the flag.
std::string json_with_cut(const std::string& report, const std::optional<CutDone>& cut);

}  // namespace planish::cli
