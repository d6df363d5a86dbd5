#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <planish/core/context.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/surface_line.h>
#include <planish/mesh/tri_mesh.h>
#include <planish/report/json_report.h>

#include "shell/command.h"

namespace planish::cli {

/// --cut, how its lines are taken and mirrored, for verbs that take a patch.
std::vector<Flag> cut_flags();

/// What --cut did to a mesh.
struct CutOutcome {
  std::size_t edges = 0;
  double length = 0.0;           ///< model units
  double farthest_snap = 0.0;    ///< that a point of a line was put onto a vertex, model units
  double jag = 1.0;              ///< the largest of a line (jag_of())
  std::size_t small_pieces = 0;  ///< that were joined to a neighbour

  CutOutcome& operator+=(const CutOutcome& more);
};

/// The mesh that a verb works on, after --cut and --symmetric.
struct CutInput {
  TriMesh mesh;
  std::optional<CutOutcome> cut = {};
  std::optional<Plane> symmetric_in = {};  ///< that of --symmetric; model units
  /// Places along the lines that were cut through triangles, model units.
  std::vector<std::vector<Vec3>> lines = {};
};

/// What patterns of panels keep, beside limits.
struct PanelRules {
  bool match_seams = false;                                           ///< as PanelOptions has it
  std::function<bool(const Patch&, const Context&)> can_change = {};  ///< likewise
};

/// How far `--cut open` and `--cut auto` go.
struct OpeningLimits {
  std::size_t most_pieces = 1;  ///< as CutGraphOptions has it
  bool match_seams = false;     ///< the pieces of `--cut open` are sewn to others
  PanelRules panels = {};       ///< of `--cut auto`
};

/// @throws Error as read_cuts(), cut_open(), cut_graph() and SymmetricDesign
CutInput cut_as_asked(TriMesh mesh, const std::string& path, const Arguments& arguments,
                      Session& session, const OpeningLimits& limits = {});

/// As `--cut auto` does: divides into panels that keep the limits of the flags.
/// @throws Error as suggest_panels()
CutInput divided_into_panels(const Patch& patch, const std::string& path,
                             const Arguments& arguments, Session& session, const PanelRules& rules);

/// What --cut did as "cut": {"edges", "length", ...}, for a report.
MoreFigures figures_of(const CutOutcome& cut);
/// The same; nothing without the flag.
std::vector<MoreFigures> figures_of_cut(const std::optional<CutOutcome>& cut);

}  // namespace planish::cli
