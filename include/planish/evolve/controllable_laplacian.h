#pragma once

#include <array>
#include <limits>
#include <string_view>
#include <utility>

#include <planish/core/fields.h>

namespace planish {

/// How the step that lowers the ring energy most is looked for.
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
  visit("solver", o.solver, "how the best step is looked for; trust_region is the paper's");
}

}  // namespace planish
