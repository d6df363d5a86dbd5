#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include <planish/unfold/suggest_cuts.h>

#include "core/job.h"
#include "mesh/cut/inside_paths.h"
#include "mesh/split.h"
#include "unfold/cuts/dart_tips.h"
#include "unfold/cuts/disk_cuts.h"
#include "unfold/cuts/dividing_path.h"
#include "unfold/cuts/opening.h"

namespace planish {

namespace {

constexpr std::size_t k_tips = 8;      // that are cut to at once
constexpr int k_rounds = 6;            // of looking for tips
constexpr double k_as_strong = 0.5;    // of the strongest tip
constexpr double k_most_scale = 1.0;   // power of e by which a map may shrink a tip
constexpr double k_least_hinge = 0.2;  // of a face, over the root of its area

/// Cuts from the border to the tips of limbs, where the conformal map would shrink too much.
void open_tips(Opening& opening, double most, const Context& context) {
  for (int round = 0; round < k_rounds; ++round) {
    std::vector<DartTip> tips = dart_tips(opening.patch(), k_tips);
    std::erase_if(tips, [&](const DartTip& tip) { return -tip.log_scale <= most; });
    if (tips.empty()) return;
    const double least = k_as_strong * tips.front().log_scale;
    for (const DartTip& tip : tips) {
      stop_if_cancelled(context);
      const Patch& patch = opening.patch();
      if (tip.log_scale > least || patch.is_border(tip.vertex)) continue;
      auto path =
          InsidePaths(patch, opening.weights()).from(std::span(&tip.vertex, 1), [&](Index v) {
            return patch.is_border(v);
          });
      if (!path) continue;
      std::reverse(path->begin(), path->end());
      opening.cut_along(*path, context);
    }
  }
}

/// The parts of a mesh that cuts along creases leave, each opened.
std::vector<Opening> opened(TriMesh mesh, std::vector<double> weights,
                            const CutGraphOptions& options, const Context& context) {
  Opening whole(std::move(mesh), std::move(weights), options.keep_holes, options.along_edges);
  if (options.relieve) whole.cut_creases(options.most_pieces > 1 ? k_least_hinge : 0.0);
  std::vector<Opening> parts = whole.parts();
  for (Opening& opening : parts) {
    opening.open_handles(context);
    if (opening.patch().border_loops().empty())
      opening.cut_along(cut_of_closed(opening.patch(), opening.weights()), context);
    if (options.relieve) open_tips(opening, k_most_scale, context);
  }
  return parts;
}

/// A path that divides what cannot be laid flat without overlap; nothing where it can.
std::optional<std::vector<Index>> division_of(const Opening& piece, const UnfoldOptions& options,
                                              const Context& context) {
  Pattern pattern;
  try {
    pattern = unfold(piece.patch(), options, context);
    if (!pattern.overlaps) return std::nullopt;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::unfold_failed) return std::nullopt;
  }
  return dividing_path(piece.patch(), pattern.positions, piece.weights());
}

/// The pieces divided until no pattern overlaps.
std::vector<Opening> divided(std::vector<Opening> open, const CutGraphOptions& options,
                             const Context& context) {
  std::vector<Opening> done;
  while (!open.empty()) {
    Opening piece = std::move(open.back());
    open.pop_back();
    const std::size_t count = done.size() + open.size() + 1;
    std::optional<std::vector<Index>> path;
    if (count < options.most_pieces) {
      // What is cut is sewn again: in a product both sides are equally long.
      UnfoldOptions how = options.unfold;
      how.match_seams = how.match_seams || count > 1;
      how.match_if_possible = true;
      if (how.match_seams) how.free_edges = piece.old_border();
      path = division_of(piece, how, context);
    }
    if (!path) {
      done.push_back(std::move(piece));
      continue;
    }
    piece.divide_along(*path, context);
    std::vector<Opening> parts = piece.parts();
    if (parts.size() < 2)
      done.push_back(std::move(piece));
    else
      std::move(parts.rbegin(), parts.rend(), std::back_inserter(open));
  }
  return done;
}

/// A piece, with the vertex and triangle numbers of the input mesh.
struct Piece {
  Opening opening;
  const NamedPatch* part;

