#include <algorithm>
#include <cmath>

#include <planish/core/error.h>
#include <planish/io/mesh_format.h>

#include "core/number_text.h"
#include "io/file/append.h"
#include "io/formats/formats.h"
#include "io/formats/vtk.h"

namespace planish {

namespace {

bool is_name(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

void check_fields(const std::vector<MeshField>& fields, std::size_t count) {
  for (const MeshField& field : fields) {
    if (!is_name(field.name)) {
      throw Error(ErrorCode::option_out_of_range,
                  "the name of a field has letters, digits and underscores only");
    }
    if (field.values.size() == count) continue;
    throw Error(ErrorCode::option_out_of_range, "field " + field.name + " has " +
                                                    std::to_string(field.values.size()) +
                                                    " values instead of " + std::to_string(count));
  }
}

void check(const TriMesh& mesh, const MeshFields& fields) {
  check_writable(mesh, MeshFormat::ply);
  check_fields(fields.vertices, mesh.positions.size());
  check_fields(fields.triangles, mesh.triangles.size());
}

void append_properties(std::string& text, const std::vector<MeshField>& fields) {
  for (const MeshField& field : fields)
    text += "property double " + field.name + "\n";
}

void append_numbers(std::string& text, const std::vector<MeshField>& fields, std::size_t at) {
  for (const MeshField& field : fields) {
    text += ' ';
    append_number(text, field.values[at]);
  }
  text += '\n';
}

/// In ASCII: some readers, meshio among them, cannot read properties beside a list in binary files.
std::string format_ascii_ply(const TriMesh& mesh, const MeshFields& fields) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex ";
  append_integer(text, mesh.positions.size());
  text += "\nproperty double x\nproperty double y\nproperty double z\n";
  append_properties(text, fields.vertices);
  text += "element face ";
  append_integer(text, mesh.triangles.size());
  text += "\nproperty list uchar int vertex_indices\n";
  append_properties(text, fields.triangles);
  text += "end_header\n";
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3 p = mesh.positions[v];
    append_number(text, p.x);
    text += ' ';
    append_number(text, p.y);
    text += ' ';
    append_number(text, p.z);
    append_numbers(text, fields.vertices, v);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    text += '3';
    for (const Index v : mesh.triangles[t]) {
      text += ' ';
      append_integer(text, v);
    }
    append_numbers(text, fields.triangles, t);
  }
  return text;
}

void append_names(std::string& csv, const std::vector<MeshField>& fields) {
  for (const MeshField& field : fields)
    csv += ',' + field.name;
  csv += '\n';
}

void append_value(std::string& csv, double value) {
  csv += ',';
  if (std::isfinite(value)) append_number(csv, value);
}

void append_values(std::string& csv, const std::vector<MeshField>& fields, std::size_t at) {
  for (const MeshField& field : fields)
    append_value(csv, field.values[at]);
  csv += '\n';
}

}  // namespace

std::string_view to_string(FieldFormat format) {
  switch (format) {
    case FieldFormat::ply:
      return "ply";
    case FieldFormat::vtp:
      return "vtp";
    case FieldFormat::vtu:
      break;
  }
  return "vtu";
}

std::string format_fields(const TriMesh& mesh, const MeshFields& fields, FieldFormat format) {
  check(mesh, fields);
  switch (format) {
    case FieldFormat::ply:
      return format_ascii_ply(mesh, fields);
    case FieldFormat::vtp:
      return format_vtk(mesh, fields, VtkCells::polygons);
    case FieldFormat::vtu:
      break;
  }
  return format_vtk(mesh, fields, VtkCells::triangles);
}

std::string vertex_fields_csv(const TriMesh& mesh, const MeshFields& fields) {
  check(mesh, fields);
  std::string csv = "vertex,x,y,z";
  append_names(csv, fields.vertices);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    append_integer(csv, v);
    const Vec3 p = mesh.positions[v];
    for (const double c : {p.x, p.y, p.z})
      append_value(csv, c);
    append_values(csv, fields.vertices, v);
  }
  return csv;
}

std::string triangle_fields_csv(const TriMesh& mesh, const MeshFields& fields) {
  check(mesh, fields);
  std::string csv = "triangle,a,b,c";
  append_names(csv, fields.triangles);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    append_integer(csv, t);
    for (const Index v : mesh.triangles[t]) {
      csv += ',';
      append_integer(csv, v);
    }
    append_values(csv, fields.triangles, t);
  }
  return csv;
}

}  // namespace planish
