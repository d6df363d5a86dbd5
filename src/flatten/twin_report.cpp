#include "flatten/twin_report.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "unfold/strain/free_edges.h"

namespace planish {

namespace {

/// The patch that is worked on, by the other one's.
struct TwinPatch {
  Patch patch;
  std::vector<Index> source;  // as FlattenReport has it
  std::vector<Index> vertex;  // of the other one's patch -> of this one
};

/// Where the other one was remeshed: over the vertices that correspond to what is left there.
TwinPatch remeshed_alike(const FlattenReport& other, const Patch& patch, const MeshMatch& match) {
  TwinPatch alike;
  TriMesh mesh;
  for (const Index v : other.source)
    alike.source.push_back(match.vertex[v]);
  const std::vector<Index> unsorted = alike.source;
  std::sort(alike.source.begin(), alike.source.end());
  for (const Index v : unsorted) {
    const auto found = std::lower_bound(alike.source.begin(), alike.source.end(), v);
    alike.vertex.push_back(static_cast<Index>(found - alike.source.begin()));
  }
  for (const Index v : alike.source)
    mesh.positions.push_back(patch.positions()[v]);
  for (Triangle t : other.input.triangles()) {
    for (Index& v : t)
      v = alike.vertex[v];
    if (match.mirrored) std::swap(t[1], t[2]);
    mesh.triangles.push_back(t);
  }
  alike.patch = Patch(std::move(mesh));
  return alike;
}

TwinPatch worked_on(const FlattenReport& other, const Patch& patch, const MeshMatch& match) {
  return other.source.empty() ? TwinPatch{patch, {}, match.vertex}
                              : remeshed_alike(other, patch, match);
}

bool holds_all(std::span<const Index> source, std::span<const Index> keep) {
  return source.empty() || std::all_of(keep.begin(), keep.end(), [&](Index v) {
           return std::binary_search(source.begin(), source.end(), v);
         });
}

/// Brings what a report has of places and numbers to another mesh.
class Instance {
 public:
  Instance(const TwinPatch& own, const MeshMatch& match)
      : vertex_(own.vertex), motion_(match.motion), mirrored_(match.mirrored) {}

  /// Moves are turned, not places: what did not move stays to the bit, so that borders still lie at
  /// the same places.
  Patch moved(const Patch& patch, std::span<const Vec3> before, std::span<const Vec3> after) const {
    std::vector<Vec3> positions = patch.positions();
    for (std::size_t v = 0; v < vertex_.size(); ++v) {
      if (!(after[v] == before[v]))
        positions[vertex_[v]] += motion_.of_direction(after[v] - before[v]);
    }
    return patch.with_positions(std::move(positions));
  }

  UnfoldReport of(UnfoldReport report) const {
    Pattern& pattern = report.pattern;
    for (std::vector<Vec2>* places :
         {&pattern.positions, &pattern.unmatched_least_stretch, &pattern.least_stretch})
      *places = laid_alike(*places);
    if (pattern.opened) pattern.opened->vertex = vertex_[pattern.opened->vertex];
    if (report.overlap && mirrored_) {
      const Overlap theirs = *report.overlap;
      report.overlap->low.x = 0.0 - theirs.high.x;
      report.overlap->high.x = 0.0 - theirs.low.x;
    }
    report.strain = of(report.strain);
    for (auto* strain : {&report.unmatched_strain, &report.unlimited_strain})
      if (*strain) *strain = of(**strain);
    for (LimitCheck& check : report.limits) {
      check.edge = edge_of(check.edge);
      check.at = motion_(check.at);
    }
    return report;
  }

  EdgeStrain of(EdgeStrain strain) const {
    strain.worst_edge = edge_of(strain.worst_edge);
    return strain;
  }

  /// @param theirs the triangles that the figures are of
  MeasuredPatch of(MeasuredPatch figures, const Patch& patch,
                   std::span<const Triangle> theirs) const {
    figures.inspection = inspect(patch.mesh());
    figures.size.extent = measure_size(patch).extent;
    if (auto& crossing = figures.self_intersections.first) {
      for (Index& t : crossing->triangles)
        t = number_in(patch.triangles(), theirs[t]);
      std::sort(crossing->triangles.begin(), crossing->triangles.end());
      crossing->at = motion_(crossing->at);
    }
    return figures;
  }

  Fairness of(Fairness fairness) const {
    if (auto& fold = fairness.sharpest_fold) {
      const auto [from, to] = edge_of({fold->from, fold->to});
      *fold = Fold{from, to, fold->degrees, motion_(fold->at)};
    }
    if (auto& change = fairness.form_change) {
      change->fold_at = motion_(change->fold_at);
      change->dent_at = motion_(change->dent_at);
    }
    return fairness;
  }

 private:
  std::array<Index, 2> edge_of(std::array<Index, 2> edge) const {
    return lower_first(vertex_[edge[0]], vertex_[edge[1]]);
  }

  std::vector<Vec2> laid_alike(const std::vector<Vec2>& places) const {
    std::vector<Vec2> alike(places.size());
    for (std::size_t v = 0; v < places.size(); ++v)
      alike[vertex_[v]] = mirrored_ ? Vec2{0.0 - places[v].x, places[v].y} : places[v];  // no -0
    return alike;
  }

  Index number_in(std::span<const Triangle> triangles, const Triangle& theirs) const {
    const Triangle corners = {vertex_[theirs[0]], vertex_[theirs[1]], vertex_[theirs[2]]};
    const auto found = std::find_if(triangles.begin(), triangles.end(), [&](const Triangle& t) {
      return std::is_permutation(t.begin(), t.end(), corners.begin());
    });
    return static_cast<Index>(found - triangles.begin());
  }

  const std::vector<Index>& vertex_;
  const RigidMotion& motion_;
  bool mirrored_;
};

}  // namespace

std::optional<FlattenReport> twin_report(const FlattenReport& other, const Patch& patch,
                                         const MeshMatch& match, std::string name,
                                         const FlattenOptions& options) {
  TwinPatch own = worked_on(other, patch, match);
  if (!holds_all(own.source, options.keep)) return std::nullopt;
  if (const auto& smoothed = other.evolve.smoothed_first)
    own.patch = smooth_design(patch, smoothed->length).patch;
  const Instance instance(own, match);
  FlattenReport report = other;
  report.name = std::move(name);
  report.material = options.material;
  report.twin_of = TwinOf{other.name, match.mirrored};
  report.processed =
      instance.moved(own.patch, other.input.positions(), other.processed.positions());
  EvolveReport& evolve = report.evolve;
  evolve.result.positions = report.processed.positions();
  evolve.result.seconds = 0.0;
  evolve.before = instance.of(std::move(evolve.before), own.patch, other.input.triangles());
  evolve.after = instance.of(std::move(evolve.after), report.processed, other.input.triangles());
  evolve.fairness = instance.of(evolve.fairness);
  for (UnfoldReport* unfold :
       {&report.unfold, &report.design_least_stretch, &report.design_pattern})
    *unfold = instance.of(std::move(*unfold));
  if (report.rejected) report.rejected = instance.of(*report.rejected);
  report.input = std::move(own.patch);
  report.source = std::move(own.source);
  return report;
}

std::string twin_text(const TwinOf& twin) {
  return (twin.mirrored ? "mirror image of " : "equal to ") + twin.name;
}

}  // namespace planish
