#include "cut/cut_flag.h"

#include <algorithm>
#include <string>
#include <utility>

#include <planish/io/read_features.h>
#include <planish/mesh/cut.h>
#include <planish/mesh/imprint.h>
#include <planish/unfold/suggest_cuts.h>

#include "cut/caps.h"
#include "cut/loose_paths.h"
#include "cut/panels.h"
#include "cut/requested_lines.h"
#include "cut/small_pieces.h"
#include "cut/symmetric_design.h"
#include "flags/scale_flag.h"
#include "flags/units.h"
#include "mesh/mean_edge.h"
#include "platform/path.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/session.h"
#include "shell/text.h"
#include "shell/values.h"
#include "text/lengths.h"

namespace planish::cli {

std::vector<Flag> cut_flags() {
  Flag cut = {"--cut", "LINES",
              "cut the surface along lines first: a drawing (.obj, or a pattern .svg), a list of "
              "vertices, \"plane x=0\", \"line 0,0,1 0,2,1\", rings, \"creases 30deg\", uv, "
              "groups, open or auto (panels); may be repeated"};
  cut.accepts.repeats = true;
  cut.accepts.type = ValueType::file;
  Flag along = {"--cut-along", "WHAT",
                "triangles: lines cut through them; edges: lines follow edges of the mesh (default "
                "triangles)"};
  along.accepts = {.choices = {"triangles", "edges"}, .standard = "triangles"};
  Flag smooth = {
      "--smooth-lines", "ANSWER",
      "make drawn lines smooth; moves them by up to half an edge: yes or no (default yes)"};
  smooth.accepts = {.choices = {"yes", "no"}, .standard = "yes"};
  Flag avoid = {"--avoid", "FILE",
                "places that --cut open avoids if it can: one vertex a line, an .obj with lines or "
                "points on the mesh, or an .obj or .ply of the model with these places painted"};
  avoid.accepts.type = ValueType::file;
  const Flag keep = {
      "--keep-small", "",
      "keep small pieces that cuts make; without this flag, a piece with less than 1 % of the "
      "area, or with less than 5 % and narrower than two edges, is joined to a neighbour"};
  std::vector<Flag> flags = {cut, along, smooth, avoid, keep};
  for (Flag& flag : symmetric_flags())
    flags.push_back(std::move(flag));
  for (Flag& flag : panel_flags())
    flags.push_back(std::move(flag));
  return flags;
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

/// Lines of which none runs beside another, with ends that meet.
class Cutter {
 public:
  Cutter(const std::string& path, const Arguments& arguments, Session& session)
      : path_(path),
        arguments_(arguments),
        session_(session),
        lengths_(unit_from(arguments)),
        scale_(scale_from(arguments)) {}

  /// @param symmetric null where the design is not to be its own mirror image
  CutInput cut(TriMesh mesh, SymmetricDesign* symmetric) {
    Patch patch(as_in_file(mesh, arguments_));
    asked_ = requested_lines(patch, path_, arguments_);
    check_count(asked_.lines);
    for (const std::string& note : asked_.notes)
      session_.note(note);
    make_single(patch);
    join_ends(patch, 0.0);
    if (symmetric != nullptr) {
      mesh = symmetric->surface_for(asked_);
      patch = Patch(as_in_file(mesh, arguments_));
      asked_ = symmetric->with_images(std::move(asked_), mesh);
      join_ends(patch, 0.1 * join_tolerance(patch.mesh()));  // what the first time led to the plane
    }
    const ImprintedMesh imprinted = imprint(Patch(mesh), asked_.lines);
    const Patch whole(imprinted.mesh);
    std::vector<LinePath> paths;
    for (std::size_t k = 0; k < asked_.lines.size(); ++k)
      paths.push_back({imprinted.paths[k], k});
    SmallLimits limits;
    if (!arguments_.has("--keep-small")) limits = {0.01, 2.0 * mean_edge_length(mesh)};
    const KeptPaths kept = without_small_pieces(whole, paths, limits);
    for (const SmallPiece& piece : kept.small)
      tell(piece);
    const AttachedPaths attached = attached_paths(whole, kept.paths);
    tell_loose(attached.loose);
    tell_free_ends(kept.inside, attached.loose);
    std::vector<CutPath> cuts;
    for (const LinePath& line : attached.paths)
      cuts.push_back({line.vertices, asked_.places[line.line]});
    if (cuts.empty() && !asked_.names.empty()) {
      throw Error(ErrorCode::misplaced_cut,
                  "--cut " + arguments_.text("--cut") +
                      ": nothing is left to cut, as notes tell; --keep-small keeps small pieces");
    }
    CutMesh opened = cut_open(whole, cuts);
    std::vector<std::vector<Vec3>> lines = lines_of(imprinted.mesh, attached.paths);
    const double jagged = jag(lines, mean_edge_length(mesh));
    return {.mesh = std::move(opened.mesh),
            .cut = CutOutcome{opened.edges, opened.length, imprinted.farthest_snap, jagged,
                              kept.small.size()},
            .lines = std::move(lines)};
  }

 private:
  std::string text(double length) const { return lengths_.text(scale_ * length); }
  std::string name(const std::optional<std::size_t>& line) const {
    return line ? asked_.names[*line] : "the border";
  }

  /// Of lines that run side by side one is left.
  void make_single(const Patch& patch) {
    constexpr double k_double = 1e-3;  // of the diagonal
    SingleLines single = single_lines(patch, std::move(asked_.lines),
                                      k_double * bounding_box_diagonal(patch.mesh()));
    for (const DoubleStretch& stretch : single.doubled) {
      session_.note(asked_.names[stretch.line] + " runs beside " + name(stretch.beside) + " for " +
                    text(stretch.length) +
                    (stretch.beside ? "; they are made one" : "; nothing is cut there"));
    }
    RequestedLines left{std::move(single.lines), {}, {}};
    for (const std::size_t line : single.of) {
      left.names.push_back(asked_.names[line]);
      left.places.push_back(asked_.places[line]);
    }
    asked_ = std::move(left);
  }

  /// Leads ends of the lines on to what they nearly meet, and tells of those that were farther.
  void join_ends(const Patch& patch, double farther) {
    constexpr double k_nearly =
        3.0;  // tolerances: ends that are farther away, as darts', are meant
    const double tolerance = join_tolerance(patch.mesh());
    JoinedLines joined = join_lines(patch, std::move(asked_.lines), tolerance);
    for (const LineEnd& end : joined.joined) {
      if (end.distance < farther) continue;
      session_.note((end.is_last ? "the end of " : "the beginning of ") + name(end.line) + " is " +
                    text(end.distance) + " from " + name(end.to) + "; joined");
    }
    asked_.lines = std::move(joined.lines);
    free_ends_ = std::move(joined.free);
    // Who names a vertex, as the tip of a dart, means it.
    std::erase_if(free_ends_, [&](const LineEnd& end) {
      const SurfaceLine& line = asked_.lines[end.line];
      const SurfacePoint& at = end.is_last ? line.back() : line.front();
      const bool is_vertex = *std::max_element(at.shares.begin(), at.shares.end()) == 1.0;
      return is_vertex || !(end.distance <= k_nearly * tolerance);
    });
  }

  void tell_loose(const std::vector<std::size_t>& lines) const {
    if (lines.empty()) return;
    std::vector<std::string> names;
    names.reserve(lines.size());
    for (const std::size_t line : lines)
      names.push_back(asked_.names[line]);
    session_.note(list_of_some(names) + (lines.size() == 1 ? " meets" : " meet") +
                  " neither the border nor another cut; nothing is cut there");
  }

  /// Of drawn lines that part nothing: it may be that one was meant to go on.
  void tell_free_ends(const std::vector<std::size_t>& inside,
                      const std::vector<std::size_t>& loose) const {
    const auto has = [](const std::vector<std::size_t>& lines, std::size_t line) {
      return std::find(lines.begin(), lines.end(), line) != lines.end();
    };
    std::vector<LineEnd> shown = free_ends_;
    std::erase_if(shown, [&](const LineEnd& end) {
      const bool is_drawn = asked_.places[end.line].line.has_value();
      return !is_drawn || !has(inside, end.line) || has(loose, end.line);
    });
    if (shown.empty()) return;
    const LineEnd& end = shown.front();
    const std::size_t more = shown.size() - 1;
    session_.note((end.is_last ? "the end of " : "the beginning of ") + name(end.line) +
                  " stays free, " + text(end.distance) + " from " + name(end.to) +
                  (more > 0 ? "; so does that of " + counted(more, "other line") : ""));
  }

  static std::vector<std::vector<Vec3>> lines_of(const TriMesh& mesh,
                                                 const std::vector<LinePath>& paths) {
    std::vector<std::vector<Vec3>> lines;
    for (const LinePath& path : paths) {
      std::vector<Vec3>& line = lines.emplace_back();
      for (const Index v : path.vertices)
        line.push_back(mesh.positions[v]);
    }
    return lines;
  }

  /// The largest of the lines.
  static double jag(const std::vector<std::vector<Vec3>>& lines, double edge) {
    double largest = 1.0;
    for (const std::vector<Vec3>& line : lines)
      largest = std::max(largest, jag_of(line, edge));
    return largest;
  }

  void tell(const SmallPiece& piece) const {
    std::vector<std::string> names;
    for (const std::size_t line : piece.lines) {
      if (std::find(names.begin(), names.end(), asked_.names[line]) == names.end())
        names.push_back(asked_.names[line]);
    }
    const std::string stem = stem_of(path_) + "-";
    session_.warn("piece " + stem + std::to_string(piece.piece + 1) + " between " +
                  list_of_some(names) + " has " + percent(piece.area) +
                  " of the area; it is joined to " + stem + std::to_string(piece.joined_to + 1) +
                  ", and --keep-small keeps it");
  }

  const std::string& path_;
  const Arguments& arguments_;
  Session& session_;
  ShownLengths lengths_;
  double scale_;
  RequestedLines asked_;
  std::vector<LineEnd> free_ends_ = {};
};

/// The lists of vertices that stand for a file: of a caller, or as they were typed.
std::optional<Rows> listed_rows(const Arguments& arguments) {
  if (arguments.rows.contains("--cut")) return arguments.rows_of("--cut");
  Rows rows{"--cut", {}};
  for (const Field& field : arguments.flags.at("--cut")) {
    const std::string text = field_text(field);
    if (text.find_first_not_of("0123456789 ,\t") != std::string::npos) return std::nullopt;
    for (Row& row : parse_rows(text, "--cut").rows)
      rows.rows.push_back({std::move(row.fields), rows.rows.size() + 1});
  }
  return rows;
}

/// Cuts along edges between vertices of the mesh.
CutInput cut_along_edges(const TriMesh& mesh, const Arguments& arguments, Session& session) {
  const std::string file = arguments.text("--cut");
  const std::optional<Rows> listed = listed_rows(arguments);
  const CutLines along =
      listed ? cuts_in(*listed, mesh) : read_cuts(path_of(file), as_in_file(mesh, arguments));
  if (along.farthest > 0.0) {
    session.note(file + ": what is drawn is at most " +
                 ShownLengths(unit_from(arguments)).text(scale_from(arguments) * along.farthest) +
                 " from the vertices that stand for it, and between them the cut follows edges");
  }
  CutMesh opened = cut_open(Patch(mesh), along.paths);
  return {std::move(opened.mesh), CutOutcome{opened.edges, opened.length}};
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
                const OpeningLimits& limits) {
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
                                      ShownLengths(unit_from(arguments)).text(graph.length));
  return {std::move(graph.mesh), CutOutcome{graph.edges, graph.length}};
}

/// @param symmetric null where the design is not to be its own mirror image
CutInput cut_along_lines(TriMesh mesh, SymmetricDesign* symmetric, const std::string& path,
                         const Arguments& arguments, Session& session) {
  CutInput cut = is_through_triangles(arguments)
                     ? Cutter(path, arguments, session).cut(std::move(mesh), symmetric)
                     : cut_along_edges(mesh, arguments, session);
  session.note(arguments.text("--cut") + ": cut open along " + counted(cut.cut->edges, "edge") +
               ", " + ShownLengths(unit_from(arguments)).text(cut.cut->length));
  return cut;
}

CutInput cut_without_images(TriMesh mesh, const std::string& path, const Arguments& arguments,
                            Session& session, const OpeningLimits& limits) {
  CutInput result = {std::move(mesh), CutOutcome{}};
  if (asks_for_lines(arguments))
    result = cut_along_lines(std::move(result.mesh), nullptr, path, arguments, session);
  if (asks_to_open(arguments)) {
    CutInput open = opened(std::move(result.mesh), arguments, session, limits);
    *open.cut += *result.cut;
    return open;
  }
  if (asks_for_panels(arguments)) {
    CutInput divided =
        divided_into_panels(Patch(result.mesh), path, arguments, session, limits.panels);
    *divided.cut += *result.cut;
    return divided;
  }
  return result;
}

}  // namespace

