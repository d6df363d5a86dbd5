#include <planish/io/mesh_format.h>
#include <planish/mesh/shapes.h>

#include "commands/commands.h"
#include "platform/path.h"
#include "shell/session.h"
#include "shell/text.h"
#include "shell/values.h"
#include "text/json_text.h"
#include "text/summary.h"

namespace planish::cli {

namespace {

constexpr Range k_vertices = {100, 10'000'000};

std::vector<std::string> shape_names() {
  std::vector<std::string> names;
  for (const Shape& shape : shapes())
    names.emplace_back(shape.name);
  return names;
}

CommandResult list_samples() {
  std::string text;
  for (const Shape& shape : shapes()) {
    text += left(std::string(shape.name), 12) + wrapped(shape.description, 12) + "\n";
  }
  return {text, json_samples(shapes())};
}

CommandResult run_sample(const Arguments& arguments, Session& session) {
  if (arguments.has("--list")) return list_samples();
  const std::string output = arguments.text("--output");
  const MeshFormat format = mesh_format_of(path_of(output));
  const std::string name = known_name("sample", arguments.operands.front(), shape_names());
  const Field vertices = arguments.value("--vertices", 5000);
  const TriMesh mesh = make_shape(
      name, static_cast<std::size_t>(whole_number_of("--vertices", vertices, k_vertices)));
  CommandResult outcome = {name + " -> " + output + "  (" + size_text(mesh) + ")\n",
                           json_written(mesh, output)};
  session.write({{path_of(output), format_mesh(mesh, format)}});
  return outcome;
}

}  // namespace

Command sample_command() {
  return {"sample",
          "write a built-in patch made by formula",
          "NAME -o OUTPUT",
          "Writes one of the built-in patches: " + list_of(shape_names()) +
              ". They are in millimetres, a few hundred across, and jittered like real meshes; the "
              "same name and size always give the same mesh.",
          {"NAME"},
          {{"Output",
            {{"--output",
              "OUTPUT",
              "the mesh: .obj, .ply, .stl or .off",
              'o',
              true,
              {.extensions = names_of(k_mesh_formats)}},
             {"--vertices",
              "N",
              "about how many vertices (100 to 10000000, default 5000)",
              0,
              false,
              {.range = k_vertices, .standard = "5000"}},
             {"--list", "", "list all names with a short description, and end"}}}},
          {"planish sample panel -o panel.obj", "planish sample dome --vertices 100000 -o dome.ply",
           "planish sample --list"},
          run_sample,
          false,
          false,
          {{.choices = shape_names()}}};
}

}  // namespace planish::cli
