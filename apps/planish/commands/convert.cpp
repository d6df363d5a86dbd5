#include <planish/io/mesh_format.h>

#include "commands/commands.h"
#include "flags/units.h"
#include "model/model_flags.h"
#include "platform/path.h"
#include "shell/session.h"
#include "shell/values.h"
#include "text/json_text.h"
#include "text/summary.h"

namespace planish::cli {

namespace {

CommandResult run_convert(const Arguments& arguments, Session& session) {
  const std::string& path = arguments.operands[0];
  const std::string& output = arguments.operands[1];
  const MeshFormat format = mesh_format_of(path_of(output));
  const TriMesh mesh = read_model(path, arguments, session).mesh;
  if (format == MeshFormat::stl) {
    session.note("STL rounds positions to single precision and loses the order of the vertices");
  }
  CommandResult outcome = {path + " -> " + output + "  (" + size_text(mesh) + ")\n",
                           json_written(mesh, output)};
  session.write({{path_of(output), format_mesh(mesh, format)}});
  return outcome;
}

}  // namespace

Command convert_command() {
  return {"convert",
          "write a mesh in another format",
          "INPUT OUTPUT",
          "Reads a triangle mesh and writes it in the format of OUTPUT's extension: .obj, .ply, "
          ".stl or .off. Vertices and triangles keep their order, and positions keep every digit "
          "(STL: single precision).",
          {"INPUT", "OUTPUT"},
          {{"Output", {unit_flag()}}, model_flags()},
          {"planish convert panel.stl panel.obj"},
          run_convert,
          false,
          false,
          {{.extensions = names_of(k_mesh_formats)}, {.extensions = names_of(k_mesh_formats)}}};
}

}  // namespace planish::cli
