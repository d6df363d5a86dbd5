#include <utility>

#include <planish/flatten/strain_as_designed.h>

namespace planish {

namespace {

/// Counts steps over several runs, and remembers that one of them was to end.
class Steps {
 public:
  explicit Steps(const OnUnfoldStep& on_step) : on_step_(on_step) {}

  OnUnfoldStep counted() {
    return [this](int, double energy) {
      cancelled_ = on_step_ && !on_step_(++steps_, energy);
      return !cancelled_;
    };
  }
  bool cancelled() const { return cancelled_; }

 private:
  const OnUnfoldStep& on_step_;
  int steps_ = 0;
  bool cancelled_ = false;
};

}  // namespace

std::optional<StrainAsDesigned> strain_as_designed(const TriMesh& mesh, const StrainLimits& limits,
                                                   unsigned threads, const OnUnfoldStep& on_step) {
  const Connectivity connectivity(mesh);
  Steps steps(on_step);
  const Pattern least = unfold(mesh, connectivity, {.threads = threads}, steps.counted());
  if (steps.cancelled()) return std::nullopt;
  StrainAsDesigned strain = {edge_strain(mesh, connectivity, least.positions)};
  if (limits.any()) {
    const Pattern limited =
        unfold(mesh, connectivity, {.threads = threads, .limits = limits}, steps.counted());
    if (steps.cancelled()) return std::nullopt;
    strain.limits = check_limits(mesh, connectivity, limited.positions, limits);
  }
  if (mesh.positions.size() > StrainAsDesigned::k_most_searched) return strain;
  strain.smallest_limit = smallest_limit(mesh, connectivity, least, threads, steps.counted());
  if (steps.cancelled()) return std::nullopt;
  return strain;
}

}  // namespace planish