CutOutcome& CutOutcome::operator+=(const CutOutcome& more) {
  edges += more.edges;
  length += more.length;
  farthest_snap = std::max(farthest_snap, more.farthest_snap);
  jag = std::max(jag, more.jag);
  small_pieces += more.small_pieces;
  return *this;
}

CutInput cut_as_asked(TriMesh mesh, const std::string& path, const Arguments& arguments,
                      Session& session, const OpeningLimits& limits) {
  const bool opens = asks_to_open(arguments);
  panel_options_from(arguments);  // check them before any work
  if (!asks_for_panels(arguments)) note_idle_panel_flags(arguments, session);
  if (arguments.has("--avoid") && !opens)
    throw UsageError("flag --avoid says where cuts do not go: it needs --cut open");
  const bool is_symmetric = asks_for_symmetry(arguments);
  if (!arguments.has("--cut") && !is_symmetric) return {std::move(mesh)};
  return about(path, [&]() -> CutInput {
    if (is_through_triangles(arguments)) mesh = without_caps(std::move(mesh), arguments, session);
    if (!is_symmetric) return cut_without_images(std::move(mesh), path, arguments, session, limits);
    SymmetricDesign symmetric(mesh, path, arguments, session);
    RequestedLines none;
    CutInput input = asks_for_lines(arguments)
                         ? cut_along_lines(mesh, &symmetric, path, arguments, session)
                         : CutInput{symmetric.surface_for(none)};
    if (asks_for_panels(arguments)) {
      CutInput divided =
          divided_into_panels(Patch(input.mesh), path, arguments, session, limits.panels);
      if (input.cut) *divided.cut += *input.cut;
      input = std::move(divided);
    }
    input.mesh = symmetric.with_symmetric_pieces(input.mesh);
    input.symmetric_in = symmetric.plane();
    return input;
  });
}

CutInput divided_into_panels(const Patch& patch, const std::string& path,
                             const Arguments& arguments, Session& session,
                             const PanelRules& rules) {
  const PanelSuggestion found =
      about(path, [&] { return panels_as_asked(patch, path, arguments, session, rules); });
  session.note("--cut auto: " + panels_words(found, unit_from(arguments)) +
               (found.met ? "" : "; not every piece keeps the limit of strain"));
  return cut_into_panels(found);
}

MoreFigures figures_of(const CutOutcome& cut) {
  return {"cut",
          {{"edges", cut.edges},
           {"length", cut.length},
           {"farthest_snap", cut.farthest_snap},
           {"jag", cut.jag},
           {"small_pieces_joined", cut.small_pieces}}};
}

std::vector<MoreFigures> figures_of_cut(const std::optional<CutOutcome>& cut) {
  if (!cut) return {};
  return {figures_of(*cut)};
}

}  // namespace planish::cli
