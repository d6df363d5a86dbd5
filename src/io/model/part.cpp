#include "io/model/part.h"

#include <algorithm>
#include <utility>

#include <planish/mesh/patch.h>
#include <planish/mesh/wall.h>
#include <planish/mesh/weld.h>

#include "core/neumaier_sum.h"
#include "mesh/manifold_defects.h"
#include "mesh/redundant/doubled.h"
#include "mesh/repair/sheets.h"
#include "mesh/split.h"

namespace planish {

namespace {

/// Takes the mended mesh for that of the part, with where it comes from in the file.
void take(ModelPart& part, RepairedMesh mended) {
  std::vector<Index> triangles;
  triangles.reserve(mended.source.size());
  for (const Index t : mended.source)
    triangles.push_back(t == RepairedMesh::none ? ModelPart::none : part.triangles[t]);
  part.mesh = std::move(mended.mesh);
  part.triangles = std::move(triangles);
}

void clean(ModelPart& part, ModelWork& work) {
  CleanedMesh cleaned = remove_redundant_triangles(part.mesh);
  if (cleaned.removed() == 0) return;
  work.collapsed += cleaned.collapsed;
  work.repeated += cleaned.repeated;
  work.backs += cleaned.backs;
  work.fins += cleaned.fins;
  take(part, std::move(cleaned));
}

void join(ModelPart& part, double length, ModelWork& work) {
  const double within = length > 0.0 ? length : default_weld_length(part.mesh);
  WeldedMesh welded = weld(part.mesh, within);
  work.weld_length = std::max(work.weld_length, within);
  work.held += welded.held;
  work.joined += welded.joined;
  work.unjoined += welded.left;
  work.turned += welded.turned;
  if (welded.joined + welded.divided > 0) take(part, std::move(welded));
}

void orient(ModelPart& part, ModelWork& work) {
  OrientedMesh oriented = orient_consistently(part.mesh);
  work.turned += oriented.turned;
  if (oriented.turned > 0) take(part, std::move(oriented));
}

bool has(const std::vector<Problem>& problems, ErrorCode code) {
  return std::any_of(problems.begin(), problems.end(),
                     [&](const Problem& problem) { return problem.code == code; });
}

/// Parts the sheets of a mesh: not where triangles run against each other, as then what is a sheet
/// is not known, and parting would tear it.
void part_sheets(ModelPart& part, const std::vector<Problem>& problems, ModelWork& work) {
  if (has(problems, ErrorCode::inconsistent_orientation) ||
      has(problems, ErrorCode::non_orientable)) {
    return;
  }
  SeparatedMesh parted = divide_at_nonmanifold_edges(part.mesh);
  work.parted_edges += parted.places;
  if (parted.places > 0) take(part, std::move(parted));
}

void part_touching(ModelPart& part, ModelWork& work) {
  SeparatedMesh parted = separate_touching(part.mesh);
  work.parted_vertices += parted.places;
  if (parted.places > 0) take(part, std::move(parted));
}

/// What a mesh that is no manifold can be made one by. One with triangles that are there twice
/// stays, to be refused: which of them are of one sheet is not known.
void mend_defects(ModelPart& part, ModelWork& work) {
  const std::vector<Problem> problems = find_manifold_defects(part.mesh).problems;
  if (has(problems, ErrorCode::duplicate_triangle)) return;
  part_sheets(part, problems, work);
  part_touching(part, work);
  orient(part, work);
}

/// @return whether there were any
bool leave_out_crumbs(ModelPart& part, ModelWork& work) {
  const Crumbs crumbs = find_crumbs(part.mesh);
  if (crumbs.pieces == 0) return false;
  work.crumbs += crumbs.pieces;
  work.crumb_share += part.area_share * crumbs.area_share;
  take(part, without_triangles(part.mesh, crumbs.triangles));
  return true;
}

/// A wall among the sheets of a part.
struct WallOfPart {
  std::string name;
  std::vector<Index> triangles;  ///< those of the part, in its order
  TriMesh mesh;                  ///< of them
  Wall wall;
};

/// Finds the walls of a part: closed sheets each by itself, then what is left if it is two sheets.
/// More than two sheets together are a wall only where one is asked for, and so are open ones among
/// several.
class WallSearch {
 public:
  WallSearch(const ModelPart& part, const Connectivity& connectivity, bool is_asked)
      : part_(part),
        connectivity_(connectivity),
        is_asked_(is_asked),
        sheets_(find_sheets(part.mesh)),
        names_(numbered_names(part.name, sheets_.count)),
        triangles_(sheets_.count),
        number_(part.mesh.positions.size(), ModelPart::none) {
    for (std::size_t t = 0; t < sheets_.of_triangle.size(); ++t)
      triangles_[sheets_.of_triangle[t]].push_back(static_cast<Index>(t));
    for (std::size_t k = 0; k < sheets_.count; ++k)
      rest_.push_back(static_cast<Index>(k));
  }

