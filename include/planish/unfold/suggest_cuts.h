#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include <planish/measure/cautions.h>
#include <planish/mesh/cut.h>
#include <planish/unfold/strain.h>
#include <planish/unfold/unfold.h>

namespace planish {

/// What a suggestion of cuts aims at, and how long it looks.
struct SuggestOptions {
  StrainLimits limits = {.max = 0.02};  ///< of the pattern; at least one for edges
  int max_darts = 6;                    ///< at most so many, besides what makes the mesh a disk
  /// Darts are tried on a patch of about so many vertices, if the mesh has more.
  std::size_t trial_vertices = 3000;
};

/// One cut of a suggestion.
struct SuggestedCut {
  std::vector<Index> path;  ///< vertices of the input mesh; of a dart, the tip is last
  double length = 0.0;      ///< model units
  bool is_dart = false;     ///< false for what makes a disk of the mesh
  /// Strain of the pattern without this cut and those after it, and with it; nothing as long as the
  /// mesh is no disk.
  std::optional<EdgeStrain> before = {}, after = {};
};

/// Why a search for cuts ended.
enum class SuggestStop {
  strain_met,  ///< the limits are kept
  dart_limit,  ///< all darts that were allowed are there
  no_gain,     ///< no dart that was tried lowers the rms strain by 5 % more
  overlap,     ///< those that do make the pattern overlap itself
};
/// "strain_met", "dart_limit", "no_gain" or "overlap".
std::string_view to_string(SuggestStop stop);

/// A mesh cut open to a disk and what its pattern is like.
struct CutPattern {
  CutMesh cut;  ///< the mesh after cutting
  /// Of the mesh after cutting, model units: with least stretch, or evened out where only that
  /// keeps the limits.
  Pattern pattern;
  EdgeStrain strain;  ///< of that pattern
};

/// What a search for cuts found.
struct CutSuggestion {
  std::vector<SuggestedCut> cuts;           ///< in the order in which they are made
  CutPattern first;                         ///< without darts
  CutPattern last;                          ///< with all cuts
  SuggestStop stop = SuggestStop::no_gain;  ///< why there are no more
  /// Where the search ended with `overlap`: the vertex of the input mesh at which a dart is needed
  /// most, and through which the patch can be divided.
  std::optional<Index> divide_at = {};
  std::vector<Caution> cautions = {};  ///< what the mesh as it came cannot show

  /// Whether the pattern with all cuts keeps the limits.
  bool met() const { return stop == SuggestStop::strain_met; }
};

/// Looks for short cuts that let a mesh lie flat with little strain (docs/cuts.md): first those
/// that make a disk of it, then darts one after the other, each the best of a few that are tried.
/// Not the shortest that there are: a greedy search. The same bits every time. On one thread.
/// @throws Error several_components, handles, option_out_of_range, and as unfold(); Cancelled
CutSuggestion suggest_cuts(const Patch& patch, const SuggestOptions& options = {},
                           const Context& context = {});

/// How cut_graph() cuts.
struct CutGraphOptions {
  /// Border loops that close in the plane stay holes: those that turn by -2 pi, or as much within
  /// pi. Else each piece gets one border loop.
  bool keep_holes = false;
  /// Of each vertex: what lengths near it count for, above 0, so that cuts go elsewhere where that
  /// is large. Empty: 1 everywhere.
  std::vector<double> weights = {};
  /// Cuts follow edges. Else each is a geodesic through triangles, from one place where cuts meet
  /// to the next.
  bool along_edges = false;
  /// Cuts also run along sharp creases, but for one straight part of a crease from face to face,
  /// and to the tips of limbs, where the pattern would have to stretch much else.
  bool relieve = false;
  /// The largest number of pieces that each connected component is divided into, to avoid patterns
  /// that overlap themselves.
  std::size_t most_pieces = 1;
  UnfoldOptions unfold = {};  ///< how these patterns are made
};

/// A mesh that was cut open to be laid flat.
struct CutGraph {
  /// In `source`: a vertex that a cut through triangles made.
  static constexpr Index none = static_cast<Index>(-1);

  /// Vertices of the mesh keep their numbers; copies and new ones come behind. Triangles that a cut
  /// runs through are divided in their place.
  TriMesh mesh;
  std::vector<Index> source;                   ///< of each vertex: the one that it is or copies
  std::vector<std::vector<Index>> paths = {};  ///< with along_edges: by vertices of the input
  std::size_t lines = 0;                       ///< cuts that were made
  std::size_t edges = 0;                       ///< that were opened, each once
  double length = 0.0;                         ///< of these, model units
};

/// Opens a mesh by short cuts so that every part of it can be laid flat: none for a disk. A handle
/// is cut along a short loop around it, several borders are joined; of a greedy homotopy basis
/// (Erickson and Whittlesey 2005) the shortest path is cut, then that of what is left. A closed
/// surface is opened along the shortest path from the ring of greatest positive angle defect to the
/// farthest of those with half as much. No cut crosses another one.
/// @throws Error option_out_of_range where there are weights, but not one for each vertex; as
///   unfold() for what no cut can mend, Cancelled
CutGraph cut_graph(const Patch& patch, const CutGraphOptions& options = {},
                   const Context& context = {});

}  // namespace planish
