#include "panels/uv_score.h"

#include <cmath>
#include <utility>
#include <vector>

#include <planish/mesh/cut.h>
#include <planish/mesh/inspect.h>
#include <planish/mesh/surface_line.h>
#include <planish/unfold/strain.h>
#include <planish/unfold/unfold.h>

#include "mesh/mean_edge.h"
#include "panels/piece/panel_mesh.h"
#include "panels/piece/piece_corners.h"
#include "panels/seams/seam_chains.h"

namespace planish {

namespace {

/// Where the triangle's corner at a vertex lies.
Vec2 place_at(const UvMap& map, Index triangle, Index vertex) {
  const Triangle& t = map.mesh.triangles[triangle];
  return map.corners[triangle][t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2];
}

OpenEdges cuts_of(const UvMap& map, const PanelMesh& mesh) {
  OpenEdges open;
  open.reserve(mesh.edges().size());
  for (const PanelEdge& edge : mesh.edges()) {
    const auto is_torn = [&](Index v) {
      return !(place_at(map, edge.triangles[0], v) == place_at(map, edge.triangles[1], v));
    };
    open.push_back(!edge.is_border() && (is_torn(edge.ends[0]) || is_torn(edge.ends[1])) ? 1 : 0);
  }
  return open;
}

double jag_of_cuts(const PanelMesh& mesh, const OpenEdges& open) {
  const double edge = mean_edge_length(mesh.patch().mesh());
  double length = 0.0, chords = 0.0;
  for (const SeamChain& chain : seam_chains(mesh, open)) {
    std::vector<Vec3> line;
    for (const Index v : chain.vertices)
      line.push_back(mesh.patch().positions()[v]);
    const double along = path_length(chain.vertices, mesh.patch().positions());
    length += along;
    chords += along / jag_of(line, edge);
  }
  return chords > 0.0 ? length / chords : 1.0;
}

double flat_area(const std::vector<Vec2>& places, const Triangle& t) {
  return 0.5 * cross(places[t[1]] - places[t[0]], places[t[2]] - places[t[0]]);
}

/// The surface cut open, piece after piece, with its places.
struct CutMap {
  TriMesh mesh;
  std::vector<Vec2> places;
  double area = 0.0;  ///< of the places

  void add(const TriMesh& piece, const std::vector<Vec2>& piece_places) {
    const auto first = static_cast<Index>(places.size());
    mesh.positions.insert(mesh.positions.end(), piece.positions.begin(), piece.positions.end());
    places.insert(places.end(), piece_places.begin(), piece_places.end());
    for (const Triangle& t : piece.triangles) {
      mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
      area += std::abs(flat_area(piece_places, t));
    }
  }
};

std::size_t flipped_triangles(const TriMesh& piece, const std::vector<Vec2>& places) {
  double area = 0.0;
  for (const Triangle& t : piece.triangles)
    area += flat_area(places, t);
  const double side = area < 0.0 ? -1.0 : 1.0;  // programs may mirror pieces
  std::size_t flipped = 0;
  for (const Triangle& t : piece.triangles)
    flipped += side * flat_area(places, t) > 0.0 ? 0 : 1;
  return flipped;
}

bool overlaps(TriMesh piece, const std::vector<Vec2>& places) {
  Pattern pattern;
  pattern.positions = places;
  pattern.overlaps = true;  // may be: overlap_of() looks
  return overlap_of(Patch(std::move(piece)), pattern).has_value();
}

}  // namespace

UvScore score_of(const UvMap& map) {
  Patch patch(map.mesh);
  require(patch.inspection(), Purpose::measure);
  const PanelMesh mesh(std::move(patch));
  const OpenEdges open = cuts_of(map, mesh);
  UvScore score;
  score.tips = tips_of(mesh, open_edges_at(mesh, open));
  score.seam = open_length(mesh, open);
  score.jag = jag_of_cuts(mesh, open);
  CutMap whole;
  for (const std::vector<Index>& part : open_parts(mesh, open)) {
    const PieceCorners corners(mesh, open, part);
    TriMesh piece{{}, corners.all_corners()};
    for (std::size_t v = 0; v < corners.vertex_count(); ++v)
      piece.positions.push_back(mesh.patch().positions()[corners.vertex_of(v)]);
    std::vector<Vec2> places(corners.vertex_count());
    for (std::size_t k = 0; k < part.size(); ++k) {
      for (std::size_t i = 0; i < 3; ++i)
        places[corners.corners(k)[i]] = map.corners[part[k]][i];
    }
    ++score.pieces;
    score.flipped += flipped_triangles(piece, places);
    whole.add(piece, places);
    score.overlapping += overlaps(std::move(piece), places) ? 1 : 0;
  }
  const double to_size = whole.area > 0.0 ? 1.0 / (mesh.scale() * std::sqrt(whole.area)) : 1.0;
  for (Vec2& p : whole.places)
    p = to_size * p;
  score.strain = edge_strain(Patch(std::move(whole.mesh)), whole.places);
  return score;
}

}  // namespace planish
