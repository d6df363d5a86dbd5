#include "io/formats/vtk.h"

#include "core/number_text.h"
#include "io/file/append.h"

namespace planish {

namespace {

/// @param rest attributes behind type and name
void begin_array(std::string& xml, const std::string& type, const std::string& name,
                 const std::string& rest = {}) {
  xml += "<DataArray type=\"" + type + "\" Name=\"" + name + "\"" + rest + " format=\"ascii\">\n";
}

void end_array(std::string& xml) {
  xml += "</DataArray>\n";
}

void append_fields(std::string& xml, const std::string& element,
                   const std::vector<MeshField>& fields) {
  xml += "<" + element + ">\n";
  for (const MeshField& field : fields) {
    begin_array(xml, "Float64", field.name);
    for (const double value : field.values) {
      append_number(xml, value);
      xml += '\n';
    }
    end_array(xml);
  }
  xml += "</" + element + ">\n";
}

void append_points(std::string& xml, const std::vector<Vec3>& positions) {
  xml += "<Points>\n";
  begin_array(xml, "Float64", "Points", " NumberOfComponents=\"3\"");
  for (const Vec3& p : positions) {
    append_number(xml, p.x);
    xml += ' ';
    append_number(xml, p.y);
    xml += ' ';
    append_number(xml, p.z);
    xml += '\n';
  }
  end_array(xml);
  xml += "</Points>\n";
}

void append_cells(std::string& xml, const std::vector<Triangle>& triangles, VtkCells cells) {
  const std::string element = cells == VtkCells::polygons ? "Polys" : "Cells";
  xml += "<" + element + ">\n";
  begin_array(xml, "Int64", "connectivity");
  for (const Triangle& triangle : triangles) {
    for (const Index v : triangle) {
      append_integer(xml, v);
      xml += ' ';
    }
    xml.back() = '\n';
  }
  end_array(xml);
  begin_array(xml, "Int64", "offsets");
  for (std::size_t t = 1; t <= triangles.size(); ++t) {
    append_integer(xml, 3 * t);
    xml += '\n';
  }
  end_array(xml);
  if (cells == VtkCells::triangles) {
    begin_array(xml, "UInt8", "types");
    for (std::size_t t = 0; t < triangles.size(); ++t)
      xml += "5\n";  // VTK_TRIANGLE
    end_array(xml);
  }
  xml += "</" + element + ">\n";
}

}  // namespace

std::string format_vtk(const TriMesh& mesh, const MeshFields& fields, VtkCells cells) {
  const bool is_poly = cells == VtkCells::polygons;
  const std::string kind = is_poly ? "PolyData" : "UnstructuredGrid";
  std::string xml = "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + kind +
                    "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<" +
                    kind + ">\n<Piece NumberOfPoints=\"" + std::to_string(mesh.positions.size()) +
                    (is_poly ? "\" NumberOfPolys=\"" : "\" NumberOfCells=\"") +
                    std::to_string(mesh.triangles.size()) + "\">\n";
  append_fields(xml, "PointData", fields.vertices);
  append_fields(xml, "CellData", fields.triangles);
  append_points(xml, mesh.positions);
  append_cells(xml, mesh.triangles, cells);
  return xml + "</Piece>\n</" + kind + ">\n</VTKFile>\n";
}

}  // namespace planish
