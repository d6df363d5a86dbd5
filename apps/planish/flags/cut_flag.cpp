#include "flags/cut_flag.h"

#include <algorithm>
#include <utility>

#include <planish/io/read_features.h>
#include <planish/mesh/imprint.h>

#include "flags/cut_lines.h"
#include "flags/scale_flag.h"
#include "flags/units.h"
#include "mesh/mean_edge.h"
#include "platform/path.h"
#include "shell/failures.h"
#include "shell/session.h"
#include "shell/text.h"
#include "text/lengths.h"

namespace planish::cli {

FlagGroup cut_flags() {
  Flag cut = {"--cut", "LINES",
              "cut the surface along lines first: an .obj with lines, a file with the vertices of "
              "a line in each row, \"plane x=0\", \"creases 30deg\", or open: what makes it lie "
              "flat at all; may be given several times"};
  cut.accepts.repeats = true;
  cut.accepts.type = ValueType::text;
  Flag along = {"--cut-along", "WHAT",
                "triangles: a line cuts through them; edges: it follows edges of the mesh"};
  along.accepts = {.choices = {"triangles", "edges"}, .standard = "triangles"};
  Flag smooth = {"--smooth-lines", "ANSWER",
                 "take the teeth out of drawn lines, by up to half an edge: yes or no"};
  smooth.accepts = {.choices = {"yes", "no"}, .standard = "yes"};
  return {"Cuts", {cut, along, smooth}};
}

namespace {

/// Of the diagonal, and of a mean edge: ends of lines that are nearer to another line or the border
/// are led on to it.
constexpr double k_join_of_diagonal = 0.005, k_join_of_edge = 1.5;

/// Joins the lines, makes them edges and opens these. Everything in the coordinates of the file.
CutMesh cut_through_triangles(const TriMesh& mesh, const Arguments& arguments, Session& session,
                              const ShownLengths& lengths) {
  const Patch patch(mesh);
  RequestedLines asked = requested_lines(patch, arguments);
  const double scale = scale_from(arguments);
  for (const std::string& note : asked.notes)
    session.note(note);
  const double tolerance = std::max(k_join_of_diagonal * bounding_box_diagonal(mesh),
                                    k_join_of_edge * mean_edge_length(mesh));
  const JoinedLines joined = join_lines(patch, std::move(asked.lines), tolerance);
  for (const JoinedEnd& end : joined.joined) {
    session.note((end.is_last ? "the end of " : "the beginning of ") + asked.names[end.line] +
                 " is " + lengths.text(scale * end.distance) + " from " +
                 (end.to ? asked.names[*end.to] : "the border") + "; joined");
  }
  const ImprintedMesh imprinted = imprint(patch, joined.lines);
  std::vector<CutPath> paths;
  for (std::size_t k = 0; k < imprinted.paths.size(); ++k) {
    if (imprinted.paths[k].size() > 1) paths.push_back({imprinted.paths[k], asked.places[k]});
  }
  return cut_open(Patch(imprinted.mesh), paths);
}

}  // namespace

CutInput cut_as_asked(TriMesh mesh, const std::string& path, const Arguments& arguments,
                      Session& session) {
  if (!arguments.has("--cut")) return {std::move(mesh)};
  const std::string& file = arguments.flags.at("--cut");
  return about(path, [&]() -> CutInput {
    const ShownLengths lengths(unit_from(arguments));
    if (arguments.value_or("--cut-along", "triangles") == "triangles") {
      CutMesh cut = cut_through_triangles(as_in_file(mesh, arguments), arguments, session, lengths);
      const double scale = scale_from(arguments);
      for (Vec3& p : cut.mesh.positions)
        p = scale * p;
      session.note(file + ": cut open along " + lengths.text(scale * cut.length));
      return {std::move(cut.mesh), CutOutcome{cut.edges, scale * cut.length}};
    }
    const CutLines lines = read_cuts(path_of(file), as_in_file(mesh, arguments));
    CutMesh cut = cut_open(Patch(mesh), lines.paths);
    std::string text =
        file + ": cut open along " + counted(cut.edges, "edge") + ", " + lengths.text(cut.length);
    if (lines.farthest > 0.0) {
      text += "; what is drawn is at most " + lengths.text(scale_from(arguments) * lines.farthest) +
              " from the vertices that stand for it, and between them the cut follows edges";
    }
    session.note(text);
    return {std::move(cut.mesh), CutOutcome{cut.edges, cut.length}};
  });
}

std::vector<MoreFigures> figures_of_cut(const std::optional<CutOutcome>& cut) {
  if (!cut) return {};
  return {{"cut", {{"edges", cut->edges}, {"length", cut->length}}}};
}

}  // namespace planish::cli
