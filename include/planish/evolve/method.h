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
        "smallest step along the Laplacian vector; a value below 0 lets saddles improve",
        Range{-10.0, 0.0});
  visit("lambda_max", o.lambda_max, "largest step along the Laplacian vector", Range{0.0, 10.0});
  visit("min_angle", o.min_angle,
        "with lambda_min below 0: no triangle gets an angle below this, or below its own angle "
        "before the step if that is smaller, in degrees",
        Range{0.0, 60.0});
  visit("max_deviation", o.max_deviation,
        "farthest that a vertex may end from its position in the design, in model units",
        Range{0.0});
  visit("solver", o.solver,
        "how the best step is computed; trust_region is the solver that the paper names");
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
  visit("lambda", o.lambda, "fraction of the Laplacian vector that every vertex moves",
        Range{0.0, 1.0});
  visit("order", o.order, "order in which a sweep moves the vertices");
  visit("max_deviation", o.max_deviation,
        "farthest that a vertex may end from its position in the design, in model units",
        Range{0.0});
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
  visit("update", o.update, "how a step gives new positions, until direct steps begin");
  visit("switch_e_max", o.switch_e_max, "direct steps begin when e_max is below this, in radians",
        Range{0.0});
  visit("switch_after", o.switch_after,
        "direct steps also begin after this number of faired steps, once a faired step gains too "
        "little",
        Range{0.0, 1e9});
  visit("switch_fall", o.switch_fall,
        "a faired step gains too little if e_max falls by less than this, in radians", Range{0.0});
  visit("damping", o.damping,
        "damping of faired steps, relative to the median of the matrix's diagonal; 0 means 3e-6 "
        "for cotangent, 3e-4 for uniform",
        Range{0.0, 1e3});
  visit(
      "border_weight", o.border_weight,
      "weight of the moves of vertices next to the border; 10 keeps the slant of the surface there",
      Range{1e-3, 1e3});
  visit("max_step", o.max_step,
        "largest move of a vertex in a direct step, as a multiple of its shortest edge",
        Range{1e-6, 10.0});
  visit("min_step", o.min_step,
        "converged when the rms step is below this fraction of the mean edge length",
        Range{0.0, 1.0});
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
  double damping = 1e-9;
  int rebase_every = 0;
  double min_step = 1e-5;
};

template <class Visit>
void describe(FlattenableLaplacian& o, Visit&& visit) {
  visit("fairness", o.fairness, "w1, the weight of short and even edges", Range{0.0, 1e6});
  visit("position", o.position, "w2, the weight of staying at the first positions",
        Range{1e-9, 1e6});
  visit("tau", o.tau, "fraction of each step that is taken", Range{1e-3, 1.0});
  visit(
      "damping", o.damping,
      "least softness of the constraints, relative to the matrix; 1e-9 makes them hard, as printed "
      "in the paper; they get softer where e_max would rise",
      Range{1e-12, 1e3});
  visit("rebase_every", o.rebase_every,
        "after this number of steps the present positions become those to stay near; 0: never",
        Range{0.0, 1e9});
  visit("min_step", o.min_step,
        "converged when the rms step is below this fraction of the mean edge length",
        Range{0.0, 1.0});
}

/// Which steps of a local offset count.
enum class OffsetStep {
  guarded,    ///< those that lower the ring energy, shortened until they do
  published,  ///< all, as printed: to the root of the tangent, clamped to the band
};
inline constexpr std::array k_offset_steps = {
    std::pair{OffsetStep::guarded, std::string_view("guarded")},
    std::pair{OffsetStep::published, std::string_view("published")}};
constexpr const auto& names_of(OffsetStep) {
  return k_offset_steps;
}

/// Local offsets after Wang and Tang 2004: always the inner vertex with the largest defect moves,
/// along the normal that it had at first and no further than a band, to make its ring energy
/// small. With guarded steps energy never rises. docs/methods/local_offset.md
struct LocalOffset {
  static constexpr std::string_view name = "local_offset";
  static constexpr int usual_sweeps = 200;
  static constexpr bool honours_weights = false, honours_obstacle = false;
  double band = 0.0;
  double enough = 1e-2;
  int max_updates = 500'000;
  OffsetStep step = OffsetStep::guarded;
  int max_visits = 100;
};

template <class Visit>
void describe(LocalOffset& o, Visit&& visit) {
  visit("band", o.band,
        "farthest that a vertex may end from its position in the design, in model units; 0 means "
        "the mean length of the edges at inner vertices",
        Range{0.0});
  visit("enough", o.enough, "defects of at most this are left as they are, in radians", Range{0.0});
  visit("max_updates", o.max_updates, "largest number of vertices tried, over all sweeps",
        Range{0.0, 1e9});
  visit("step", o.step,
        "which steps count: guarded: those that lower the energy; published: all, as printed, so "
        "that energy may rise");
  visit("max_visits", o.max_visits,
        "with published steps: largest number of visits of a vertex, which ends the printed loop",
        Range{1.0, 1e9});
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
  visit("cg_steps", o.cg_steps, "conjugate-gradient steps before the penalty grows",
        Range{1.0, 1000.0});
  visit("tolerance", o.tolerance,
        "done when a sweep changes the sum of squared defects by at most this fraction of its "
        "first value",
        Range{0.0, 1.0});
  visit("border", o.border,
        "whether border vertices at the same place, as on the two sides of a seam, stay or move "
        "together; all other border vertices stay");
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
  visit("rings", o.rings, "number of rings around a vertex that move together", Range{1.0, 10.0});
  visit("inner_steps", o.inner_steps, "steps for each visit of a vertex", Range{1.0, 1000.0});
  visit("tau", o.tau, "fraction of each step that is taken", Range{0.0, 1.0});
  visit("enough", o.enough, "done when e_max is at most this, in radians", Range{0.0});
  visit("clearance", o.clearance, "distance to keep from the obstacle, in model units", Range{0.0});
  visit("max_deviation", o.max_deviation,
        "farthest that a vertex may end from its position in the design, in model units",
        Range{0.0});
}

