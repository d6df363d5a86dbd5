#include "io/model/part.h"

#include <algorithm>
#include <utility>

#include <planish/mesh/patch.h>
#include <planish/mesh/wall.h>
#include <planish/mesh/weld.h>

#include "mesh/manifold_defects.h"
#include "mesh/redundant/doubled.h"
#include "mesh/repair/sheets.h"

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
/// cannot be told, and parting would tear it.
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
/// stays, to be refused: which of them are of one sheet cannot be told.
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

/// Whether a part may be a wall: one sheet, or two beside each other. One that nobody told of is
/// closed: an open one with its sides close together, as a flat sleeve, is meant so.
bool may_be_wall(std::size_t sheets, const Connectivity& connectivity, bool is_asked) {
  return sheets == 2 || (sheets == 1 && (is_asked || connectivity.border_loops().empty()));
}

/// @param sheets of a manifold; 0 of what is none
void take_one_side(ModelPart& part, const std::optional<Connectivity>& connectivity,
                   std::size_t sheets, const std::optional<Side>& side, ModelWork& work) {
  const bool may_be = connectivity && may_be_wall(sheets, *connectivity, side.has_value());
  const auto wall = may_be ? find_wall(part.mesh) : std::nullopt;
  if (!wall) {
    if (side) work.without_wall.push_back(part.name);
    return;
  }
  if (!side) {
    work.walls.push_back({part.name, wall->thickness});
    return;
  }
  take(part, take_side(part.mesh, *wall, *side == Side::outer ? WallPart::outer : WallPart::inner));
}

void close_holes(ModelPart& part, double length, ModelWork& work) {
  FilledMesh filled = fill_holes(part.mesh, length);
  work.filled += filled.filled;
  work.unfilled += filled.left;
  if (filled.filled > 0) take(part, std::move(filled));
}

}  // namespace

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
  if (!options.strict || options.side) take_one_side(part, connectivity, count, options.side, work);
  if (options.fill_holes > 0.0) close_holes(part, options.fill_holes, work);
  if (options.flip) part.mesh = turned_over(std::move(part.mesh));
}

}  // namespace planish
