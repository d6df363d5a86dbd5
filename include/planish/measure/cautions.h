#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <planish/core/unit.h>
#include <planish/mesh/patch.h>

namespace planish {

// What a mesh cannot show of the surface that it stands for: all figures are those of the mesh, and
// where one of these is found they may be wrong for the surface (docs/mesh_quality.md).

/// Double curvature shows at inner vertices only, and there are too few of them. Meshes whose edges
/// are the rulings of a bent sheet, or that have plane facets, need none.
struct HiddenCurvature {
  /// Of the area, what lies around inner vertices: a third of each triangle for each of its inner
  /// corners. 0 where no vertex is inside.
  double inner_share = 0.0;
};

/// Facets turn by more than 10 degrees from one to the next, in one sense, as chords of an arc do.
struct CoarseFacets {
  /// The angle of the arc that a facet's edge spans, degrees: that which 90 % of the area do not
  /// exceed.
  double turn = 0.0;
  /// By how much the chord of such an arc is shorter than the arc: 1 - 2 sin(a / 2) / a.
  double shortening = 0.0;
};

/// The coordinates have few digits beside the length of the edges: numbers of 32 bits, or of few
/// decimal digits, far from the origin.
struct CoarseCoordinates {
  double step = 0.0;       ///< between neighbouring numbers, of the coarsest axis; model units
  double mean_edge = 0.0;  ///< model units
};

/// Short waves in most places that run no way: the noise of a scan.
struct ScanNoise {
  /// How far smoothing by `wave` moves inner vertices, rms; model units.
  double amplitude = 0.0;
  /// A length for smooth_design() that takes the noise out and leaves the form; model units.
  double wave = 0.0;
};

/// One thing that a mesh cannot show.
using Caution = std::variant<HiddenCurvature, CoarseCoordinates, CoarseFacets, ScanNoise>;

/// Calls visit(name, value) for each figure of a caution.
template <class Visit>
void describe(const HiddenCurvature& caution, const Visit& visit) {
  visit("inner_share", caution.inner_share);
}
/// The same of facets.
template <class Visit>
void describe(const CoarseFacets& caution, const Visit& visit) {
  visit("turn", caution.turn);
  visit("shortening", caution.shortening);
}
/// The same of coordinates.
template <class Visit>
void describe(const CoarseCoordinates& caution, const Visit& visit) {
  visit("step", caution.step);
  visit("mean_edge", caution.mean_edge);
}
/// The same of noise.
template <class Visit>
void describe(const ScanNoise& caution, const Visit& visit) {
  visit("amplitude", caution.amplitude);
  visit("wave", caution.wave);
}

/// Of the area around inner vertices this share at least is needed to judge a surface.
inline constexpr double k_judged_share = 0.5;

/// None where k_judged_share of the area is around inner vertices, or all facets are plane or fans
/// of rulings. O(n).
std::optional<HiddenCurvature> find_hidden_curvature(const Patch& patch);

/// None where 90 % of the area turns by 10 degrees or less. Turns that stand alone, or of 50
/// degrees and more, are creases of the design. O(n log n).
std::optional<CoarseFacets> find_coarse_facets(const Patch& patch);

/// None where the step is at most a hundredth of the mean edge. O(n log n) far from the origin,
/// else O(n).
std::optional<CoarseCoordinates> find_coarse_coordinates(const Patch& patch);

/// None where bends run along lines, as those of designs do, in most places. O(n); where there is
/// noise the length is sought by smoothing some times.
std::optional<ScanNoise> find_scan_noise(const Patch& patch);

/// All of the above; facets are not judged where there is noise.
std::vector<Caution> find_cautions(const Patch& patch);

/// The same of a design that was smoothed. Smoothing gives coordinates all digits, and leaves them
/// where they were rounded to.
std::vector<Caution> find_cautions(const Patch& raw, const Patch& smoothed);

/// "hidden_curvature", "coarse_coordinates", "coarse_facets" or "scan_noise".
std::string_view code_of(const Caution& caution);

/// A few words without figures, to be read in a list: "no vertex inside", "coarse facets".
std::string_view words_of(const Caution& caution);

/// Those of all, with commas; empty for none.
std::string words_of(std::span<const Caution> cautions);

/// One or two sentences with the figures and what to do. Plain UTF-8 text.
/// @param unit one unit of the model
std::string caution_text(const Caution& caution, Unit unit);

/// The first that forbids to say whether a surface lies flat: hidden curvature where its mesh does,
/// coarse coordinates in any case. Null where there is none.
const Caution* unjudged_by(std::span<const Caution> cautions, bool is_mesh_flat);

}  // namespace planish
