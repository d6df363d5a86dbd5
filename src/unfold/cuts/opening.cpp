#include "unfold/cuts/opening.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <planish/mesh/cut.h>
#include <planish/mesh/imprint.h>

#include "core/job.h"
#include "mesh/border_loops.h"
#include "mesh/cut/cut_paths.h"
#include "mesh/cut/inside_paths.h"
#include "mesh/split.h"
#include "unfold/cuts/crease_cuts.h"
#include "unfold/cuts/tight_line.h"

namespace planish {

Opening::Opening(TriMesh mesh, std::vector<double> weights, bool keep_holes, bool along_edges)
    : patch_(std::move(mesh)),
      source_(patch_.vertex_count()),
      triangle_of_(patch_.triangles().size()),
      weights_(std::move(weights)),
      is_hole_(patch_.vertex_count(), 0),
      was_border_(patch_.vertex_count(), 0),
      keep_holes_(keep_holes),
      along_edges_(along_edges) {
  std::iota(source_.begin(), source_.end(), Index{0});
  std::iota(triangle_of_.begin(), triangle_of_.end(), Index{0});
  for (Index v = 0; v < patch_.vertex_count(); ++v)
    was_border_[v] = patch_.is_border(v) ? 1 : 0;
}

void Opening::find_holes() {
  std::fill(is_hole_.begin(), is_hole_.end(), 0);
  if (!keep_holes_) return;
  for (const auto& loop : patch_.border_loops()) {
    for (const Index v : loop)
      is_hole_[v] = 1;
  }
  if (patch_.border_loops().empty()) return;
  BorderKinds kinds = border_kinds(patch_.positions(), patch_.connectivity(), patch_.unit_scale());
  kinds.tube_ends.push_back(kinds.outline);
  for (const std::size_t k : kinds.tube_ends) {
    for (const Index v : patch_.border_loops()[k])
      is_hole_[v] = 0;
  }
}

/// A loop of which a vertex is on no hole is none any more.
std::size_t Opening::loops_but_holes() const {
  const auto& loops = patch_.border_loops();
  return static_cast<std::size_t>(std::count_if(loops.begin(), loops.end(), [&](const auto& loop) {
    return std::any_of(loop.begin(), loop.end(), [&](Index v) { return is_hole_[v] == 0; });
  }));
}

/// How many cuts are needed at least.
std::size_t Opening::left_to_open() const {
  const std::size_t loops = loops_but_holes();
  return 2 * patch_.inspection().topology.genus + (loops > 0 ? loops - 1 : 0);
}

/// The same where holes are opened too. Each cut makes it less, also one that a hole is in the way
/// of and that only makes the hole a part of the outline.
std::size_t Opening::left_with_holes() const {
  const std::size_t loops = patch_.border_loops().size();
  return 2 * patch_.inspection().topology.genus + (loops > 0 ? loops - 1 : 0);
}

bool Opening::is_whole() const {
  return patch_.inspection().topology.components == 1;
}

/// The paths, drawn tight but for the first `kept`, as edges of a mesh that has them.
Chains Opening::as_edges(const Chains& paths, std::size_t kept, const Context& context) {
  if (along_edges_) return paths;
  std::vector<SurfaceLine> lines;
  for (const std::vector<Index>& path : paths) {
    lines.push_back(lines.size() < kept ? line_along_edges(patch_, path)
                                        : tight_line(patch_, path, weights_, context));
  }
  ImprintedMesh made = imprint(patch_, lines);
  for (const SurfacePoint& place : made.new_vertices) {
    source_.push_back(none);
    double weight = 0.0;
    bool is_hole = true, was_border = true;
    for (std::size_t k = 0; k < 3; ++k) {
      if (place.shares[k] == 0.0) continue;
      if (!weights_.empty()) weight += place.shares[k] * weights_[place.corners[k]];
      is_hole = is_hole && is_hole_[place.corners[k]] != 0;
      was_border = was_border && was_border_[place.corners[k]] != 0;
    }
    if (!weights_.empty()) weights_.push_back(weight);
    is_hole_.push_back(is_hole ? 1 : 0);
    was_border_.push_back(was_border ? 1 : 0);
  }
  for (Index& triangle : made.triangle_of)
    triangle = triangle_of_[triangle];
  triangle_of_ = std::move(made.triangle_of);
  patch_ = Patch(std::move(made.mesh));
  return std::move(made.paths);
}

std::vector<std::array<Index, 2>> Opening::old_border() const {
  std::vector<std::array<Index, 2>> edges;
  for (const auto& loop : patch_.border_loops()) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Index v = loop[k], w = loop[(k + 1) % loop.size()];
      if (was_border_[v] != 0 && was_border_[w] != 0) edges.push_back({v, w});
    }
  }
  return edges;
}

