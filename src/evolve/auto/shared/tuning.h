#pragma once

#include <cstddef>
#include <numbers>

#include "optimize/line_search.h"

namespace planish {

/// The constants of `auto` (docs/methods/smooth.md, docs/methods/auto.md). They were chosen by
/// trial on real patches, by bending, strain, deviation and time; none depends on the size of the
/// model. Strains and shares are fractions of 1; each angle names its unit.
namespace tuning {

// Of both methods.

/// Of the vertices of a level one in this number is on the next coarser one.
inline constexpr std::size_t k_thinning = 4;
/// Strain, rms, above which the border is taken to forbid the rest: polishing cannot do it.
inline constexpr double k_blocked_strain = 1e-2;
/// The same where holes are to close, which polishing does not see.
inline constexpr double k_blocked_strain_of_holes = 3e-4;
/// So many steps in a row that move nothing end a level.
inline constexpr int k_most_stagnant = 3;
/// Halvings of a step before it is given up.
inline constexpr int k_most_halvings = 12;
/// A vertex that has moved by this fraction of a limit of distance is held by the limit.
inline constexpr double k_at_limit = 0.99;
/// Fraction of an rms limit that the estimate by phi is led to: the strain of the pattern may be
/// larger by the rest, on all but very uneven meshes.
inline constexpr double k_rms_limit_share = 0.95;
/// Without a limit of angles, triangles keep this one (degrees), or half of the smallest at first.
inline constexpr double k_needle = 5.0;
/// Number of inner vertices at which relative_density() is 1.
inline constexpr double k_usual_count = 4000.0;
/// FairnessEnergy: a vertex whose proximity has this weight is fixed in practice.
inline constexpr double k_heaviest = 1e12;
/// FairnessEnergy: weight of a vertex of the border over that of an inner one, as it is the line of
/// the design.
inline constexpr double k_border_to_inner = 30.0;
/// FairnessEnergy: on the diagonal of matrices that nothing else makes definite.
inline constexpr double k_anchor = 1e-9;

/// Of a border that may move.
namespace border {
/// Where the border turns by more than this it has a corner, which stays: radians.
inline constexpr double k_corner = 0.5235987755982988;
/// How far along its loop a vertex slides: a share of the loop's length.
inline constexpr double k_window = 0.05;
/// As far as each of two neighbours may come towards the other: a share of the way between them.
inline constexpr double k_approach = 0.4;
}  // namespace border

/// `--prefer smooth` and `flat`.
namespace prefer_smooth {
/// Inner vertices of the coarsest level at most: most of the work is done there.
inline constexpr std::size_t k_coarsest = 2500;
/// The same where all strain is to go, a bound of bending is given or the border may move: finer
/// levels do not make up for what it misses.
inline constexpr std::size_t k_coarsest_careful = 6000;
/// Steps on the coarsest level at most.
inline constexpr int k_most_first_steps = 80;
/// Steps on finer levels: this over the number of inner vertices, as steps are expensive there and
/// little is left to do, within the two bounds after it.
inline constexpr std::size_t k_later_work = 150'000;
inline constexpr std::size_t k_least_later_steps = 5, k_most_later_steps = 30;
/// Steps at most where all strain is to go, without and with a given bound of bending.
inline constexpr int k_most_strict_steps = 40, k_most_strict_steps_bounded = 80;
/// Strain, rms, at which the last steps of `flat` begin.
inline constexpr double k_nearly_flat = 2e-4;
/// A limit counts as kept up to this factor of it, so that steps end within it; the ceiling of
/// bending may be exceeded by the same factor.
inline constexpr double k_nearly = 1.03;

/// Longest move of a vertex in a step, in mean edges.
inline constexpr double k_longest_step = 1.0;
/// So many trials of a step are also made with a second-order correction.
inline constexpr int k_corrected_trials = 2;
/// Moves along the surface change its form little, so they are held more: a length over D.
inline constexpr double k_slide = 0.01;
/// So much more beside the border where vertices slide along it.
inline constexpr double k_off_curve = 1e6;

/// A limit that leaves so little strain counts as tight, one that leaves so much as loose.
inline constexpr double k_tight = 1e-3, k_loose = 5e-3;
/// Ceiling of bending over the design's, for a tight and a loose limit.
inline constexpr double k_tight_ceiling = 1.2, k_loose_ceiling = 1.06;
/// Least delta (a length over D) for a tight and a loose limit.
inline constexpr double k_tight_delta = 0.005, k_loose_delta = 0.0025;
/// Where the border may move by this much (a length over D) or more, the least delta for a tight
/// limit; where it may move less far, it is between the two.
inline constexpr double k_far_border = 0.02, k_tight_delta_far_border = 0.00225;
/// Where the border may move, delta is the deviation times this factor.
inline constexpr double k_delta_of_deviation = 0.67;
/// With a bound of bending: least delta, and least first delta. Where all strain is to go, the
/// ceiling of bending is the bound over k_room_for_polish, as polishing adds some.
inline constexpr double k_bounded_delta = 3e-4, k_least_first_delta = 1e-3,
                        k_room_for_polish = 1.06;
/// The first delta over the least, and where all strain is to go. With a loose limit it is so much
/// times the square of the strain over its limit, up to the last.
inline constexpr double k_first_delta = 2.0, k_first_delta_flat = 4.0, k_most_first_delta = 20.0;
/// Share of the design's angles that bending is counted from, for a loose limit; 0 for a tight one.
inline constexpr double k_loose_form = 0.8;
/// Its factor in a step where the patch bends too much, and the least above 0.
inline constexpr double k_form_fall = 0.7, k_least_form = 0.1;
/// Largest delta: then closeness gives way no more.
inline constexpr double k_most_delta = 0.1;
/// First sigma, and that of the stage after it.
inline constexpr double k_first_sigma = 0.02, k_closer_sigma = 0.005;
/// Least sigma over the strain: where much strain cannot go, less would buy little of it with much
/// bending.
inline constexpr double k_least_sigma = 0.3;
/// A stage ends after this number of steps, or with one that takes less than this share of the
/// merit off.
inline constexpr int k_most_of_stage = 8;
inline constexpr double k_stage_fall = 0.05;
/// A level has settled after this number of steps that take less than this share of the merit off.
inline constexpr int k_settled_steps = 2;
inline constexpr double k_settled_fall = 1e-2;
/// The same of a step along lines, which counts as three.
inline constexpr double k_settled_fall_along_lines = 3e-2;
/// Strain is stuck after this number of steps that take less than this share of it off.
inline constexpr int k_stuck_steps = 6;
inline constexpr double k_stuck_fall = 0.02;
/// Steps with the weights of the coarser level, until what lifting broke is mended.
inline constexpr int k_steps_lifted = 3;
/// Factors of sigma in a step, at least and at most.
inline constexpr double k_least_factor = 0.7, k_most_factor = 1.4;
/// Factors of delta in a step: the root of the excess of bending of this exponent, at least (where
/// strain keeps its limit) and at most.
inline constexpr double k_delta_exponent = 0.35, k_least_delta_factor = 0.85,
                        k_most_delta_factor = 1.18;
/// The least factor of delta on the dense levels of large patches: their few steps would not let
/// the bending follow.
inline constexpr double k_least_delta_factor_large = 0.98;
/// Where all strain is to go: delta, and sigma in this number of first steps and after them.
inline constexpr double k_strict_delta = 0.0125, k_first_strict_sigma = 5e-4,
                        k_last_strict_sigma = 1e-4;
inline constexpr int k_steps_first_strict = 10;

/// With a bound of bending, where all strain is to go: strain over sigma above which delta grows,
/// and above which it does not fall.
inline constexpr double k_much_left = 4.0, k_little_left = 2.0;

/// Steps back towards the design where the surface is not smooth: tenths of the move, then halvings
/// of the last tenth.
inline constexpr int k_retreat_parts = 10, k_retreat_halvings = 3;

/// How far the second differences of a border that moves may go, in mean edges.
inline constexpr double k_border_bend = 0.04;

/// Damping of steps.
inline constexpr DampingRule k_damping = {.ease = 0.25, .tighten = 4.0, .first = 0.3};
}  // namespace prefer_smooth

/// `--prefer near`.
namespace prefer_near {
/// A patch of at most this number of vertices is worked on as it is.
inline constexpr std::size_t k_coarsest = 6000;
/// Strain, rms, at which a level is done, as lifting brings more than that and polishing takes out
/// what is left; and that at which the patch itself is done where a step leaves more than this
/// share.
inline constexpr double k_level_strain = 1e-4, k_polish_strain = 3e-4, k_quick_fall = 0.7;
/// Steps at most: on the coarsest level, on finer ones, and on those after a level that the border
/// blocks, where a few mend what lifting did.
inline constexpr int k_most_first_steps = 150, k_most_steps = 100, k_blocked_steps = 5;
/// Where vertices are at the limit of deviation, this number of steps in a row are the last that
/// leave more than this share of the strain.
inline constexpr int k_most_at_limit = 5;
inline constexpr double k_gain_at_limit = 0.98;
/// This often polishing that ends early gives way to another round of the descent: after this
/// number of slow cycles in a row where the descent had come to its end.
inline constexpr int k_most_rounds = 6, k_slow_cycles = 2;
/// A coarsest level that ends too rough is done again so often, each time with the exponent of the
/// allowance times this.
inline constexpr int k_most_tries = 3;
inline constexpr double k_exponent_decay = 0.8;

/// Where a descent begins and how far its steps go.
struct StepSchedule {
  double sigma_per_strain;  ///< of the first sigma to the rms strain at first
  double longest_step;      ///< of a vertex, in mean edges
  double fall_of_sigma;     ///< factor after a step that was not cut
};
inline constexpr StepSchedule k_cold_start{20.0, 0.6, 0.8};
/// From positions that a coarser level has found: what is left to do is little and smooth.
inline constexpr StepSchedule k_warm_start{0.5, 3.0, 0.25};
/// The start is the place found, or half way to it, or half of that, down to this share.
inline constexpr double k_least_start = 1e-3;

/// Least sigma: in all, and over the strain where that is above k_large_strain, as a small sigma
/// would buy some of it with crumples there, and where it is not.
inline constexpr double k_least_sigma = 1e-4, k_least_per_large_strain = 0.3,
                        k_least_per_strain = 0.02, k_large_strain = 0.02;
/// Factors of sigma: after a step that failed; after one that was cut to no less than the share.
inline constexpr double k_failed = 0.7, k_slow = 0.9, k_far_enough = 0.3;
/// A step was not cut from this share on. Sigma also falls after one that takes less than
/// k_small_fall of the merit off.
inline constexpr double k_full_step = 0.99, k_small_fall = 0.05;
/// While the strain is kept at its limit: sigma in a step falls and grows by these factors at most.
inline constexpr double k_most_fall = 1.5, k_most_growth = 4.0;
/// Damping of steps.
inline constexpr DampingRule k_damping = {
    .ease = 0.25, .tighten = 4.0, .first = 1.0, .nothing = 0.3};
/// Closeness does not grow from this damping on.
inline constexpr double k_stiff = 4.0;
/// Slides of the vertices at most, so that angles hold.
inline constexpr int k_most_slides = 10;
/// Proximity of vertices that are at a limit of distance is weighed so much more: of inner ones,
/// and gently of the border's, as nearly all of it comes there.
inline constexpr double k_heavier = 10.0, k_heavier_border = 4.0;
/// How closeness is spent, see ClosenessControl.
struct ClosenessPace {
  double first;               ///< of a descent from scratch
  double most;                ///< what it grows to where there is room for roughness
  double allowance_exponent;  ///< power of the strain that is left: the greater, the sooner there
                              ///< is room
  double more;                ///< degrees by which r_most exceeds r_first (1 + room), over room
};
/// Where the aim is flattenable: weights beyond `most` cost steps and bring little.
inline constexpr ClosenessPace k_usual_closeness{0.05, 8.0, 0.8, 2.5};
/// What closeness grows to where steps fall short already.
inline constexpr double k_most_if_stiff = 0.5;
/// Where the aim is a limit of strain, on patches of 4,000 vertices: what closeness begins
/// with where hardly any strain has to go, what it grows to, and its allowance_exponent.
inline constexpr double k_first_near = 2.0, k_most_near = 50.0, k_earliness_near = 1.3;
/// More room for roughness than this is not filled.
inline constexpr double k_most_room = 10.0;
/// Closeness in a step: factor where the patch is too rough, factor where there is room, which is
/// below this share of the allowance; and its least value.
inline constexpr double k_closeness_ease = 0.25, k_closeness_growth = 2.0, k_plenty = 0.8,
                        k_least_closeness = 0.005;
/// A border that is nearly held: of the strain at first the share that is much, and the least ease.
inline constexpr double k_much_strain = 0.2, k_least_ease = 1e-4;

/// Reduction of the deviation along a limit: steps at most, the number that bring little, and the
/// share of the deviation that little leaves.
inline constexpr int k_most_reduction_steps = 60, k_most_idle_reduction_steps = 15;
inline constexpr double k_worth_it = 0.995;

/// Shape, 1 for equilateral, of a triangle that is poor (about 14 degrees at its sharpest), and the
/// share of the shape that it had at first below which it is poor too.
inline constexpr double k_poor = 0.4 / 3.4641016151377544, k_worse = 0.95;
}  // namespace prefer_near

/// DefectPolish, which ends both methods where all strain has to go.
namespace polish {
/// Longest step, over the shortest edge at a vertex.
inline constexpr double k_longest_step = 0.5;
/// Done at these shares of what counts as flattenable, so that rounding does not undo it.
inline constexpr double k_e_max_share = 0.5, k_defect_sum_share = 0.8;
/// Cycles at most, and in a row those that leave nearly all of the energy: more than this share.
inline constexpr int k_most_cycles = 100, k_most_stalled = 8;
inline constexpr double k_stalled_share = 0.9;
/// A slow cycle leaves more than this share of the energy.
inline constexpr double k_slow_share = 0.7;
/// Controllable sweeps in a cycle.
inline constexpr int k_sweeps = 20;
/// Tries of the step with more damping, and halvings of each.
inline constexpr int k_most_dampings = 8, k_most_halvings = 6;
/// Damping of steps, and its factor after a try that failed. With less damping steps of dense
/// patches go too far in directions that hardly change the angle sums to first order, and single
/// precision takes more solves.
inline constexpr DampingRule k_damping = {.ease = 0.3, .tighten = 4.0, .least = 1e-6},
                             k_damping_dense = {.ease = 0.3, .tighten = 4.0, .least = 1e-4};
inline constexpr double k_tighten_much = 10.0;
/// Clusters (reduce_largest_defects) are around the vertices of the largest defects: this number at
/// most, or those that have this share of the energy.
inline constexpr std::ptrdiff_t k_most_largest = 200;
inline constexpr double k_share_of_largest = 0.95;
/// They reach this number of edges away from these.
inline constexpr int k_cluster_edges = 3;
/// Steps of a cluster at most. With the least damping, one that leaves more than this share of its
/// energy is its last.
inline constexpr int k_most_cluster_steps = 15;
inline constexpr double k_little_fall = 0.9;
/// Damping of a cluster at first, at least and at most. With less, vertices move further and the
/// energy falls no faster.
inline constexpr double k_first_cluster_damping = 1e-3, k_least_cluster_damping = 1e-4,
                        k_most_cluster_damping = 1e3;
/// Rounds at most in which vertices of triangles that are too sharp go back.
inline constexpr int k_most_rounds = 20;
}  // namespace polish
}  // namespace tuning

}  // namespace planish
