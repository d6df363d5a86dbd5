#include "flags/constraint_flags.h"

#include <planish/io/mesh_format.h>
#include <planish/io/read_features.h>

#include "flags/method_flags.h"
#include "flags/scale_flag.h"
#include "flags/units.h"
#include "platform/path.h"
#include "shell/failures.h"
#include "shell/session.h"
#include "shell/text.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

void refuse(const std::string& flag, const Method& method, bool (*honours)(const Method&)) {
  std::vector<std::string> able;
  for (const std::string& name : method_names()) {
    if (honours(method_named(name))) able.push_back(name);
  }
  throw UsageError("method " + std::string(name_of(method)) + " cannot honour " + flag +
                   (able.empty() ? "; no method can" : "; take --method " + list_of(able)));
}

std::vector<Index> fixed_in(const Arguments& arguments, const Patch& patch, Session& session) {
  const std::string path = arguments.text("--fix");
  const FixedVertices fixed =
      arguments.rows.contains("--fix")
          ? FixedVertices{fixed_vertices_in(arguments.rows_of("--fix"), patch.vertex_count())}
          : read_fixed_vertices(path_of(path), as_in_file(patch, arguments));
  std::string text = path + ": fixed vertices: " + std::to_string(fixed.vertices.size());
  if (fixed.farthest > 0.0) {
    text += "; what is drawn is at most " + digits(scale_from(arguments) * fixed.farthest, 3) +
            " from them";
  }
  session.note(text);
  return fixed.vertices;
}

TriMesh obstacle_from(const Arguments& arguments, Session& session) {
  const std::string path = arguments.text("--obstacle");
  const double scale = scale_from(arguments);
  const auto given = arguments.meshes.find("--obstacle");
  if (given != arguments.meshes.end()) return scaled(given->second, scale, path);
  ReadResult file = session.read(path, {.strict = arguments.has("--strict")});
  file = in_run_unit(std::move(file), run_unit_from(arguments), path, session);
  return scaled(std::move(file.mesh), scale, path);
}

}  // namespace

FlagGroup constraint_flags() {
  return {"What must stay besides the border",
          {{"--fix", "FILE",
            "vertices that stay where they are: a list of numbers from 0, or an .obj whose lines "
            "and points are moved to the nearest vertices"},
           {"--weights", "FILE",
            "weights of vertices against moving, one a line: number of the vertex, from 0, and its "
            "weight"},
           {"--obstacle",
            "FILE",
            "a closed mesh that the surface must not enter",
            0,
            false,
            {.extensions = names_of(k_mesh_formats)}}}};
}

void refuse_unsupported_constraints(const Arguments& arguments, const Method& method) {
  if (arguments.has("--weights") && !honours_weights(method)) {
    refuse("--weights", method, honours_weights);
  }
  if (arguments.has("--obstacle") && !honours_obstacle(method)) {
    refuse("--obstacle", method, honours_obstacle);
  }
}

Constraints constraints_from(const Arguments& arguments, const Patch& patch, Session& session) {
  Constraints constraints;
  if (arguments.has("--fix")) {
    constraints.fixed = fixed_in(arguments, patch, session);
  }
  if (arguments.has("--weights")) {
    constraints.weights = weights_in(arguments.rows_of("--weights"), patch.vertex_count());
  }
  if (arguments.has("--obstacle")) {
    constraints.obstacle = obstacle_from(arguments, session);
  }
  return constraints;
}

}  // namespace planish::cli