  Index source(Index v) const {
    const Index own = opening.source()[v];
    return own == Opening::none ? CutGraph::none : part->vertices[own];
  }
};

/// All pieces as one mesh. Paths are those of the input mesh, so there are none where lines made
/// new vertices.
CutGraph together(const Patch& patch, std::span<const std::vector<Index>> triangles_of_part,
                  std::span<const std::size_t> part_of, std::span<const Piece> pieces,
                  bool along_edges) {
  CutGraph graph;
  graph.mesh.positions = patch.positions();
  graph.source.resize(patch.vertex_count());
  for (Index v = 0; v < patch.vertex_count(); ++v)
    graph.source[v] = v;
  std::vector<std::array<std::size_t, 3>> order;  // input triangle, piece, triangle of the piece
  std::vector<std::vector<Index>> number;         // of the vertices of each piece
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const Opening& opening = pieces[p].opening;
    number.emplace_back(opening.patch().vertex_count(), CutGraph::none);
    for (std::size_t t = 0; t < opening.triangle_of().size(); ++t)
      order.push_back({triangles_of_part[part_of[p]][opening.triangle_of()[t]], p, t});
    graph.lines += opening.paths().size();
    graph.edges += opening.edges();
    graph.length += opening.length();
    if (!along_edges) continue;
    for (const std::vector<Index>& path : opening.paths()) {
      std::vector<Index>& all = graph.paths.emplace_back(path);
      for (Index& v : all)
        v = pieces[p].part->vertices[v];
    }
  }
  std::sort(order.begin(), order.end());
  std::vector<unsigned char> taken(patch.vertex_count(), 0);
  for (const auto& [triangle, p, t] : order) {
    const Patch& own = pieces[p].opening.patch();
    Triangle& added = graph.mesh.triangles.emplace_back(own.triangles()[t]);
    for (Index& v : added) {
      Index& known = number[p][v];
      if (known == CutGraph::none) {
        const Index source = pieces[p].source(v);
        if (source != CutGraph::none && taken[source] == 0) {
          known = source;
          taken[source] = 1;
        } else {
          known = static_cast<Index>(graph.mesh.positions.size());
          graph.mesh.positions.push_back(own.positions()[v]);
          graph.source.push_back(source);
        }
      }
      v = known;
    }
  }
  return graph;
}

}  // namespace

CutGraph cut_graph(const Patch& patch, const CutGraphOptions& options, const Context& context) {
  if (!options.weights.empty() && options.weights.size() != patch.vertex_count()) {
    throw Error(ErrorCode::option_out_of_range,
                "there are " + std::to_string(options.weights.size()) + " weights for " +
                    std::to_string(patch.vertex_count()) + " vertices");
  }
  const std::vector<NamedPatch> parts = split(patch.mesh(), std::string());
  std::vector<std::size_t> part_of_vertex(patch.vertex_count(), 0), part_of;
  std::vector<std::vector<Index>> triangles(parts.size());
  std::vector<Piece> pieces;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    std::vector<double> weights;
    for (const Index v : parts[k].vertices) {
      part_of_vertex[v] = k;
      if (!options.weights.empty()) weights.push_back(options.weights[v]);
    }
    std::vector<Opening> open = opened(parts[k].mesh, std::move(weights), options, context);
    for (Opening& piece : divided(std::move(open), options, context)) {
      pieces.push_back({std::move(piece), &parts[k]});
      part_of.push_back(k);
    }
  }
  for (std::size_t t = 0; t < patch.triangles().size(); ++t)
    triangles[part_of_vertex[patch.triangles()[t].front()]].push_back(static_cast<Index>(t));
  return together(patch, triangles, part_of, pieces, options.along_edges);
}

}  // namespace planish
