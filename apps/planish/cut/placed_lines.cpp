#include "cut/placed_lines.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include <planish/mesh/geodesic.h>

#include "flags/quantities.h"
#include "flags/scale_flag.h"
#include "shell/failures.h"

namespace planish::cli {

namespace {

[[noreturn]] void refuse(const LineWords& asked, const std::string& message) {
  throw UsageError("--cut " + asked.value + ": " + message);
}

double length_in_file(const LineWords& asked, const std::string& word, const Arguments& arguments) {
  return quantity_value("--cut " + asked.words.front(), word, Quantity::length, {}, arguments) /
         scale_from(arguments);
}

/// "1,2,3" or the number of a vertex.
SurfacePoint place_of(const Patch& patch, const LineWords& asked, const std::string& word,
                      const Arguments& arguments) {
  const std::vector<Field> parts = field_parts(word);
  if (parts.size() == 1) {
    const auto digits = [](char c) { return c >= '0' && c <= '9'; };
    if (!std::all_of(word.begin(), word.end(), digits) || word.size() > 9)
      refuse(asked, word + " is no place: it is x,y,z or the number of a vertex");
    const auto v = static_cast<Index>(std::stoul(word));
    if (v >= patch.vertex_count() || patch.ring(v).empty()) {
      throw Error(ErrorCode::index_out_of_range,
                  "--cut " + asked.value + ": there is no vertex " + word + "; the mesh has " +
                      std::to_string(patch.vertex_count()) + ", counted from 0");
    }
    return line_along_edges(patch, std::span(&v, 1)).front();
  }
  if (parts.size() != 3)
    refuse(asked, word + " is no place: it is x,y,z or the number of a vertex");
  std::array<double, 3> place{};
  for (std::size_t k = 0; k < 3; ++k)
    place[k] = length_in_file(asked, field_text(parts[k]), arguments);
  return nearest_place(patch, {place[0], place[1], place[2]});
}

void check_places(const LineWords& asked, std::size_t least, std::size_t most) {
  const std::size_t count = asked.words.size() - 1;
  if (count >= least && count <= most) return;
  const std::string& kind = asked.words.front();
  refuse(asked, kind == "line"       ? "a line needs two places: \"line 0,0,1 0,2,1\""
                : kind == "straight" ? "a straight line is \"straight 0,0,1 0,2,1\", or with a "
                                       "length behind it"
                                     : "a ring is \"ring 0,0,1\", or with the number of a vertex");
}

}  // namespace

SurfaceLine shortest_line(const Patch& patch, const LineWords& asked, const Arguments& arguments) {
  check_places(asked, 2, 1000);
  SurfaceLine line = {place_of(patch, asked, asked.words[1], arguments)};
  for (std::size_t k = 2; k < asked.words.size(); ++k) {
    const SurfacePoint next = place_of(patch, asked, asked.words[k], arguments);
    const SurfaceLine part = geodesic(patch, line.back(), next).points;
    line.insert(line.end(), part.begin() + 1, part.end());
  }
  return line;
}

SurfaceLine straight_line(const Patch& patch, const LineWords& asked, const Arguments& arguments) {
  check_places(asked, 2, 3);
  const SurfacePoint from = place_of(patch, asked, asked.words[1], arguments),
                     to = place_of(patch, asked, asked.words[2], arguments);
  const Vec3 direction = position_of(to, patch.positions()) - position_of(from, patch.positions());
  const double length =
      asked.words.size() > 3 ? length_in_file(asked, asked.words[3], arguments) : norm(direction);
  return straightest(patch, from, direction, length).points;
}

SurfaceLine ring_line(const Patch& patch, const LineWords& asked, const Arguments& arguments) {
  check_places(asked, 1, 1);
  const auto ring = ring_at(patch, place_of(patch, asked, asked.words[1], arguments));
  if (!ring) {
    throw Error(ErrorCode::misplaced_cut,
                "--cut " + asked.value +
                    ": no ring goes around anything there; give a place on a limb or a neck");
  }
  return ring->points;
}

Plane axis_plane(const std::string& flag, const std::string& kind, const std::string& text,
                 const Arguments& arguments) {
  const auto axis = std::string_view("xyz").find(text.empty() ? '?' : text[0]);
  if (axis == std::string_view::npos || text.size() < 3 || text[1] != '=') {
    throw UsageError(flag + " " + kind + text + ": a plane is \"" + kind + "x=0\", \"" + kind +
                     "y=12mm\" or with z");
  }
  const double offset = quantity_value(kind.empty() ? flag : flag + " plane", text.substr(2),
                                       Quantity::length, {}, arguments);
  constexpr std::array axes = {Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 1.0, 0.0}, Vec3{0.0, 0.0, 1.0}};
  return {axes[axis], offset / scale_from(arguments)};
}

}  // namespace planish::cli
