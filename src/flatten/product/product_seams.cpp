#include "flatten/product/product_seams.h"

#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include <planish/mesh/inspect.h>

#include "unfold/strain/free_edges.h"

namespace planish {

namespace {

/// Of two lengths in millimetres the number of the longer one; none where they count as equal.
std::optional<std::size_t> longer_of(double first, double second) {
  constexpr double k_equal = 0.01;
  if (std::abs(first - second) < k_equal) return std::nullopt;
  return first > second ? 0 : 1;
}

}  // namespace

std::optional<double> MeasuredSeam::difference() const {
  if (!in_pattern[0] || !in_pattern[1]) return std::nullopt;
  return std::abs(*in_pattern[0] - *in_pattern[1]);
}

double MeasuredSeam::difference_on_model() const {
  return std::abs(on_model[0] - on_model[1]);
}

std::optional<std::size_t> MeasuredSeam::longer() const {
  if (!in_pattern[0] || !in_pattern[1]) return std::nullopt;
  return longer_of(*in_pattern[0], *in_pattern[1]);
}

std::optional<std::size_t> MeasuredSeam::longer_on_model() const {
  return longer_of(on_model[0], on_model[1]);
}

namespace {

/// Those of some patches that can be measured.
struct SoundPatches {
  std::vector<std::size_t> numbers;
  std::vector<TriMesh> meshes;
};

SoundPatches sound_ones(std::span<const TriMesh> patches, std::span<const std::size_t> some) {
  SoundPatches sound;
  for (const std::size_t p : some) {
    if (blocking_problem(inspect(patches[p]), Purpose::measure)) continue;
    sound.numbers.push_back(p);
    sound.meshes.push_back(patches[p]);
  }
  return sound;
}

std::vector<Seam> seams_among(const SoundPatches& sound, double tolerance) {
  std::vector<Seam> seams = find_seams(sound.meshes, tolerance);
  for (Seam& seam : seams) {
    for (SeamSide& side : seam.sides)
      side.patch = sound.numbers[side.patch];
  }
  return seams;
}

std::vector<NearBorders> near_borders_among(const SoundPatches& sound, double tolerance) {
  std::vector<NearBorders> near =
      find_near_borders(sound.meshes, find_seams(sound.meshes, tolerance));
  for (NearBorders& some : near) {
    for (std::size_t& patch : some.patches)
      patch = sound.numbers[patch];
  }
  return near;
}

/// What a function finds in each group of patches, one after another.
template <class Find>
auto found_in_groups(std::span<const TriMesh> patches, std::span<const std::size_t> groups,
                     Find find) {
  std::map<std::size_t, std::vector<std::size_t>> members;
  for (std::size_t p = 0; p < groups.size(); ++p)
    members[groups[p]].push_back(p);
  decltype(find(SoundPatches{})) all;
  for (const auto& [group, some] : members) {
    auto found = find(sound_ones(patches, some));
    std::move(found.begin(), found.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace

std::vector<Seam> find_sound_seams(std::span<const TriMesh> patches, double tolerance) {
  std::vector<std::size_t> all(patches.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return seams_among(sound_ones(patches, all), tolerance);
}

std::vector<Seam> find_seams_in_groups(std::span<const TriMesh> patches,
                                       std::span<const std::size_t> groups, double tolerance) {
  return found_in_groups(patches, groups, [tolerance](const SoundPatches& sound) {
    return seams_among(sound, tolerance);
  });
}

std::vector<NearBorders> find_near_borders_in_groups(std::span<const TriMesh> patches,
                                                     std::span<const std::size_t> groups,
                                                     double tolerance) {
  return found_in_groups(patches, groups, [tolerance](const SoundPatches& sound) {
    return near_borders_among(sound, tolerance);
  });
}

namespace {

using EdgeEnds = std::array<Index, 2>;

/// A set, so that an edge of several seams is there once.
using EdgeSet = std::set<EdgeEnds>;

std::vector<EdgeSet> edges_along(std::span<const Seam> seams, std::size_t patches) {
  std::vector<EdgeSet> edges(patches);
  for (const Seam& seam : seams) {
    for (const SeamSide& side : seam.sides) {
      for (std::size_t k = 0; k + 1 < side.vertices.size(); ++k)
        edges[side.patch].insert(lower_first(side.vertices[k], side.vertices[k + 1]));
    }
  }
  return edges;
}

EdgeSet renamed(const EdgeSet& edges, std::span<const Index> names) {
  EdgeSet result;
  for (const auto& [v, w] : edges)
    result.insert(lower_first(names[v], names[w]));
  return result;
}

std::vector<Index> inverse_of(std::span<const Index> numbers) {
  std::vector<Index> inverse(numbers.size());
  for (std::size_t v = 0; v < numbers.size(); ++v)
    inverse[numbers[v]] = static_cast<Index>(v);
  return inverse;
}

/// Gives each of several twins the edges of all of them.
void share_among_twins(std::vector<EdgeSet>& edges,
                       std::span<const std::optional<MeshTwin>> twins) {
  for (std::size_t p = 0; p < twins.size(); ++p) {
    if (twins[p]) edges[twins[p]->of].merge(renamed(edges[p], inverse_of(twins[p]->match.vertex)));
  }
  for (std::size_t p = 0; p < twins.size(); ++p) {
    if (twins[p]) edges[p] = renamed(edges[twins[p]->of], twins[p]->match.vertex);
  }
}

}  // namespace

std::vector<SewnBorder> find_sewn_borders(std::span<const Seam> seams,
                                          std::span<const TriMesh> meshes,
                                          std::span<const std::optional<MeshTwin>> twins) {
  std::vector<EdgeSet> sewn = edges_along(seams, meshes.size());
  share_among_twins(sewn, twins);
  std::vector<SewnBorder> borders(meshes.size());
  for (std::size_t p = 0; p < meshes.size(); ++p) {
    if (sewn[p].empty()) continue;
    borders[p].has_seams = true;
    const Patch patch(meshes[p]);
    for (const std::vector<Index>& loop : patch.border_loops()) {
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const EdgeEnds edge = lower_first(loop[k], loop[(k + 1) % loop.size()]);
        if (!sewn[p].contains(edge)) borders[p].free_edges.push_back(edge);
      }
    }
  }
  return borders;
}

std::vector<MeasuredSeam> measure_seams(std::vector<Seam> seams, std::span<const TriMesh> meshes,
                                        std::span<const PatchResult> results, Unit unit) {
  const double scale = millimetres_per(unit);
  std::vector<MeasuredSeam> measured;
  measured.reserve(seams.size());
  for (Seam& seam : seams) {
    MeasuredSeam lengths;
    for (std::size_t s = 0; s < 2; ++s) {
      const SeamSide& side = seam.sides[s];
      const std::vector<Vec3>& positions = meshes[side.patch].positions;
      lengths.on_model[s] = scale * length_of(side, std::span<const Vec3>(positions));
      const auto& finished = results[side.patch].finished;
      if (!finished) continue;
      const std::vector<Vec2>& pattern = finished->unfold.pattern.positions;
      lengths.in_pattern[s] = scale * length_of(side, std::span<const Vec2>(pattern));
    }
    lengths.seam = std::move(seam);
    measured.push_back(std::move(lengths));
  }
  return measured;
}

}  // namespace planish