void Opening::cut(const Chains& paths) {
  if (paths.empty()) return;
  CutMesh cut = open_edges(patch_, paths);
  for (const std::vector<Index>& path : paths) {
    paths_.push_back(path);
    if (!along_edges_) continue;
    for (Index& v : paths_.back())
      v = source_[v];
  }
  edges_ += cut.edges;
  length_ += cut.length;
  carry(cut.source);
  patch_ = Patch(std::move(cut.mesh));
}

/// Goes on to vertices that are or copy these.
void Opening::carry(std::span<const Index> vertices) {
  const auto carried = [&](const auto& values) {
    auto result = values;
    result.clear();
    for (const Index v : vertices)
      result.push_back(values[v]);
    return result;
  };
  source_ = carried(source_);
  is_hole_ = carried(is_hole_);
  was_border_ = carried(was_border_);
  if (!weights_.empty()) weights_ = carried(weights_);
}

void Opening::open_along(const EssentialPath& way, const Context& context) {
  Chains edges = as_edges({way.path}, 0, context);
  const auto meets_border = [&](Index v) { return patch_.is_border(v); };
  const std::vector<Index>& loop = edges.front();
  const bool is_apart =
      loops_but_holes() > 0 && std::none_of(loop.begin(), loop.end(), meets_border);
  if (is_apart) {
    std::vector<unsigned char> is_on_loop(patch_.vertex_count(), 0);
    for (const Index v : loop)
      is_on_loop[v] = 1;
    std::vector<Index> roots;
    for (Index v = 0; v < patch_.vertex_count(); ++v) {
      if (patch_.is_border(v) && is_hole_[v] == 0) roots.push_back(v);
    }
    const auto there =
        InsidePaths(patch_, weights_).from(roots, [&](Index v) { return is_on_loop[v] != 0; });
    if (there) edges = as_edges({loop, *there}, 1, context);
  }
  cut(reduced_paths(patch_, edges, false));
}

void Opening::cut_creases(double least_hinge) {
  cut(inner_chains(patch_, crease_cuts(patch_, least_hinge)));
}

void Opening::open_handles(const Context& context) {
  find_holes();
  while (left_to_open() > 0) {
    stop_if_cancelled(context);
    const auto way = essential_path(patch_, is_hole_, weights_);
    if (!way) return;
    const Opening before = *this;
    const std::size_t left = left_with_holes();
    open_along(*way, context);
    if (is_whole() && left_with_holes() < left) continue;
    // A line that was drawn tight may have nothing left to cut.
    *this = before;
    cut(reduced_paths(patch_, Chains{way->path}, false));
    if (!is_whole() || left_with_holes() >= left) return;
  }
}

void Opening::cut_along(const std::vector<Index>& path, const Context& context) {
  const Opening before = *this;
  Chains edges = as_edges({path}, 0, context);
  // A straight line may be a single edge, which opens nothing in a closed surface.
  if (patch_.border_loops().empty() && edges.front().size() < 3) {
    *this = before;
    edges = {path};
  }
  cut(reduced_paths(patch_, edges, true));
}

void Opening::divide_along(const std::vector<Index>& path, const Context& context) {
  Chains chains = inner_chains(patch_, as_edges({path}, 0, context));
  chains.resize(std::min<std::size_t>(chains.size(), 1));
  cut(chains);
}

std::vector<Opening> Opening::parts() const {
  const std::vector<NamedPatch> meshes = split(patch_.mesh(), std::string());
  if (meshes.size() == 1) return {*this};
  std::vector<std::size_t> part_of(patch_.vertex_count(), 0);
  std::vector<Opening> parts(meshes.size(), *this);
  for (std::size_t p = 0; p < meshes.size(); ++p) {
    for (const Index v : meshes[p].vertices)
      part_of[v] = p;
    Opening& part = parts[p];
    part.carry(meshes[p].vertices);
    part.patch_ = Patch(meshes[p].mesh);
    part.triangle_of_.clear();
    if (p == 0) continue;
    part.paths_.clear();
    part.edges_ = 0;
    part.length_ = 0.0;
  }
  for (std::size_t t = 0; t < triangle_of_.size(); ++t)
    parts[part_of[patch_.triangles()[t].front()]].triangle_of_.push_back(triangle_of_[t]);
  return parts;
}

}  // namespace planish
