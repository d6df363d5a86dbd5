#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <planish/core/context.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/surface_line.h>
#include <planish/unfold/strain.h>

namespace planish {

/// How much more rms strain a pattern that spreads its stretch may have, at most, than the one of
/// least stretch (docs/unfold.md, "Spreading the stretch").
inline constexpr double k_spread_budget = 1.06;

/// By how much unfold_patch() moves borders apart that cross by a hair
/// (UnfoldOptions::open_crossings), millimetres.
inline constexpr double k_hair = 0.1;

/// How long a border edge is to be in the pattern.
struct EdgeLength {
  std::array<Index, 2> edge;  ///< the vertices at its ends
  double length;              ///< model units, above 0

  bool operator==(const EdgeLength&) const = default;
};

/// How a patch is laid flat.
struct UnfoldOptions {
  int max_iterations = 200;  ///< Newton steps at most
  /// Every border edge keeps its length, so that borders which are sewn together stay equally long;
  /// what stretch there is lies inside.
  bool match_seams = false;
  /// With match_seams, where no pattern keeps the border's lengths: the result is the one without,
  /// and Pattern::is_unmatchable says so. Else an Error unfold_failed.
  bool match_if_possible = false;
  /// Border edges that may change theirs all the same, as they are sewn to nothing: by the vertices
  /// at their ends.
  std::vector<std::array<Index, 2>> free_edges = {};
  /// With match_seams: border edges that get other lengths than their own.
  std::vector<EdgeLength> seam_lengths = {};
  /// True: the pattern of least stretch, which has little rms strain. False: for up to
  /// k_spread_budget of that, the largest strains are made as small as they get, where no limit
  /// changes the pattern. With match_seams both are among patterns of matched seams.
  bool least_stretch = false;
  /// The result is the pattern of least stretch that keeps the limits of edges; if none does, one
  /// that uses up nearly the smallest multiple of them. limits.rms alone, where least stretch
  /// misses it, gives a pattern of less rms. With match_seams only patterns with matched seams
  /// are considered, even if none of them keeps the limits. check_limits() says which are kept.
  StrainLimits limits = {};
  /// Where the border crosses itself by a hair, its vertices are moved apart by this at most, model
  /// units, and by a thousandth of the square root of the patch's area; 0 leaves them. With
  /// match_seams too, where it changes lengths by about as much at most.
  double open_crossings = 0.0;
  /// The ends of a stretch of the border, along which the patch is the half of a symmetric whole.
  /// Where it lies in a plane, but for a thousandth of its length, the whole is laid flat, and the
  /// pattern is the half of that: the stretch is straight in it. Elsewhere it is idle.
  std::optional<std::array<Index, 2>> fold = {};
  /// The pattern of a patch that is symmetric in this plane vertex by vertex (Symmetry::image) is
  /// its own mirror image, to rounding, where that turns no triangle over. Idle for others, and
  /// with a fold, which has a plane of its own.
  std::optional<Plane> symmetric_in = {};
};

/// Where the border of a pattern crossed itself by a hair and was moved apart.
struct OpenedCrossings {
  std::size_t crossings = 0;  ///< how many there were; a hundred are opened at most
  double largest_move = 0.0;  ///< of a border vertex, model units
  Index vertex = 0;           ///< of the mesh: the one that moved most
};

/// The holes of a patch, which its pattern has too.
struct PatternHoles {
  std::size_t count = 0;  ///< how many there are
  double longest = 0.0;   ///< length of the longest border of one on the patch, model units
};

/// A patch laid flat, in the plane and true to scale, in model units. It is turned so that its
/// bounding box is smallest, the longer side along x, the lower left corner at the origin; the
/// outer side of the patch faces up.
struct Pattern {
  std::vector<Vec2> positions;        ///< one per vertex of the mesh; unused vertices at the origin
  double width = 0.0, height = 0.0;   ///< of the bounding box, model units
  double area_ratio = 1.0;            ///< area of the pattern over area of the patch
  std::size_t flipped_triangles = 0;  ///< triangles whose area is not positive
  bool overlaps = false;   ///< the border crosses itself: cut the patch before cutting cloth
  int iterations = 0;      ///< Newton steps that were made
  bool converged = false;  ///< false: stopped at max_iterations
  /// With match_seams: the pattern of least stretch without it, of the same size, turned and
  /// shifted somehow. Tells what matching costs.
  std::vector<Vec2> unmatched_least_stretch = {};
  /// Where a limit or spreading changed the pattern: that of least stretch, with match_seams of
  /// those that match, turned and shifted somehow.
  std::vector<Vec2> least_stretch = {};
  /// With match_seams and match_if_possible: no pattern that keeps the border's lengths was found.
  bool is_unmatchable = false;
  std::optional<OpenedCrossings> opened = {};  ///< see UnfoldOptions::open_crossings
  std::optional<PatternHoles> holes = {};      ///< nothing where there are none
};

/// Whether unfold() takes a patch of this kind and size. For callers who change it first.
/// @throws Error what stands in the way of Purpose::unfold, too_large (above 2 million vertices)
void require_unfoldable(const Patch& patch);

/// Lays a disk patch, perhaps with holes, flat with the least stretch and no flipped triangle:
/// minimises the symmetric
/// Dirichlet energy by projected Newton steps from a conformal start (docs/unfold.md), and spreads
/// the stretch that is left. On a patch that is flattenable, edge lengths are kept. Limits are kept
/// by an interior-point method from there. With match_seams, border edges that are not free keep
/// theirs on any patch, within limits or not: to 1e-9 of each, as long as none is shorter than a
/// millionth of the patch.
/// @throws Error as require_unfoldable(); option_out_of_range, as require() of limits;
///   unfold_failed where no pattern without flips is found, or none keeps the border's lengths and
///   match_if_possible does not let that pass; Cancelled
Pattern unfold(const Patch& patch, const UnfoldOptions& options = {}, const Context& context = {});

/// The smallest limit of the |strain| of every edge for which a pattern is found: least is the
/// pattern of least stretch. To 1 % of itself: a smaller one may be possible by so much.
/// @pre least is unfold() of the mesh without limits and match_seams
/// @throws Cancelled
double smallest_limit(const Patch& patch, const Pattern& least, const Context& context = {});

/// The pattern as a mesh in the plane z = 0, with the triangles and vertex numbers of `mesh`.
TriMesh flat_mesh(const TriMesh& mesh, const Pattern& pattern);

/// Where the border of a pattern crosses itself.
struct Overlap {
  Vec2 low, high;             ///< box around these places, model units
  std::size_t crossings = 0;  ///< how many there are; a thousand are counted at most
};

/// Nothing where the border does not cross itself.
std::optional<Overlap> overlap_of(const Patch& patch, const Pattern& pattern);

}  // namespace planish
