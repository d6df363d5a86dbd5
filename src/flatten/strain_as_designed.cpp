#include <utility>

#include <planish/flatten/flatten.h>

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

std::optional<StrainAsDesigned> strain_as_designed(const Patch& patch, const StrainLimits& limits,
                                                   unsigned threads, const OnUnfoldStep& on_step) {
  Steps steps(on_step);
  const Pattern least = unfold(patch, {.threads = threads}, steps.counted());
  if (steps.cancelled()) return std::nullopt;
  StrainAsDesigned strain = {edge_strain(patch, least.positions)};
  if (limits.any()) {
    const Pattern limited = unfold(patch, {.threads = threads, .limits = limits}, steps.counted());
    if (steps.cancelled()) return std::nullopt;
    strain.limits = check_limits(patch, limited.positions, limits);
  }
  if (patch.vertex_count() > StrainAsDesigned::k_most_searched) return strain;
  strain.smallest_limit = smallest_limit(patch, least, threads, steps.counted());
  if (steps.cancelled()) return std::nullopt;
  return strain;
}

}  // namespace planish
