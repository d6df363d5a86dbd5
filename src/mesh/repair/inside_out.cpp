#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <vector>

#include <planish/mesh/patch.h>
#include <planish/mesh/repair.h>
#include <planish/mesh/seams.h>

#include "mesh/repair/sheets.h"
#include "mesh/turning_sets.h"

namespace planish {

namespace {

// Areas that differ by less are the same.
constexpr double k_same_area = 1e-9;

/// An edge of a border, with the patch on its left.
struct BorderStep {
  std::size_t patch;
  Index from, to;

  auto key() const { return std::tie(patch, from, to); }
  bool operator<(const BorderStep& other) const { return key() < other.key(); }
};

std::vector<BorderStep> border_steps(std::span<const TriMesh> pieces) {
  std::vector<BorderStep> steps;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const Patch patch(pieces[p]);
    for (const auto& loop : patch.border_loops()) {
      for (std::size_t i = 0; i < loop.size(); ++i)
        steps.push_back({p, loop[i], loop[(i + 1) % loop.size()]});
    }
  }
  std::sort(steps.begin(), steps.end());
  return steps;
}

/// Calls visit(step, along) for every edge of the side that is one of the border, with its place in
/// the steps and whether the side runs along the border.
template <class Visit>
void for_each_step(const SeamSide& side, const std::vector<BorderStep>& steps, const Visit& visit) {
  const auto find = [&](Index from, Index to) {
    const BorderStep wanted{side.patch, from, to};
    const auto at = std::lower_bound(steps.begin(), steps.end(), wanted);
    return at != steps.end() && at->key() == wanted.key() ? at : steps.end();
  };
  for (std::size_t i = 0; i + 1 < side.vertices.size(); ++i) {
    const Index a = side.vertices[i], b = side.vertices[i + 1];
    for (const bool along : {true, false}) {
      const auto at = along ? find(a, b) : find(b, a);
      if (at != steps.end()) visit(static_cast<std::size_t>(at - steps.begin()), along);
    }
  }
}

bool runs_along(const SeamSide& side, const std::vector<BorderStep>& steps) {
  long long balance = 0;
  for_each_step(side, steps, [&](std::size_t, bool along) { balance += along ? 1 : -1; });
  return balance > 0;
}

/// Seams of two pieces, without those on curves that more than two borders share: there some two
/// always run the same way.
std::vector<std::size_t> telling_seams(std::span<const Seam> seams,
                                       const std::vector<BorderStep>& steps) {
  std::vector<unsigned char> uses(steps.size(), 0);
  for (const Seam& seam : seams) {
    for (const SeamSide& side : seam.sides) {
      for_each_step(side, steps, [&](std::size_t step, bool) {
        uses[step] = static_cast<unsigned char>(std::min(uses[step] + 1, 2));
      });
    }
  }
  std::vector<std::size_t> telling;
  for (std::size_t s = 0; s < seams.size(); ++s) {
    if (seams[s].sides[0].patch == seams[s].sides[1].patch) continue;
    std::size_t all = 0, shared = 0;
    for (const SeamSide& side : seams[s].sides) {
      for_each_step(side, steps, [&](std::size_t step, bool) {
        ++all;
        shared += uses[step] > 1 ? 1 : 0;
      });
    }
    // Seams that follow each other as curves share the edge between them.
    if (2 * shared <= all) telling.push_back(s);
  }
  return telling;
}

std::vector<double> areas_of(std::span<const TriMesh> pieces) {
  std::vector<double> areas;
  for (const TriMesh& piece : pieces) {
    const std::vector<double> of_triangle = unit_areas(piece);
    const double scale = unit_scale(piece);
    const double sum = std::accumulate(of_triangle.begin(), of_triangle.end(), 0.0);
    areas.push_back(sum / scale / scale);
  }
  return areas;
}

}  // namespace

std::vector<std::size_t> find_inside_out(std::span<const TriMesh> pieces,
                                         std::span<const Seam> seams) {
  const std::vector<BorderStep> steps = border_steps(pieces);
  std::vector<std::size_t> order = telling_seams(seams, steps);
  std::vector<double> lengths(seams.size(), 0.0);
  for (const std::size_t s : order)
    lengths[s] = length_of(seams[s].sides[0], pieces[seams[s].sides[0].patch].positions);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return lengths[a] != lengths[b] ? lengths[a] > lengths[b] : a < b;
  });
  TurningSets sets(pieces.size());
  for (const std::size_t s : order) {
    const auto& [one, other] = seams[s].sides;
    const bool same_way = runs_along(one, steps) == runs_along(other, steps);
    sets.join(static_cast<Index>(one.patch), static_cast<Index>(other.patch), same_way ? 1 : 0);
  }
  const std::vector<double> areas = areas_of(pieces);
  std::vector<std::array<double, 2>> by_way(pieces.size(), {0.0, 0.0});
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const auto first = sets.first_of(static_cast<Index>(p));
    by_way[first.number][first.turned] += areas[p];
  }
  std::vector<std::size_t> inside_out;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const auto first = sets.first_of(static_cast<Index>(p));
    const auto& [kept, turned] = by_way[first.number];
    const bool first_stays = turned <= kept * (1.0 + k_same_area);
    if ((first.turned != 0) == first_stays) inside_out.push_back(p);
  }
  return inside_out;
}

}  // namespace planish
