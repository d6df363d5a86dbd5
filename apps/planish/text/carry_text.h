#pragma once

#include <cstddef>
#include <map>
#include <string>

#include <planish/core/unit.h>

namespace planish::cli {

/// What became of lines and points that were carried from one mesh to another.
struct CarryFigures {
  std::size_t lines = 0, points = 0;            ///< that were written
  double length_from = 0.0, length_to = 0.0;    ///< of the lines, on either mesh; model units
  double outside_length = 0.0;                  ///< of lines that were left out; model units
  std::size_t outside_points = 0;               ///< that were left out
  double farthest = 0.0;                        ///< of drawn points from the mesh; model units
  std::map<std::string, std::size_t> left_out;  ///< kind of element -> how many
};

/// For people: what was written, and what was left out.
std::string carry_text(const CarryFigures& figures, const std::string& from, Unit unit);

/// {"lines", "points", "length_from", "length_to", "outside": {"length", "points"}, "farthest",
/// "left_out", "output"}
std::string carry_json(const CarryFigures& figures, Unit unit, const std::string& output);

}  // namespace planish::cli
