#include "unfold/open_border.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/crosses_itself.h"

namespace planish {

namespace {

constexpr std::size_t k_most_crossings = 100;
constexpr int k_most_opening_rounds = 500;
/// What is left between the sides, as a share of the largest move.
constexpr double k_gap = 0.01;

/// A border vertex that lies behind a side of the border, in the disk.
struct Contact {
  std::size_t vertex = 0, begin = 0, end = 0;  ///< of the outline
  double depth = 0.0;                          ///< of the vertex behind the line of the side
  double share = 0.0;                          ///< of the side's end at the vertex's foot
  Vec2 outward;                                ///< of the side, of length 1
};

Contact contact(std::span<const Vec2> line, std::size_t vertex, std::size_t begin,
                std::size_t end) {
  const Vec2 side = line[end] - line[begin], place = line[vertex] - line[begin];
  const double length = norm(side);
  const Vec2 along = (1.0 / length) * side;
  return {vertex,
          begin,
          end,
          cross(along, place),
          std::clamp(dot(along, place) / length, 0.0, 1.0),
          {along.y, -along.x}};
}

/// Of two sides that cross, one end of each lies behind the other: the one that is less deep.
Contact shallow_contact(std::span<const Vec2> line, const LoopOrder& loops, std::size_t p,
                        std::size_t q) {
  const std::size_t p_end = loops.next(p), q_end = loops.next(q);
  const std::array<Contact, 4> contacts = {
      contact(line, p, q, q_end), contact(line, p_end, q, q_end), contact(line, q, p, p_end),
      contact(line, q_end, p, p_end)};
  return *std::min_element(
      contacts.begin(), contacts.end(), [](const Contact& a, const Contact& b) {
        return std::pair(a.depth <= 0.0, a.depth) < std::pair(b.depth <= 0.0, b.depth);
      });
}

/// The least moves of the vertex and of the ends of the side that leave a gap between them.
void resolve(const Contact& c, double gap, std::vector<Vec2>& line) {
  const double weight = 1.0 + c.share * c.share + (1.0 - c.share) * (1.0 - c.share);
  const Vec2 move = ((c.depth + gap) / weight) * c.outward;
  line[c.vertex] = line[c.vertex] + move;
  line[c.begin] = line[c.begin] - (1.0 - c.share) * move;
  line[c.end] = line[c.end] - c.share * move;
}

/// The outline without crossings; empty where vertices would have to move by more than `most`.
std::vector<Vec2> opened(std::vector<Vec2> line, const LoopOrder& loops, double most) {
  const std::vector<Vec2> before = line;
  for (int round = 0; round < k_most_opening_rounds; ++round) {
    const auto crossings = crossing_sides(line, loops, k_most_crossings + 1);
    if (crossings.empty()) return line;
    if (crossings.size() > k_most_crossings) return {};
    for (const auto& [p, q] : crossings) {
      const Contact shallow = shallow_contact(line, loops, p, q);
      if (!(shallow.depth <= 2.0 * most)) return {};
      resolve(shallow, k_gap * most, line);
      for (const std::size_t k : {shallow.vertex, shallow.begin, shallow.end}) {
        if (!(norm(line[k] - before[k]) <= most)) return {};
      }
    }
  }
  return {};
}

}  // namespace

std::optional<OpenBorder> open_border(const Disk& disk, std::span<const Vec2> flat, double most) {
  const std::vector<Vec2> outline = border_of(disk, flat);
  const std::vector<Vec2> apart = opened(outline, disk.loops, most);
  if (apart.empty()) return std::nullopt;
  OpenBorder result{{flat.begin(), flat.end()},
                    crossing_sides(outline, disk.loops, k_most_crossings).size(),
                    0.0,
                    disk.border.front()};
  for (std::size_t k = 0; k < apart.size(); ++k) {
    const Index v = disk.border[k];
    result.flat[v] = apart[k];
    const double move = norm(apart[k] - outline[k]);
    if (move > result.largest_move) {
      result.largest_move = move;
      result.vertex = v;
    }
  }
  if (!all_upright(disk, result.flat)) return std::nullopt;
  return result;
}

}  // namespace planish