/// What a sweep of fairing is: a solve, or a step of a flow.
enum class FairingFlow {
  none,         ///< to where the surface bends least, at once
  taubin,       ///< the filter of Taubin 1995: a step along the umbrella vector and one against it
  implicit,     ///< mean curvature flow, an implicit step (Desbrun and others 1999)
  anisotropic,  ///< the same slower across creases (Clarenz, Diewald and Rumpf 2000)
};
inline constexpr std::array k_fairing_flows = {
    std::pair{FairingFlow::none, std::string_view("none")},
    std::pair{FairingFlow::taubin, std::string_view("taubin")},
    std::pair{FairingFlow::implicit, std::string_view("implicit")},
    std::pair{FairingFlow::anisotropic, std::string_view("anisotropic")}};
constexpr const auto& names_of(FairingFlow) {
  return k_fairing_flows;
}

/// Fairing: bi-Laplacian, all inner vertices at once to where the surface bends least, the border
/// and the slant at it kept; again with the Laplacian of the surface found. Or a step of a flow.
/// Defects are not looked at: smooth surfaces have small ones. docs/methods/fairing.md
struct BilaplacianFairing {
  static constexpr std::string_view name = "fairing";
  static constexpr int usual_sweeps = 1;
  static constexpr bool honours_weights = true, honours_obstacle = false;
  double pull = 100.0;
  double min_step = 1e-4;
  FairingFlow flow = FairingFlow::none;
  double lambda = 0.33;
  double mu = -0.34;
  double crease = 20.0;
};

template <class Visit>
void describe(BilaplacianFairing& o, Visit&& visit) {
  visit("pull", o.pull,
        "how strongly vertices are pulled to their first positions; waves longer than 2 pi "
        "sqrt(area / pull) stay, shorter ones go; 0: no pull",
        Range{0.0, 1e9});
  visit("min_step", o.min_step,
        "converged when the rms step is below this fraction of the mean edge length",
        Range{0.0, 1.0});
  visit("flow", o.flow,
        "what a sweep does: none: one solve for the surface that bends least; else one step of a "
        "flow");
  visit("lambda", o.lambda,
        "with flow taubin: fraction of the umbrella vector in the smoothing step", Range{0.0, 1.0});
  visit("mu", o.mu, "with flow taubin: fraction of the umbrella vector in the step back, below 0",
        Range{-1.0, 0.0});
  visit(
      "crease", o.crease,
      "with flow anisotropic: a crease is where normals turn by more than this along a mean edge, "
      "in degrees",
      Range{0.1, 180.0});
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
        "largest strain that an edge of the pattern may have, as a fraction of its length; the "
        "form changes only as much as this needs",
        Range{0.0, 1.0});
  visit("max_rms_strain", o.limits.rms,
        "largest root mean square of the strain, as a fraction of length; a few places with more "
        "strain do not decide it",
        Range{0.0, 1.0});
  visit("max_deviation", o.max_deviation,
        "farthest that a vertex may end from its position in the design, in model units",
        Range{0.0});
  visit("min_angle", o.min_angle,
        "no triangle gets an angle below this, or below the smallest angle of the design if that "
        "is smaller, in degrees",
        Range{0.0, 60.0});
  visit("max_bending", o.max_bending,
        "with prefer smooth or flat: largest bending, as a multiple of the design's; a larger "
        "value keeps the surface nearer to the design; 0: as smooth as usual",
        Range{0.0, 1e6});
  visit("prefer", o.prefer,
        "what matters most: a smooth surface, a flattenable surface, or a surface near to the "
        "design");
  visit("closeness", o.closeness,
        "how much roughness to accept for a surface nearer to the design; 0: no rougher than the "
        "design, 1: twice as rough and 2.5 degrees more",
        Range{0.0, 1e6});
  visit("border", o.border,
        "what border vertices may do: stay, slide along the border of the design, or move by at "
        "most a distance in model units");
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
  int usual_sweeps = 10;      ///< default of Stopping::max_sweeps
  bool moves_border = false;  ///< whether vertices of the border may move too
};

template <class Visit>
void describe(OwnMethod& /*method*/, Visit&& /*visit*/) {}  // its options are its own

/// A method is a value: its options say which one it is. Each has its struct above, its source file
/// in src/evolve and its page under docs/methods; the struct says
///   name             on the command line and in reports,
///   usual_sweeps     default number of sweeps,
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
