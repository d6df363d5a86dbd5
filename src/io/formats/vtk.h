#pragma once

#include <string>

#include <planish/io/mesh_format.h>

namespace planish {

/// What the cells of a VTK file are.
enum class VtkCells { polygons, triangles };

/// An XML file of VTK: PolyData of polygons, or an UnstructuredGrid of triangles.
/// @param mesh with finite positions and indices in range
/// @param fields with as many values as the mesh has vertices and triangles
std::string format_vtk(const TriMesh& mesh, const MeshFields& fields, VtkCells cells);

}  // namespace planish
