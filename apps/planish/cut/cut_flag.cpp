#include "cut/cut_flag.h"

#include <string>
#include <utility>

#include <planish/io/read_features.h>
#include <planish/mesh/cut.h>
#include <planish/mesh/imprint.h>
#include <planish/unfold/suggest_cuts.h>

#include "cut/requested_lines.h"
#include "flags/scale_flag.h"
#include "flags/units.h"
#include "platform/path.h"
#include "shell/failures.h"
#include "shell/session.h"
#include "shell/text.h"
#include "text/lengths.h"

namespace planish::cli {

std::vector<Flag> cut_flags() {
  Flag cut = {"--cut", "LINES",
              "cut the surface along lines first: an .obj or a list of vertices, \"plane x=0\", "
              "\"creases 30deg\", or open: what makes a disk; may be repeated"};
  cut.accepts.repeats = true;
  cut.accepts.type = ValueType::file;
  Flag along = {"--cut-along", "WHAT",
                "triangles: a line cuts through them; edges: it follows edges of the mesh (default "
                "triangles)"};
  along.accepts = {.choices = {"triangles", "edges"}, .standard = "triangles"};
  Flag smooth = {
      "--smooth-lines", "ANSWER",
      "take the teeth out of drawn lines, by up to half an edge: yes or no (default yes)"};
  smooth.accepts = {.choices = {"yes", "no"}, .standard = "yes"};
  Flag avoid = {"--avoid", "FILE",
                "places that the cuts of --cut open go round where they can: vertices one a line, "
                "or an .obj with lines or points over the mesh"};
  avoid.accepts.type = ValueType::file;
  return {cut, along, smooth, avoid};
}

namespace {

bool is_through_triangles(const Arguments& arguments) {
  return arguments.text("--cut-along", "triangles") == "triangles";
}

void check_count(const std::vector<SurfaceLine>& lines) {
  constexpr std::size_t most = 10'000;
  if (lines.size() <= most) return;
  throw Error(ErrorCode::too_large, "--cut: there are " + std::to_string(lines.size()) +
                                        " lines; at most 10,000 can be cut at once");
}

/// Joins the lines, makes them edges and opens these.
CutMesh cut_through_triangles(const TriMesh& mesh, const Arguments& arguments, Session& session,
                              const ShownLengths& lengths) {
  const Patch patch(as_in_file(mesh, arguments));
  RequestedLines asked = requested_lines(patch, arguments);
  check_count(asked.lines);
  const double scale = scale_from(arguments);
  for (const std::string& note : asked.notes)
    session.note(note);
  const JoinedLines joined =
      join_lines(patch, std::move(asked.lines), join_tolerance(patch.mesh()));
  for (const JoinedEnd& end : joined.joined) {
    session.note((end.is_last ? "the end of " : "the beginning of ") + asked.names[end.line] +
                 " is " + lengths.text(scale * end.distance) + " from " +
                 (end.to ? asked.names[*end.to] : "the border") + "; joined");
  }
  const ImprintedMesh imprinted = imprint(Patch(mesh), joined.lines);
  std::vector<CutPath> paths;
  for (std::size_t k = 0; k < imprinted.paths.size(); ++k) {
    if (imprinted.paths[k].size() > 1) paths.push_back({imprinted.paths[k], asked.places[k]});
  }
  return cut_open(Patch(imprinted.mesh), paths);
}

/// Cuts along edges between vertices of the mesh.
CutMesh cut_through_edges(const TriMesh& mesh, const Arguments& arguments, Session& session,
                          const ShownLengths& lengths) {
  const std::string file = arguments.text("--cut");
  const CutLines along = arguments.rows.contains("--cut")
                             ? cuts_in(arguments.rows_of("--cut"), mesh)
                             : read_cuts(path_of(file), as_in_file(mesh, arguments));
  if (along.farthest > 0.0) {
    session.note(file + ": what is drawn is at most " +
                 lengths.text(scale_from(arguments) * along.farthest) +
                 " from the vertices that stand for it, and between them the cut follows edges");
  }
  return cut_open(Patch(mesh), along.paths);
}

/// What lengths near each vertex count for: more at those that --avoid names.
std::vector<double> weights_from(const Arguments& arguments, const Patch& patch) {
  constexpr double k_avoided = 20.0;
  if (!arguments.has("--avoid")) return {};
  const FixedVertices avoided =
      arguments.rows.contains("--avoid")
          ? FixedVertices{fixed_vertices_in(arguments.rows_of("--avoid"), patch.vertex_count())}
          : read_fixed_vertices(path_of(arguments.text("--avoid")), as_in_file(patch, arguments));
  std::vector<double> weights(patch.vertex_count(), 1.0);
  for (const Index v : avoided.vertices)
    weights[v] = k_avoided;
  return weights;
}

/// Opens what is no disk.
CutInput opened(TriMesh mesh, const Arguments& arguments, Session& session,
                const OpeningLimits& limits, const ShownLengths& lengths) {
  const Patch patch(std::move(mesh));
  const CutGraphOptions options = {
      .keep_holes = true,
      .weights = weights_from(arguments, patch),
      .along_edges = !is_through_triangles(arguments),
      .relieve = true,
      .most_pieces = limits.most_pieces,
      .unfold = {.match_seams = limits.match_seams,
                 .open_crossings = k_hair / millimetres_per(unit_from(arguments))}};
  CutGraph graph = cut_graph(patch, options, session.silent_context());
  session.note(graph.lines == 0 ? "--cut open: the surface lies flat without a cut"
                                : "--cut open: cut along " + counted(graph.lines, "line") + ", " +
                                      lengths.text(graph.length));
  return {std::move(graph.mesh), CutOutcome{graph.edges, graph.length}};
}

}  // namespace

CutInput cut_as_asked(TriMesh mesh, const std::string& path, const Arguments& arguments,
                      Session& session, const OpeningLimits& limits) {
  const bool opens = arguments.has("--cut") && asks_to_open(arguments);
  if (arguments.has("--avoid") && !opens)
    throw UsageError("flag --avoid says where cuts do not go: it needs --cut open");
  if (!arguments.has("--cut")) return {std::move(mesh)};
  return about(path, [&]() -> CutInput {
    const ShownLengths lengths(unit_from(arguments));
    CutInput result = {std::move(mesh), CutOutcome{}};
    if (asks_for_lines(arguments)) {
      CutMesh cut = is_through_triangles(arguments)
                        ? cut_through_triangles(result.mesh, arguments, session, lengths)
                        : cut_through_edges(result.mesh, arguments, session, lengths);
      session.note(arguments.text("--cut") + ": cut open along " + counted(cut.edges, "edge") +
                   ", " + lengths.text(cut.length));
      result = {std::move(cut.mesh), CutOutcome{cut.edges, cut.length}};
    }
    if (!opens) return result;
    CutInput open = opened(std::move(result.mesh), arguments, session, limits, lengths);
    open.cut->edges += result.cut->edges;
    open.cut->length += result.cut->length;
    return open;
  });
}

std::vector<MoreFigures> figures_of_cut(const std::optional<CutOutcome>& cut) {
  if (!cut) return {};
  return {{"cut", {{"edges", cut->edges}, {"length", cut->length}}}};
}

}  // namespace planish::cli
