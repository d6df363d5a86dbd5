#include "flags/fields_flag.h"

#include <array>
#include <optional>
#include <string>

#include <planish/core/error.h>
#include <planish/io/mesh_format.h>

#include "platform/path.h"
#include "shell/file_name.h"

namespace planish::cli {

namespace {

/// Nothing where no mesh format of fields has the extension.
std::optional<FieldFormat> format_of(const std::string& path) {
  const std::string extension = lower_extension(path);
  for (const FieldFormat format : {FieldFormat::ply, FieldFormat::vtp, FieldFormat::vtu}) {
    if (extension == "." + std::string(to_string(format))) return format;
  }
  return std::nullopt;
}

/// folder/name-vertices.csv of folder/name.csv.
std::string with_suffix(const std::string& path, const std::string& suffix) {
  const std::string extension = extension_of(path);
  return path.substr(0, path.size() - extension.size()) + suffix + extension;
}

}  // namespace

Flag fields_flag() {
  return {"--fields",
          "FILE",
          "write figures of every vertex and triangle (defect, mean curvature, strain; with "
          "flatten also the move from the design): .ply, .vtp, .vtu, or .csv for NAME-vertices.csv "
          "and NAME-triangles.csv",
          0,
          false,
          {.extensions = {"ply", "vtp", "vtu", "csv"}}};
}

WrittenFiles fields_paths(const Arguments& arguments) {
  if (!arguments.has("--fields")) return {};
  const std::string path = arguments.text("--fields");
  if (format_of(path)) return {{"fields", path}};
  if (lower_extension(path) != ".csv") {
    throw Error(ErrorCode::unsupported_format,
                "--fields names the file that holds all fields: .ply, .vtp, .vtu or .csv, as "
                "fields.ply",
                {.path = path});
  }
  return {{"fields_vertices", with_suffix(path, "-vertices")},
          {"fields_triangles", with_suffix(path, "-triangles")}};
}

std::vector<OutputFile> fields_files(const TriMesh& mesh, const MeshFields& fields,
                                     const WrittenFiles& paths) {
  std::vector<OutputFile> files;
  for (const auto& [role, path] : paths) {
    if (role == "fields") {
      files.push_back({path_of(path), format_fields(mesh, fields, *format_of(path))});
    } else if (role == "fields_vertices") {
      files.push_back({path_of(path), vertex_fields_csv(mesh, fields)});
    } else if (role == "fields_triangles") {
      files.push_back({path_of(path), triangle_fields_csv(mesh, fields)});
    }
  }
  return files;
}

}  // namespace planish::cli
