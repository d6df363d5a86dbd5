#pragma once

#include <array>
#include <limits>
#include <string_view>
#include <utility>

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

}  // namespace planish
