#include "text/own_seams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include <planish/mesh/seams.h>

#include "shell/text.h"
#include "text/lengths.h"

namespace planish::cli {

namespace {

struct UnequalSeam {
  Seam seam;
  double first = 0.0, second = 0.0;  ///< lengths in the pattern, model units
  double difference() const { return std::abs(first - second); }
};

std::string ends_text(const SeamSide& side) {
  return std::to_string(side.vertices.front()) + " to " + std::to_string(side.vertices.back());
}

}  // namespace

bool meets_itself(const Patch& patch) {
  std::vector<std::array<double, 3>> places;
  for (const std::vector<Index>& loop : patch.border_loops()) {
    for (const Index v : loop) {
      const Vec3& p = patch.positions()[v];
      places.push_back({p.x, p.y, p.z});
    }
  }
  std::sort(places.begin(), places.end());
  return std::adjacent_find(places.begin(), places.end()) != places.end();
}

void note_unequal_seams(Session& session, const Patch& design, const UnfoldReport& report) {
  if (!meets_itself(design)) return;
  const double least = 0.5 / millimetres_per(report.unit);
  std::vector<UnequalSeam> unequal;
  for (Seam& seam : find_seams(std::span(&design.mesh(), 1))) {
    const double first = length_of(seam.sides[0], report.pattern.positions);
    const double second = length_of(seam.sides[1], report.pattern.positions);
    const double difference = std::abs(first - second);
    if (difference > least && difference > 0.005 * std::max(first, second))
      unequal.push_back({std::move(seam), first, second});
  }
  if (unequal.empty()) return;
  const auto worst = std::max_element(
      unequal.begin(), unequal.end(),
      [](const UnequalSeam& a, const UnequalSeam& b) { return a.difference() < b.difference(); });
  const ShownLengths lengths(report.unit);
  session.note("two stretches of the border meet on the model, but in the pattern they are " +
               lengths.number(worst->first) + " and " + lengths.text(worst->second) +
               " long: from vertex " + ends_text(worst->seam.sides[0]) + " and from " +
               ends_text(worst->seam.sides[1]) +
               (unequal.size() > 1 ? ", the worst of " + counted(unequal.size(), "seam") : "") +
               "; --match-seams makes such stretches equally long");
}

}  // namespace planish::cli
