#include "flatten/product/common_lengths.h"

#include <array>
#include <map>
#include <utility>

#include "core/thread_pool.h"
#include "flatten/product/product_seams.h"
#include "mesh/disjoint_sets.h"
#include "unfold/common_length.h"
#include "unfold/strain/free_edges.h"

namespace planish {

namespace {

/// Edges that are to be equally long.
class SewnEdges {
 public:
  explicit SewnEdges(std::size_t patches) : numbers_(patches) {}

  void join(std::size_t p, std::array<Index, 2> edge, std::size_t q, std::array<Index, 2> other) {
    pairs_.push_back({number(p, edge), number(q, other)});
  }

  bool has(std::size_t p) const { return !numbers_[p].empty(); }

  /// Joins the edges of a patch to those at the same places of its twin.
  void add_twin(std::size_t p, std::size_t twin, std::span<const Index> vertex) {
    const std::map<std::array<Index, 2>, Index> own = numbers_[p];
    for (const auto& [edge, number] : own)
      join(p, edge, twin, {vertex[edge[0]], vertex[edge[1]]});
  }

  /// common_length() of each edge that has one.
  /// @param patterns of the patches; those without one are twins, or keep their own lengths
  std::vector<std::vector<EdgeLength>> common_lengths(
      std::span<const SewnPatch> patches, std::span<const std::optional<Pattern>> patterns,
      std::span<const char> is_twin) const {
    DisjointSets<Index> sets(count_);
    for (const auto& [a, b] : pairs_)
      sets.join(a, b);
    struct Sum {
      double length = 0.0;
      int edges = 0;
      bool is_own = false;
    };
    std::vector<Sum> sums(count_);
    const auto sum_of = [&](Index number) -> Sum& { return sums[sets.first_of(number)]; };
    for (std::size_t p = 0; p < numbers_.size(); ++p) {
      for (const auto& [edge, number] : numbers_[p]) {
        Sum& sum = sum_of(number);
        if (!patterns[p]) {
          sum.is_own = sum.is_own || is_twin[p] == 0;
          continue;
        }
        const std::vector<Vec2>& flat = patterns[p]->positions;
        sum.length += norm(flat[edge[1]] - flat[edge[0]]);
        ++sum.edges;
      }
    }
    std::vector<std::vector<EdgeLength>> lengths(numbers_.size());
    for (std::size_t p = 0; p < numbers_.size(); ++p) {
      for (const auto& [edge, number] : numbers_[p]) {
        const Sum& sum = sum_of(number);
        if (sum.is_own || sum.edges == 0) continue;
        const std::vector<Vec3>& design = patches[p].mesh->positions;
        const double own = norm(design[edge[1]] - design[edge[0]]);
        lengths[p].push_back({edge, common_length(sum.length / sum.edges, own)});
      }
    }
    return lengths;
  }

 private:
  Index number(std::size_t p, std::array<Index, 2> edge) {
    const auto [found, is_new] = numbers_[p].try_emplace(lower_first(edge[0], edge[1]), count_);
    if (is_new) ++count_;
    return found->second;
  }

  std::vector<std::map<std::array<Index, 2>, Index>> numbers_;  // by patch
  std::vector<std::array<Index, 2>> pairs_;
  Index count_ = 0;
};

SewnEdges edges_of(std::span<const Seam> seams, std::span<const std::optional<MeshTwin>> twins) {
  SewnEdges edges(twins.size());
  for (const Seam& seam : seams) {
    if (seam.is_curve()) continue;
    const auto& [one, other] = seam.sides;
    for (std::size_t k = 0; k + 1 < one.vertices.size(); ++k) {
      edges.join(one.patch, {one.vertices[k], one.vertices[k + 1]}, other.patch,
                 {other.vertices[k], other.vertices[k + 1]});
    }
  }
  // Edges of a twin become some of the other one, and those of that some of all of its twins.
  for (std::size_t p = 0; p < twins.size(); ++p) {
    if (!twins[p]) continue;
    const std::vector<Index>& vertex = twins[p]->match.vertex;
    std::vector<Index> back(vertex.size());
    for (std::size_t v = 0; v < vertex.size(); ++v)
      back[vertex[v]] = static_cast<Index>(v);
    edges.add_twin(p, twins[p]->of, back);
  }
  for (std::size_t p = 0; p < twins.size(); ++p) {
    if (twins[p]) edges.add_twin(twins[p]->of, p, twins[p]->match.vertex);
  }
  return edges;
}

/// Nothing where there is none within the limits.
std::optional<Pattern> pattern_of(const SewnPatch& patch, UnfoldOptions how,
                                  const Context& context) {
  how.limits = patch.limits;
  try {
    const Patch sound(*patch.mesh);
    Pattern pattern = unfold(sound, how, context);
    if (!patch.limits.kept_by(edge_strain(sound, pattern.positions))) return std::nullopt;
    return pattern;
  } catch (const Error&) {
    return std::nullopt;  // laying it flat says why
  }
}

}  // namespace

bool keeps_lengths(const FlattenOptions& options) {
  return !options.method && !options.remesh && !(options.smooth_first > 0.0);
}

SewnBorder find_own_seams(const Patch& patch, const FlattenOptions& options,
                          const Context& context) {
  if (!keeps_lengths(options)) return {};
  const std::vector<std::optional<MeshTwin>> no_twin(1);
  const std::vector<Seam> seams = find_seams({&patch.mesh(), 1});
  std::vector<SewnBorder> borders = find_sewn_borders(seams, {&patch.mesh(), 1}, no_twin);
  const SewnPatch sewn{&patch.mesh(), options.limits};
  give_common_lengths(seams, {&sewn, 1}, no_twin,
                      {.least_stretch = true, .symmetric_in = options.constraints.symmetric_in},
                      borders, context);
  return borders[0].lengths.empty() ? SewnBorder{} : borders[0];
}

void give_common_lengths(std::span<const Seam> seams, std::span<const SewnPatch> patches,
                         std::span<const std::optional<MeshTwin>> twins, const UnfoldOptions& how,
                         std::vector<SewnBorder>& borders, const Context& context) {
  const SewnEdges edges = edges_of(seams, twins);
  std::vector<std::optional<Pattern>> patterns(patches.size());
  std::vector<char> is_twin(patches.size(), 0);
  for (std::size_t p = 0; p < patches.size(); ++p)
    is_twin[p] = twins[p] ? 1 : 0;
  ThreadPool pool(context);
  pool.for_ranges(patches.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      if (edges.has(p) && !twins[p])
        patterns[p] =
            pattern_of(patches[p], how, {.threads = 1, .is_cancelled = context.is_cancelled});
    }
  });
  pool.stop_if_cancelled();
  std::vector<std::vector<EdgeLength>> lengths = edges.common_lengths(patches, patterns, is_twin);
  for (std::size_t p = 0; p < patches.size(); ++p)
    borders[p].lengths = std::move(lengths[p]);
}

}  // namespace planish
