#pragma once

#include <array>
#include <string_view>
#include <utility>

namespace planish {

/// What the vertices of the border may do while the inner ones move.
struct BorderFreedom {
  enum class Rule {
    fixed,   ///< stay where they are
    slide,   ///< go along the border as it was, not past its corners nor one another
    within,  ///< go anywhere within a distance of where they were
  };
  Rule rule = Rule::fixed;
  double distance = 0.0;  ///< model units; for `within` alone

  bool moves() const { return rule == Rule::slide || (rule == Rule::within && distance > 0.0); }
  friend bool operator==(const BorderFreedom&, const BorderFreedom&) = default;
};

/// Of the rules that have one; `within` is told by its distance.
inline constexpr std::array k_border_freedoms = {
    std::pair{BorderFreedom::Rule::fixed, std::string_view("fixed")},
    std::pair{BorderFreedom::Rule::slide, std::string_view("slide")}};
constexpr const auto& names_of(BorderFreedom::Rule) {
  return k_border_freedoms;
}

}  // namespace planish
