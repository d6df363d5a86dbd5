#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>

#include <planish/core/error.h>
#include <planish/pattern/notches.h>

#include "core/number_text.h"

namespace planish {

namespace {

/// A place on a seam by the number of its edge.
struct EdgeOfSeam {
  std::size_t edge = 0;
  double share = 0.0;
};

EdgeOfSeam edge_at(const SeamSide& side, std::span<const Vec3> positions, double way) {
  const auto length_of_edge = [&](std::size_t k) {
    return norm(positions[side.vertices[k + 1]] - positions[side.vertices[k]]);
  };
  way += side.first_share * length_of_edge(0);
  for (std::size_t k = 0; k + 2 < side.vertices.size(); ++k) {
    const double length = length_of_edge(k);
    if (way < length) return {k, way / length};
    way -= length;
  }
  const std::size_t last = side.vertices.size() - 2;
  return {last, std::clamp(way / length_of_edge(last), 0.0, side.last_share)};
}

Notch notch_at(const SeamNotch& notch, const SeamSide& side, const EdgeOfSeam& at) {
  return Notch::on_edge(side.vertices[at.edge], side.vertices[at.edge + 1], at.share, notch.kind,
                        notch.is_double);
}

/// On both sides of a seam.
/// @param way along the first side, model units
std::array<Notch, 2> notches_at(const SeamNotch& notch, const Seam& seam, double way,
                                std::span<const TriMesh> patches) {
  const auto& [first, second] = seam.sides;
  const std::span<const Vec3> positions = patches[first.patch].positions;
  const EdgeOfSeam at = edge_at(first, positions, way);
  if (!seam.is_curve()) return {notch_at(notch, first, at), notch_at(notch, second, at)};
  const std::span<const Vec3> others = patches[second.patch].positions;
  const double share = matched_share(seam, way / length_of(first, positions));
  const EdgeOfSeam beside = edge_at(second, others, share * length_of(second, others));
  return {notch_at(notch, first, at), notch_at(notch, second, beside)};
}

std::string name_of(std::size_t number, const Seam& seam, std::span<const std::string> names) {
  return "seam " + std::to_string(number + 1) + " of \"" + names[seam.sides[0].patch] +
         "\" and \"" + names[seam.sides[1].patch] + "\"";
}

/// In millimetres along the first side. @throws Error misplaced_notch
double way_of(const SeamNotch& notch, double length, const std::string& seam) {
  const double way = notch.in_millimetres ? notch.place : notch.place * length;
  // What is said to be the length may have been rounded.
  if (way >= 0.0 && way <= length + 0.001) return way;
  throw Error(ErrorCode::misplaced_notch,
              "the notch at " +
                  (notch.in_millimetres ? fixed_text(notch.place, 3) + " mm"
                                        : fixed_text(100.0 * notch.place, 3) + " %") +
                  " is beyond " + seam + ", which is " + fixed_text(length, 3) + " mm long");
}

void check_seam(const SeamNotch& notch, std::size_t seam_count) {
  if (!notch.seam || *notch.seam < seam_count) return;
  const std::string last = std::to_string(seam_count);
  throw Error(ErrorCode::misplaced_notch,
              "there is no seam " + std::to_string(*notch.seam + 1) + " for a notch: " +
                  (seam_count == 0 ? "no two borders run along each other"
                                   : "seams are numbered from 1 to " + last));
}

/// The place of a side that is nearest to a point.
struct PlaceOnSide {
  double distance = std::numeric_limits<double>::infinity();
  double share = 0.0;      ///< of the side's length
  double mean_edge = 0.0;  ///< of the side
};

PlaceOnSide nearest_on(const SeamSide& side, std::span<const Vec3> positions, Vec3 point) {
  const std::vector<Vec3> line = line_of(side, positions);
  PlaceOnSide best;
  double before = 0.0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Vec3 edge = line[k + 1] - line[k];
    const double square = dot(edge, edge);
    const double along =
        square > 0.0 ? std::clamp(dot(point - line[k], edge) / square, 0.0, 1.0) : 0.0;
    const double distance = norm(line[k] + along * edge - point);
    if (distance < best.distance) best = {distance, before + along * norm(edge)};
    before += norm(edge);
  }
  best.share = before > 0.0 ? best.share / before : 0.0;
  best.mean_edge = before / static_cast<double>(line.size() - 1);
  return best;
}

}  // namespace

std::vector<SeamNotch> seam_notches_at(std::span<const Vec3> places, std::span<const Seam> seams,
                                       std::span<const TriMesh> patches) {
  constexpr double k_reach = 3.0;  // mean edges
  std::vector<SeamNotch> notches;
  for (std::size_t k = 0; k < places.size(); ++k) {
    PlaceOnSide best;
    SeamNotch notch;
    for (std::size_t s = 0; s < seams.size(); ++s) {
      const SeamSide& first = seams[s].sides[0];
      const PlaceOnSide near = nearest_on(first, patches[first.patch].positions, places[k]);
      if (!(near.distance < best.distance)) continue;
      best = near;
      notch.seam = s;
      notch.place = near.share;
    }
    if (!notch.seam || best.distance > k_reach * best.mean_edge) {
      throw Error(ErrorCode::misplaced_notch,
                  "notch " + std::to_string(k + 1) + " is on no seam: " +
                      (notch.seam ? fixed_text(best.distance, 3) + " from the nearest one"
                                  : "no two borders run along each other"),
                  {.path = {}, .first = k});
    }
    notches.push_back(notch);
  }
  return notches;
}

std::vector<std::vector<Notch>> notches_of_patches(std::span<const SeamNotch> notches,
                                                   std::span<const Seam> seams,
                                                   std::span<const TriMesh> patches,
                                                   std::span<const std::string> names,
                                                   double unit) {
  std::vector<std::vector<Notch>> result(patches.size());
  for (const SeamNotch& notch : notches) {
    check_seam(notch, seams.size());
    for (std::size_t s = 0; s < seams.size(); ++s) {
      if (notch.seam && *notch.seam != s) continue;
      const SeamSide& first = seams[s].sides[0];
      const std::span<const Vec3> positions = patches[first.patch].positions;
      const double length = unit * length_of(first, positions);
      const double way = way_of(notch, length, name_of(s, seams[s], names));
      const std::array<Notch, 2> both = notches_at(notch, seams[s], way / unit, patches);
      for (std::size_t side = 0; side < 2; ++side)
        result[seams[s].sides[side].patch].push_back(both[side]);
    }
  }
  return result;
}

}  // namespace planish
