#pragma once

#include <vector>

#include <planish/io/mesh_format.h>
#include <planish/io/write_file.h>
#include <planish/report/json_report.h>

#include "shell/command.h"

namespace planish::cli {

/// --fields, a figure of every vertex and triangle as a file.
Flag fields_flag();

/// Role -> path of the files that --fields asks for: "fields", or for a .csv "fields_vertices" and
/// "fields_triangles". None without the flag.
/// @throws Error unsupported_format for an extension that no format has
WrittenFiles fields_paths(const Arguments& arguments);

/// These files with their content.
/// @param paths as from fields_paths(); other roles are passed over
std::vector<OutputFile> fields_files(const TriMesh& mesh, const MeshFields& fields,
                                     const WrittenFiles& paths);

}  // namespace planish::cli
