#include "surface.h"

#include <optional>
#include <utility>

#include <planish/core/error.h>
#include <planish/io/model.h>
#include <planish/mesh/geodesic.h>
#include <planish/mesh/surface_line.h>
#include <planish/mesh/symmetry.h>
#include <planish/unfold/strain.h>

namespace planish::wasm {

namespace {

void append(TriMesh& all, const TriMesh& part, double scale) {
  const auto first = static_cast<Index>(all.positions.size());
  for (const Vec3 p : part.positions)
    all.positions.push_back(scale == 1.0 ? p : scale * p);
  for (const Triangle& t : part.triangles)
    all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

Vec3 point_at(std::span<const double> places, std::size_t k) {
  return {places[3 * k], places[3 * k + 1], places[3 * k + 2]};
}

}  // namespace

std::vector<float> coordinates_of(const TriMesh& mesh) {
  std::vector<float> numbers;
  numbers.reserve(3 * mesh.positions.size());
  for (const Vec3& p : mesh.positions) {
    for (const double x : {p.x, p.y, p.z})
      numbers.push_back(static_cast<float>(x));
  }
  return numbers;
}

std::vector<Index> corners_of(const TriMesh& mesh) {
  std::vector<Index> corners;
  corners.reserve(3 * mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles)
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  return corners;
}

Surface::Surface(std::span<const std::string> paths) {
  std::optional<Unit> unit;
  TriMesh all;
  for (const std::string& path : paths) {
    ReadResult file = read_mesh(path);
    if (file.unit && !unit) unit = file.unit->unit;
    const double scale =
        file.unit ? millimetres_per(file.unit->unit) / millimetres_per(*unit) : 1.0;
    const Model model = prepare_model(std::move(file), {}, path);
    pieces_ += model.pieces.size();
    append(all, divided(model), scale);
  }
  if (unit) unit_ = to_string(*unit);
  patch_ = Patch(std::move(all));
}

std::vector<double> Surface::line(std::span<const double> places) const {
  const std::size_t count = places.size() / 3;
  if (count < 2) return {};
  SurfaceLine line = {nearest_place(patch_, point_at(places, 0))};
  for (std::size_t k = 1; k < count; ++k) {
    const SurfacePoint next = nearest_place(patch_, point_at(places, k));
    const SurfaceLine part = geodesic(patch_, line.back(), next).points;
    line.insert(line.end(), part.begin() + 1, part.end());
  }
  std::vector<double> points;
  for (const SurfacePoint& place : line) {
    const Vec3 p = position_of(place, patch_.positions());
    points.insert(points.end(), {p.x, p.y, p.z});
  }
  return points;
}

SymmetryFound Surface::symmetry() const {
  const Symmetry found = find_symmetry(patch_);
  const TriMesh& mesh = patch_.mesh();
  return {found.plane, found.largest / bounding_box_diagonal(mesh),
          found.largest <= symmetry_tolerance(mesh)};
}

LaidPiece laid_piece(const std::string& surface, const std::string& pattern) {
  LaidPiece piece{read_mesh(surface).mesh, read_mesh(pattern).mesh, {}};
  check_same_triangles(piece.surface, piece.pattern);
  std::vector<Vec2> flat;
  for (const Vec3& p : piece.pattern.positions)
    flat.push_back({p.x, p.y});
  for (const double strain : signed_strains(principal_stretches(piece.surface, flat)))
    piece.strain.push_back(static_cast<float>(strain));
  return piece;
}

}  // namespace planish::wasm
