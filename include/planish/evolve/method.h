#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <planish/core/range.h>
#include <planish/core/vec.h>
#include <planish/measure/limit_check.h>

namespace planish {

/// What the vertices of the border may do while the inner ones move.
struct BorderFreedom {
  /// How far the border is free.
  enum class Rule {
    fixed,   ///< stay where they are
    slide,   ///< go along the border as it was, not past its corners nor one another
    within,  ///< go anywhere within a distance of where they were
  };
  Rule rule = Rule::fixed;  ///< how far it is free
  double distance = 0.0;    ///< model units; for `within` alone

  /// Whether any vertex of the border may move.
  bool moves() const { return rule == Rule::slide || (rule == Rule::within && distance > 0.0); }
  friend bool operator==(const BorderFreedom&, const BorderFreedom&) = default;
};

/// The names of rules. `within` has none: a distance stands for it.
inline constexpr std::array k_border_freedoms = {
    std::pair{BorderFreedom::Rule::fixed, std::string_view("fixed")},
    std::pair{BorderFreedom::Rule::slide, std::string_view("slide")}};
constexpr const auto& names_of(BorderFreedom::Rule) {
  return k_border_freedoms;
}

/// Which solver finds the step that minimises the ring energy.
enum class LineSolver {
  model,         ///< by a model of the line that each evaluation betters; several vertices at once
  trust_region,  ///< by the interior-reflective trust-region Newton method that the paper names
};
inline constexpr std::array k_line_solvers = {
    std::pair{LineSolver::model, std::string_view("model")},
    std::pair{LineSolver::trust_region, std::string_view("trust_region")}};
constexpr const auto& names_of(LineSolver) {
  return k_line_solvers;
}

/// Controllable Laplacian evolution: every inner vertex takes the step along its Laplacian vector
/// that lowers the ring energy most, and none where none lowers it (Eq. 11-17, corrected). Energy
/// never rises. docs/methods/controllable.md
struct ControllableLaplacian {
  static constexpr std::string_view name = "controllable";
  static constexpr int usual_sweeps = 10;
  static constexpr bool honours_weights = false, honours_obstacle = false;
  double lambda_min = 0.0;
  double lambda_max = 1.0;
  double min_angle = 1.0;
  double max_deviation = std::numeric_limits<double>::infinity();
  LineSolver solver = LineSolver::model;
};

template <class Visit>
void describe(ControllableLaplacian& o, Visit&& visit) {
  visit("lambda_min", o.lambda_min,
        "smallest step along the Laplacian vector; below 0 saddles can improve", Range{-10.0, 0.0});
  visit("lambda_max", o.lambda_max, "largest step along the Laplacian vector", Range{0.0, 10.0});
  visit("min_angle", o.min_angle,
        "with lambda_min below 0: no triangle gets an angle below this, or below its present "
        "one if that is smaller, in degrees",
        Range{0.0, 60.0});
  visit("max_deviation", o.max_deviation,
        "no vertex ends further than this from where it began, in model units", Range{0.0});
  visit("solver", o.solver, "how the best step is computed; trust_region is the paper's");
}

/// In what order a sweep moves the vertices.
enum class SweepOrder {
  sequential,    ///< each vertex sees the moves made before it in the sweep (Gauss-Seidel)
  simultaneous,  ///< all vertices see the positions before the sweep (Jacobi)
};
inline constexpr std::array k_sweep_orders = {
    std::pair{SweepOrder::sequential, std::string_view("sequential")},
    std::pair{SweepOrder::simultaneous, std::string_view("simultaneous")}};
constexpr const auto& names_of(SweepOrder) {
  return k_sweep_orders;
}

/// Classical Laplacian evolution: every inner vertex takes the same share of its Laplacian vector
/// (Eq. 9-10). Energy may rise. docs/methods/classical.md
struct ClassicalLaplacian {
  static constexpr std::string_view name = "classical";
  static constexpr int usual_sweeps = 10;
  static constexpr bool honours_weights = false, honours_obstacle = false;
  double lambda = 0.5;
  SweepOrder order = SweepOrder::sequential;
  double max_deviation = std::numeric_limits<double>::infinity();
};

template <class Visit>
void describe(ClassicalLaplacian& o, Visit&& visit) {
  visit("lambda", o.lambda, "share of the Laplacian vector that every vertex moves",
        Range{0.0, 1.0});
  visit("order", o.order, "order of the moves in a sweep");
  visit("max_deviation", o.max_deviation,
        "no vertex ends further than this from where it began, in model units", Range{0.0});
}

/// How a least-norm step is turned into the next positions.
enum class LeastNormUpdate {
  direct,     ///< the step itself
  uniform,    ///< the least-squares update: stepped, then faired with the umbrella vector
  cotangent,  ///< the same, faired with the cotangent Laplacian
};
inline constexpr std::array k_least_norm_updates = {
    std::pair{LeastNormUpdate::direct, std::string_view("direct")},
    std::pair{LeastNormUpdate::uniform, std::string_view("uniform")},
    std::pair{LeastNormUpdate::cotangent, std::string_view("cotangent")}};
constexpr const auto& names_of(LeastNormUpdate) {
  return k_least_norm_updates;
}

/// Least norm (Wang 2008, SMI): the shortest move of all inner vertices together that closes every
/// angle sum to first order, again and again; at first faired, then direct.
/// docs/methods/least_norm.md
struct LeastNorm {
  static constexpr std::string_view name = "least_norm";
  static constexpr int usual_sweeps = 200;
  static constexpr bool honours_weights = true, honours_obstacle = false;
  LeastNormUpdate update = LeastNormUpdate::cotangent;
  double switch_e_max = 1e-3;
  int switch_after = 20;
  double switch_fall = 0.01;
  double damping = 0.0;
  double border_weight = 1.0;
  double max_step = 0.5;
  double min_step = 1e-6;
};

template <class Visit>
void describe(LeastNorm& o, Visit&& visit) {
  visit("update", o.update, "how a step becomes positions until direct steps take over");
  visit("switch_e_max", o.switch_e_max,
        "direct steps take over when e_max is below this, in radians", Range{0.0});
  visit("switch_after", o.switch_after,
        "and after this number of faired steps, when one gains too little", Range{0.0, 1e9});
  visit("switch_fall", o.switch_fall, "too little: e_max falls by less than this, in radians",
        Range{0.0});
  visit(
      "damping", o.damping,
      "of faired steps, in units of the matrix's median diagonal; 0: 3e-6 for cotangent, 3e-4 for "
      "uniform",
      Range{0.0, 1e3});
  visit("border_weight", o.border_weight,
        "weight of moves of vertices next to the border; 10 keeps the patch's slant there",
        Range{1e-3, 1e3});
  visit("max_step", o.max_step, "a direct step moves no vertex by more of its shortest edge",
        Range{1e-6, 10.0});
  visit("min_step", o.min_step,
        "converged when the rms step is below this share of the mean edge length", Range{0.0, 1.0});
}

/// Flattenable Laplacian mesh (Wang 2008, Computer-Aided Design): the fairest surface near the
/// input patch whose angle sums are all closed, by Newton's method for the Lagrangian without
/// the second derivatives of the angles. docs/methods/flattenable_laplacian.md
struct FlattenableLaplacian {
  static constexpr std::string_view name = "flattenable_laplacian";
  static constexpr int usual_sweeps = 100;
  static constexpr bool honours_weights = true, honours_obstacle = false;
  double fairness = 1.0;
  double position = 0.1;
  double tau = 0.25;
  double damping = 1e-2;
  int rebase_every = 0;
  double min_step = 1e-5;
};

template <class Visit>
void describe(FlattenableLaplacian& o, Visit&& visit) {
  visit("fairness", o.fairness, "w1: how much edges are to be short and even", Range{0.0, 1e6});
  visit("position", o.position, "w2: how much vertices are to stay where they began",
        Range{1e-9, 1e6});
  visit("tau", o.tau, "share of each step that is taken", Range{1e-3, 1.0});
  visit("damping", o.damping,
        "how soft the constraints are, in units of the matrix; as small as 1e-9 they are hard, as "
        "printed, which few dense patches bear",
        Range{1e-12, 1e3});
  visit("rebase_every", o.rebase_every,
        "number of steps after which the positions reached become those to stay at; 0: never",
        Range{0.0, 1e9});
  visit("min_step", o.min_step,
        "converged when the rms step is below this share of the mean edge length", Range{0.0, 1.0});
}

/// Local offsets after Wang and Tang 2004: always the inner vertex with the largest defect moves,
/// along the normal that it had at first and no further than a band, so that its ring energy
/// falls. Energy never rises. docs/methods/local_offset.md
struct LocalOffset {
  static constexpr std::string_view name = "local_offset";
  static constexpr int usual_sweeps = 200;
  static constexpr bool honours_weights = false, honours_obstacle = false;
  double band = 0.0;
  double enough = 1e-2;
  int max_updates = 500'000;
};

template <class Visit>
void describe(LocalOffset& o, Visit&& visit) {
  visit("band", o.band,
        "no vertex ends further than this from where it began, in model units; 0 for the mean "
        "length of the edges at inner vertices",
        Range{0.0});
  visit("enough", o.enough, "a defect of at most this is left alone, in radians", Range{0.0});
  visit("max_updates", o.max_updates, "largest number of vertices tried, in all sweeps together",
        Range{0.0, 1e9});
}

/// What a method that can move the border does with it.
enum class BorderRule {
  fixed,   ///< border vertices stay
  linked,  ///< those at exactly the same place move as one, so seams stay closed; others stay
};
inline constexpr std::array k_border_rules = {
    std::pair{BorderRule::fixed, std::string_view("fixed")},
    std::pair{BorderRule::linked, std::string_view("linked")}};
constexpr const auto& names_of(BorderRule) {
  return k_border_rules;
}

/// Global optimisation after Wang and Tang 2004: all inner vertices move at once, edges keep their
/// lengths as well as they can while a penalty on the summed squared defects grows.
/// docs/methods/global_penalty.md
struct GlobalPenalty {
  static constexpr std::string_view name = "global_penalty";
  static constexpr int usual_sweeps = 200;
  static constexpr bool honours_weights = false, honours_obstacle = false;
  int cg_steps = 5;
  double tolerance = 1e-4;
  BorderRule border = BorderRule::fixed;
};

template <class Visit>
void describe(GlobalPenalty& o, Visit&& visit) {
  visit("cg_steps", o.cg_steps, "conjugate-gradient steps between two settings of the penalty",
        Range{1.0, 1000.0});
  visit("tolerance", o.tolerance,
        "done when a sweep changes the summed squared defects by at most this share of what they "
        "were at first",
        Range{0.0, 1.0});
  visit("border", o.border,
        "whether border vertices that came at the same place, as on the two sides of a seam, stay "
        "or move together; all others stay");
}

/// Local flattenable perturbation (Wang, Towards flattenable mesh surfaces, 2008): around the worst
/// vertex, again and again, the least change that makes all angle sums of a few rings 2 pi to first
/// order. For patches that are nearly flattenable; keeps out of an obstacle.
/// docs/methods/local_perturbation.md
struct LocalPerturbation {
  static constexpr std::string_view name = "local_perturbation";
  static constexpr int usual_sweeps = 50;
  static constexpr bool honours_weights = true, honours_obstacle = true;
  int rings = 3;
  int inner_steps = 5;
  double tau = 0.1;
  double enough = 1e-3;
  double clearance = 0.0;
  double max_deviation = std::numeric_limits<double>::infinity();
};

template <class Visit>
void describe(LocalPerturbation& o, Visit&& visit) {
  visit("rings", o.rings, "number of rings around a vertex that move at once", Range{1.0, 10.0});
  visit("inner_steps", o.inner_steps, "steps each time that a vertex is taken", Range{1.0, 1000.0});
  visit("tau", o.tau, "share of the solved step that is gone", Range{0.0, 1.0});
  visit("enough", o.enough, "e_max at which the method is done, in radians", Range{0.0});
  visit("clearance", o.clearance, "distance to keep from the obstacle, in model units", Range{0.0});
  visit("max_deviation", o.max_deviation,
        "no vertex ends further than this from where it began, in model units", Range{0.0});
}

/// Bi-Laplacian fairing: all inner vertices at once to where the surface bends least, the border
/// and the slant at it kept; again with the Laplacian of the surface found. Defects are not looked
/// at: smooth surfaces have small ones. docs/methods/fairing.md
struct BilaplacianFairing {
  static constexpr std::string_view name = "fairing";
  static constexpr int usual_sweeps = 1;
  static constexpr bool honours_weights = true, honours_obstacle = false;
  double pull = 100.0;
  double min_step = 1e-4;
};

template <class Visit>
void describe(BilaplacianFairing& o, Visit&& visit) {
  visit("pull", o.pull,
        "how strongly vertices are drawn to where they began; waves longer than 2 pi sizes over "
        "the root of this stay, a size being the root of the area; 0: not at all",
        Range{0.0, 1e9});
  visit("min_step", o.min_step,
        "converged when the rms step is below this share of the mean edge length", Range{0.0, 1.0});
}

/// Strain, rms, as a share of length, that nobody can measure on cloth, leather or plate: where
/// `auto` ends if the surface is to stay smooth and no other limit is given.
inline constexpr double k_unmeasurable_strain = 1e-3;

/// What `auto` gives way in last.
enum class Prefer {
  smooth,  ///< no crumples: strain is left where only they would take it out
  flat,    ///< flattenable, as smooth as that allows
  near,    ///< flattenable, or at a limit of strain, and near to the design, though it crumples
};
inline constexpr std::array k_preferences = {std::pair{Prefer::smooth, std::string_view("smooth")},
                                             std::pair{Prefer::flat, std::string_view("flat")},
                                             std::pair{Prefer::near, std::string_view("near")}};
constexpr const auto& names_of(Prefer) {
  return k_preferences;
}

/// The method that finishes the job, from a coarse patch to the one given. Smooth or flat: bending,
/// strain and distance are weighed against one another, and strain is taken out slowly
/// (docs/methods/smooth.md). Near: each level is brought to where it is flattenable by steps that
/// weigh strain against roughness and closeness (docs/methods/auto.md). Flat and near end with
/// polishing for the last defects.
struct Auto {
  static constexpr std::string_view name = "auto";
  static constexpr int usual_sweeps = 1000;
  static constexpr bool honours_weights = true, honours_obstacle = false;
  /// Of a pattern, by an estimate of the surface's strain: StrainLimits::of_form() counts.
  StrainLimits limits = {};
  double max_deviation = std::numeric_limits<double>::infinity();
  double min_angle = 0.0;
  double max_bending = 0.0;
  double closeness = 1.0;
  Prefer prefer = Prefer::smooth;
  BorderFreedom border = {};
};

template <class Visit>
void describe(Auto& o, Visit&& visit) {
  visit("max_strain", o.limits.max,
        "change the form as little as it takes until no edge of a pattern has to stretch by more "
        "than this, as a share of length",
        Range{0.0, 1.0});
  visit("max_rms_strain", o.limits.rms,
        "the same by the root mean square of the strain, which a few positions with more do not "
        "decide",
        Range{0.0, 1.0});
  visit("max_deviation", o.max_deviation,
        "no vertex ends further than this from where it began, in model units", Range{0.0});
  visit("min_angle", o.min_angle,
        "no triangle gets an angle below this, or below the smallest one at first if that is "
        "smaller, in degrees",
        Range{0.0, 60.0});
  visit(
      "max_bending", o.max_bending,
      "with prefer smooth or flat: largest bending, as a multiple of that of the design; a larger "
      "one lets the surface stay nearer; 0: as smooth as usual",
      Range{0.0, 1e6});
  visit("prefer", o.prefer,
        "what counts most: that the surface stays smooth, becomes flattenable, or stays near");
  visit("closeness", o.closeness,
        "how much rougher the surface may get for staying close: 0: no rougher than at first, 1: "
        "twice as rough and 2.5 degrees more",
        Range{0.0, 1e6});
  visit("border", o.border,
        "what vertices of the border may do: stay, slide along the border as it was, or go as far "
        "from where they were as this, in model units");
}

struct SweepInput;  // planish/evolve/own_method.h

/// A method of one's own: a function that makes one sweep. It is evolved, measured and compared as
/// the others are. docs/research.md
struct OwnMethod {
  static constexpr bool honours_weights = false, honours_obstacle = false;
  std::string name = "own";  ///< in reports
  /// Returns where the vertices are after the sweep, one per vertex of the mesh, model units. Those
  /// that may not move stay, whatever it returns for them. A sweep that moves nothing ends the run.
  /// What it throws passes through evolve(). Called from the thread that evolves.
  std::function<std::vector<Vec3>(const SweepInput&)> sweep = {};
  int usual_sweeps = 10;      ///< how many it is given where nobody said
  bool moves_border = false;  ///< whether vertices of the border may move too
};

template <class Visit>
void describe(OwnMethod& /*method*/, Visit&& /*visit*/) {}  // its options are its own

/// A method is a value: its options say which one it is. Each has its struct above, its source file
/// in src/evolve and its page under docs/methods; the struct says
///   name             on the command line and in reports,
///   usual_sweeps     how many sweeps it is given where nobody said,
///   honours_weights, honours_obstacle   see Constraints,
/// and describe(options, visit) describes its options, once, for command line, JSON, bindings and
/// docs: it calls visit(name, member, doc, range) for numbers, visit(name, member, doc) for
/// enumerations and BorderFreedom. OwnMethod, the last, is none of these.
using Method = std::variant<ControllableLaplacian, ClassicalLaplacian, LeastNorm,
                            FlattenableLaplacian, LocalOffset, GlobalPenalty, LocalPerturbation,
                            BilaplacianFairing, Auto, OwnMethod>;

/// How many methods have a name that method_named() knows: the first ones of Method.
inline constexpr std::size_t k_named_methods = std::variant_size_v<Method> - 1;

/// As in "controllable". It lives as long as the method.
std::string_view name_of(const Method& method);

/// The method of that name with its default options.
/// @throws Error unknown_name
Method method_named(std::string_view name);

/// @throws Error option_out_of_range naming the first option out of its range; also for an
/// OwnMethod
///   without a name or a sweep
void check_options(const Method& method);

}  // namespace planish