  std::vector<WallOfPart> walls() {
    const std::vector<unsigned char> is_open = open_sheets();
    for (std::size_t k = 0; k < sheets_.count; ++k) {
      if (is_open[k] == 0 || sheets_.count == 1) look_at({static_cast<Index>(k)});
    }
    if (rest_.size() == 2 || (rest_.size() > 2 && is_asked_)) look_at(rest_);
    return std::move(walls_);
  }

  bool is_one_sheet() const { return sheets_.count == 1; }

  /// Names of the sheets that are none.
  std::vector<std::string> others() const {
    if (rest_.size() == sheets_.count) return {part_.name};
    std::vector<std::string> names;
    names.reserve(rest_.size());
    for (const Index k : rest_)
      names.push_back(names_[k]);
    return names;
  }

 private:
  std::vector<unsigned char> open_sheets() const {
    std::vector<unsigned char> is_open(sheets_.count, 0);
    for (std::size_t t = 0; t < part_.mesh.triangles.size(); ++t) {
      for (const Index v : part_.mesh.triangles[t]) {
        if (connectivity_.is_border(v)) is_open[sheets_.of_triangle[t]] = 1;
      }
    }
    return is_open;
  }

  void look_at(const std::vector<Index>& sheets) {
    const bool is_all = sheets.size() == sheets_.count;
    WallOfPart found{is_all ? part_.name : names_[sheets.front()], {}, {}, {}};
    for (const Index k : sheets)
      found.triangles.insert(found.triangles.end(), triangles_[k].begin(), triangles_[k].end());
    std::sort(found.triangles.begin(), found.triangles.end());
    found.mesh = mesh_of(found.triangles);
    auto wall = find_wall(found.mesh);
    if (!wall) return;
    found.wall = *std::move(wall);
    walls_.push_back(std::move(found));
    const std::vector<Index> gone = sheets;  // they may be the rest itself
    std::erase_if(rest_, [&](Index k) { return std::binary_search(gone.begin(), gone.end(), k); });
  }

  /// Time and memory go with the triangles, not with the part: there may be many sheets.
  TriMesh mesh_of(const std::vector<Index>& triangles) {
    TriMesh mesh;
    for (const Index t : triangles) {
      Triangle corners = part_.mesh.triangles[t];
      for (Index& v : corners) {
        if (number_[v] == ModelPart::none) {
          number_[v] = static_cast<Index>(mesh.positions.size());
          mesh.positions.push_back(part_.mesh.positions[v]);
        }
        v = number_[v];
      }
      mesh.triangles.push_back(corners);
    }
    for (const Index t : triangles) {
      for (const Index v : part_.mesh.triangles[t])
        number_[v] = ModelPart::none;
    }
    return mesh;
  }

