#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include <planish/mesh/carry.h>

#include "core/math.h"

namespace planish {

namespace {

struct ByCoordinates {
  bool operator()(Vec3 a, Vec3 b) const {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  }
};

/// The lines that end in each point.
using Ends = std::map<Vec3, std::vector<std::size_t>, ByCoordinates>;

double angle_between_chords(Vec3 u, Vec3 v) {
  return math::atan2(norm(cross(u, v)), dot(u, v));
}

/// Points that smoothing leaves: ends and corners.
std::vector<unsigned char> held_points(const std::vector<Vec3>& points) {
  constexpr double corner = 60.0 * 0.017453292519943295;
  constexpr std::size_t reach = 2;
  std::vector<unsigned char> held(points.size(), 0);
  held.front() = held.back() = 1;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const std::size_t before = i - std::min(i, reach),
                      after = std::min(points.size() - 1, i + reach);
    if (angle_between_chords(points[i] - points[before], points[after] - points[i]) > corner)
      held[i] = 1;
  }
  return held;
}

}  // namespace

std::vector<DrawnLine> chained_lines(std::vector<DrawnLine> lines) {
  Ends ends;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    ends[lines[l].points.front()].push_back(l);
    ends[lines[l].points.back()].push_back(l);
  }
  std::vector<DrawnLine> chains;
  std::vector<unsigned char> used(lines.size(), 0);
  const auto extend = [&](std::vector<Vec3>& points) {
    for (;;) {
      const std::vector<std::size_t>& here = ends.at(points.back());
      if (here.size() != 2) return;
      const std::size_t next = used[here[0]] == 0 ? here[0] : here[1];
      if (used[next] != 0) return;
      used[next] = 1;
      std::vector<Vec3> more = lines[next].points;
      if (!(more.front() == points.back())) std::reverse(more.begin(), more.end());
      points.insert(points.end(), more.begin() + 1, more.end());
    }
  };
  for (std::size_t l = 0; l < lines.size(); ++l) {
    if (used[l] != 0) continue;
    used[l] = 1;
    DrawnLine chain = lines[l];
    extend(chain.points);
    std::reverse(chain.points.begin(), chain.points.end());
    extend(chain.points);
    std::reverse(chain.points.begin(), chain.points.end());
    chains.push_back(std::move(chain));
  }
  return chains;
}

DrawnLine smoothed_line(DrawnLine line, double tolerance) {
  constexpr int rounds = 30;
  constexpr double forth = 0.5, back = -0.53;  // Taubin's lambda and mu
  const std::vector<Vec3> drawn = line.points;
  if (drawn.size() < 3 || !(tolerance > 0.0)) return line;
  const std::vector<unsigned char> held = held_points(drawn);
  for (int round = 0; round < 2 * rounds; ++round) {
    std::vector<Vec3> moved = line.points;
    for (std::size_t i = 1; i + 1 < moved.size(); ++i) {
      if (held[i] != 0) continue;
      const Vec3 mean = 0.5 * (line.points[i - 1] + line.points[i + 1]);
      moved[i] += (round % 2 == 0 ? forth : back) * (mean - line.points[i]);
      const Vec3 away = moved[i] - drawn[i];
      const double apart = norm(away);
      if (apart > tolerance) moved[i] = drawn[i] + (tolerance / apart) * away;
    }
    line.points = std::move(moved);
  }
  return line;
}

}  // namespace planish
