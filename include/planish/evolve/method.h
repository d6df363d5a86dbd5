#pragma once

#include <array>
#include <limits>
#include <string_view>
#include <utility>
#include <variant>

#include <planish/core/fields.h>

namespace planish {

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
  double lambda = 0.5;
  SweepOrder order = SweepOrder::sequential;
  double max_deviation = std::numeric_limits<double>::infinity();
};

/// Controllable Laplacian evolution: every inner vertex takes the step along its Laplacian vector
/// that lowers the ring energy most, and none where none lowers it (Eq. 11-17, corrected). Energy
/// never rises. docs/methods/controllable.md
struct ControllableLaplacian {
  static constexpr std::string_view name = "controllable";
  double lambda_min = 0.0;
  double lambda_max = 1.0;
  double min_angle = 1.0;
  double max_deviation = std::numeric_limits<double>::infinity();
};

/// A method is a value: its options say which one it is.
using Method = std::variant<ControllableLaplacian, ClassicalLaplacian>;

/// Describes the options of a method, once, for command line, JSON, bindings and docs: calls
/// visit(name, member, doc, range) for numbers and visit(name, member, doc) for enumerations.
template <class Visit>
void describe(ClassicalLaplacian& o, Visit&& visit) {
  visit("lambda", o.lambda, "share of the Laplacian vector that every vertex moves",
        Range{0.0, 1.0});
  visit("order", o.order, "order of the moves in a sweep");
  visit("max_deviation", o.max_deviation,
        "no vertex ends further than this from where it began, in model units", Range{0.0});
}
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
}

/// "controllable" or "classical".
std::string_view name_of(const Method& method);

/// The method of that name with its default options.
/// @throws Error unknown_name
Method method_named(std::string_view name);

/// @throws Error option_out_of_range naming the first option out of its range
void check_options(const Method& method);

}  // namespace planish