  const ModelPart& part_;
  const Connectivity& connectivity_;
  bool is_asked_;
  Sheets sheets_;
  std::vector<std::string> names_;
  std::vector<std::vector<Index>> triangles_;  // of each sheet
  std::vector<Index> number_;                  // of vertices in the mesh of some sheets
  std::vector<Index> rest_;                    // sheets of no wall, by their numbers
  std::vector<WallOfPart> walls_;
};

/// How far along a direction of length below 1 that few plates stand across.
double way_along(Vec3 p) {
  return dot(p, {0.8, 0.53, 0.28});
}

/// The places of the vertices of some part of a wall, by way_along().
std::vector<Vec3> places_of(const WallOfPart& of, WallPart part) {
  std::vector<unsigned char> is_here(of.mesh.positions.size(), 0);
  for (std::size_t t = 0; t < of.wall.part.size(); ++t) {
    if (of.wall.part[t] != part) continue;
    for (const Index v : of.mesh.triangles[t])
      is_here[v] = 1;
  }
  std::vector<Vec3> places;
  places.reserve(is_here.size());
  for (std::size_t v = 0; v < is_here.size(); ++v) {
    if (is_here[v] != 0) places.push_back(of.mesh.positions[v]);
  }
  std::stable_sort(places.begin(), places.end(),
                   [](Vec3 a, Vec3 b) { return way_along(a) < way_along(b); });
  return places;
}

/// Leaves one side of each wall of the part.
void take_sides(ModelPart& part, const std::vector<WallOfPart>& walls, WallPart side) {
  std::vector<Index> others;
  const WallPart beyond = side == WallPart::outer ? WallPart::inner : WallPart::outer;
  for (const WallOfPart& of : walls) {
    part.walls.push_back({of.name, of.wall.thickness, places_of(of, side), places_of(of, beyond)});
    for (std::size_t t = 0; t < of.triangles.size(); ++t) {
      Triangle& corners = part.mesh.triangles[of.triangles[t]];
      if (of.wall.part[t] != side)
        others.push_back(of.triangles[t]);
      else if (of.wall.turned[static_cast<std::size_t>(side)])
        std::swap(corners[1], corners[2]);
    }
  }
  std::sort(others.begin(), others.end());
  take(part, without_triangles(part.mesh, others));
}

void take_one_side(ModelPart& part, const std::optional<Connectivity>& connectivity,
                   const std::optional<Side>& side, ModelWork& work) {
  if (!connectivity) {
    if (side) work.without_wall.push_back(part.name);
    return;
  }
  WallSearch search(part, *connectivity, side.has_value());
  const std::vector<WallOfPart> walls = search.walls();
  if (!side) {
    for (const WallOfPart& of : walls) {
      const bool is_open = search.is_one_sheet() && !connectivity->border_loops().empty();
      work.walls.push_back({of.name, of.wall.thickness, is_open});
    }
    return;
  }
  for (std::string& name : search.others())
    work.without_wall.push_back(std::move(name));
  for (const WallOfPart& of : walls) {
    if (of.wall.is_level) work.level_walls.push_back(of.name);
  }
  if (!walls.empty())
    take_sides(part, walls, *side == Side::outer ? WallPart::outer : WallPart::inner);
}

/// Whether two places at least are the same, within the distance.
/// @pre both are sorted by way_along(), and none is empty
bool meet(const std::vector<Vec3>& one, const std::vector<Vec3>& other, double within) {
  if (way_along(one.back()) + within < way_along(other.front()) ||
      way_along(other.back()) + within < way_along(one.front()))
    return false;
  std::size_t count = 0;
  for (const Vec3 p : one) {
    const double way = way_along(p);
    const auto is_before = [](Vec3 place, double low) { return way_along(place) < low; };
    auto at = std::lower_bound(other.begin(), other.end(), way - within, is_before);
    const auto is_near = [&] { return at != other.end() && way_along(*at) <= way + within; };
    while (is_near() && norm(*at - p) > within)
      ++at;
    count += is_near() ? 1 : 0;
    if (count > 1) return true;
  }
  return false;
}

/// Whether a sheet may be a wall with an opening: the area vectors of its triangles, which point
/// outwards on both sides of a wall, nearly cancel.
bool faces_both_ways(const TriMesh& mesh) {
  constexpr double k_one_way = 0.25;  // of the area
  const double scale = unit_scale(mesh);
  NeumaierSum x, y, z, all;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 corner = scale * mesh.positions[t[0]];
    const Vec3 area =
        cross(scale * mesh.positions[t[1]] - corner, scale * mesh.positions[t[2]] - corner);
    x.add(area.x);
    y.add(area.y);
    z.add(area.z);
    all.add(norm(area));
  }
  return norm({x.value(), y.value(), z.value()}) < k_one_way * all.value();
}

void close_holes(ModelPart& part, double length, ModelWork& work) {
  FilledMesh filled = fill_holes(part.mesh, length);
  work.filled += filled.filled;
  work.unfilled += filled.left;
  if (filled.filled > 0) take(part, std::move(filled));
}

}  // namespace

std::vector<ModelWork::ClashingSides> find_clashing_sides(std::span<const ModelPart> parts) {
  constexpr double k_same_place = 0.25;  // thicknesses
  std::vector<const WallSides*> walls;
  for (const ModelPart& part : parts) {
    for (const WallSides& wall : part.walls) {
      if (!wall.taken.empty() && !wall.other.empty()) walls.push_back(&wall);
    }
  }
  std::vector<ModelWork::ClashingSides> clashing;
  for (std::size_t a = 0; a < walls.size(); ++a) {
    for (std::size_t b = a + 1; b < walls.size(); ++b) {
      const WallSides &one = *walls[a], &other = *walls[b];
      const double within = k_same_place * std::min(one.thickness, other.thickness);
      if (meet(one.taken, other.other, within) && meet(one.other, other.taken, within) &&
          !meet(one.taken, other.taken, within))
        clashing.push_back({one.name, other.name});
    }
  }
  return clashing;
}

void prepare_part(ModelPart& part, const ModelOptions& options, ModelWork& work) {
  auto connectivity = Connectivity::build(part.mesh);
  const std::size_t triangles = part.mesh.triangles.size();
  if (!options.strict && (!connectivity || may_be_doubled(part.mesh))) clean(part, work);
  if (options.weld) join(part, *options.weld, work);
  const bool is_changed = options.weld || part.mesh.triangles.size() != triangles;
  if (is_changed) connectivity = Connectivity::build(part.mesh);
  if (!options.strict && !connectivity) {
    mend_defects(part, work);
    connectivity = Connectivity::build(part.mesh);
  }
  // Pieces of a manifold hang together by vertices as they do by edges.
  const auto sheets = [&] {
    return connectivity ? find_parts_by_vertices(part.mesh).count : std::size_t{0};
  };
  std::size_t count = sheets();
  if (!options.strict && count != 1 && leave_out_crumbs(part, work)) {
    connectivity = Connectivity::build(part.mesh);
    count = sheets();
  }
  part.is_one_piece = count == 1 && !options.side && options.fill_holes == 0.0;
  const bool is_open = count == 1 && !connectivity->border_loops().empty();
  if (options.side || (!options.strict && (!is_open || faces_both_ways(part.mesh))))
    take_one_side(part, connectivity, options.side, work);
  if (options.fill_holes > 0.0) close_holes(part, options.fill_holes, work);
  if (options.flip) part.mesh = turned_over(std::move(part.mesh));
}

}  // namespace planish
