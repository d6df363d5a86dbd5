#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include <planish/core/context.h>
#include <planish/measure/limit_check.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/surface_line.h>

namespace planish {

/// What a division into panels keeps low first.
enum class PanelPreference {
  few,       ///< pieces
  shortest,  ///< the length of seams
  simple,    ///< slits: there are none that end inside a piece
};
/// "few", "short" or "simple".
std::string_view to_string(PanelPreference preference);

/// One piece of a divided product.
struct SuggestedPanel {
  std::vector<Index> triangles;  ///< of PanelSuggestion::mesh, increasing
  double area = 0.0;             ///< of that of the product
  bool has_pattern = false;      ///< unfold() takes it
  bool overlaps = false;         ///< its pattern lies over itself by more than a hair
  bool changes = false;          ///< it misses the limits, and PanelOptions::can_change allows that
  EdgeStrain strain = {};        ///< of its pattern
};

/// A product divided into panels.
struct PanelSuggestion {
  /// The product, as imprint() makes seams edges of it: its vertices first; of several parts the
  /// triangles of one are behind those of the other.
  TriMesh mesh;
  std::vector<std::vector<Index>> seams;  ///< vertices of the mesh along each, from end to end
  std::vector<SuggestedPanel> panels;     ///< by their smallest triangles
  double length = 0.0;                    ///< of the seams, model units
  std::size_t tips = 0;                   ///< ends of slits inside panels
  double cost = 0.0;                      ///< J (docs/panels.md)
  /// Every panel keeps the limits, or changes, and has a pattern that lies nowhere over itself.
  bool met = false;
  bool was_cancelled = false;  ///< before all moves were made: this is the best until then
};

/// The limits for panels, and the effort of the search.
struct PanelOptions {
  StrainLimits limits = {.rms = 0.02};            ///< of each pattern; at least one
  PanelPreference prefer = PanelPreference::few;  ///< what is saved first
  /// Patterns keep the limits with both sides of each seam equally long: the mean of what they
  /// would have else.
  bool match_seams = true;
  /// As UnfoldOptions has it; the sides of slits may cross by a hair.
  double open_crossings = std::numeric_limits<double>::max();
  std::size_t moves = 12;  ///< divisions that are tried, 1 or more
  /// Where given: a plane in which the product is its own mirror image. The panels then are, but
  /// for what the product itself is not: each lies across the plane, or has a mirror image.
  std::optional<Plane> symmetric_in = {};
  std::size_t trial_vertices = 3000;  ///< of the thinned product, at least 100
  /// Called with a piece whose pattern misses the limits. Returns whether the form of the piece can
  /// be changed so that its pattern keeps them. Such pieces are not divided, so seams are shorter.
  /// A piece with more than 1.5 times trial_vertices is thinned to about trial_vertices first.
  /// Called from several threads at once; the answer must depend on the piece alone. Empty: no
  /// piece may change.
  std::function<bool(const Patch& piece, const Context& context)> can_change = {};
  /// Called with each division that is better than those before, from the calling thread; of a
  /// product of several parts once the others are divided. What it throws ends the search and is
  /// passed on.
  std::function<void(const PanelSuggestion&)> on_better = {};
};

/// Divides a product into few panels with short seams, of which each can be laid flat within the
/// limit (docs/panels.md). The same bits every time, whatever the number of threads.
/// Several parts are divided one after the other.
/// @return the best that was found; `met` says whether it keeps the limits
/// @throws Error option_out_of_range, not_symmetric, what stands in the way of Purpose::measure,
///   zero_area of a surface without any; Cancelled before there is a division
PanelSuggestion suggest_panels(const Patch& patch, const PanelOptions& options = {},
                               const Context& context = {});

}  // namespace planish
