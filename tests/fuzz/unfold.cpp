// Unfolding any disk, also with borders that keep their lengths, and within limits.

#include <algorithm>
#include <cmath>

#include <planish/unfold/strain.h>
#include <planish/unfold/unfold.h>

#include "fuzz/bytes_to_patch.h"
#include "fuzz/check.h"

using namespace planish;

namespace {

void check_box(const Pattern& pattern) {
  Vec2 high{};
  for (const Vec2 p : pattern.positions) {
    fuzz::check(fuzz::is_finite(p), "patterns are finite");
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    fuzz::check(p.x >= 0.0 && p.y >= 0.0, "patterns begin at the origin");
  }
  fuzz::check(high.x <= pattern.width * (1.0 + 1e-12) && high.y <= pattern.height * (1.0 + 1e-12),
              "patterns are inside of their box");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  UnfoldOptions options{.max_iterations = static_cast<int>(bytes.whole(0, 60)),
                        .match_seams = bytes.flag()};
  const auto mesh = fuzz::patch_from(bytes, Purpose::unfold);
  if (!mesh) return 0;
  const double limit = 0.3 * std::abs(bytes.fraction());
  (bytes.flag() ? options.limits.max : options.limits.p99) = limit;
  const Patch surface(*mesh);
  fuzz::allow_refusal([&] {
    Pattern pattern;
    try {
      pattern = unfold(surface, options);
    } catch (const Error& error) {
      fuzz::check(error.code() == ErrorCode::unfold_failed, "a sound patch can but fail to unfold");
      throw;
    }
    check_box(pattern);
    if (fuzz::has_edges_below(1e-6, *mesh)) return;
    const EdgeStrain strain = edge_strain(surface, pattern.positions);
    fuzz::check(std::isfinite(strain.max) && std::isfinite(strain.rms), "strain is finite");
    if (!pattern.least_stretch.empty()) {
      const EdgeStrain least = edge_strain(surface, pattern.least_stretch);
      const bool is_less = options.limits.max > 0.0 ? strain.max < least.max * (1.0 + 1e-9)
                                                    : strain.p99 < least.p99 * (1.0 + 1e-9);
      fuzz::check(is_less, "a limit that changes a pattern makes its strain less");
      fuzz::check(pattern.flipped_triangles == 0, "limits flip no triangle");
    }
    if (options.match_seams) {
      fuzz::check(largest_border_strain(surface, pattern.positions) <= 1e-9,
                  "matched borders keep their lengths");
    }
  });
  return 0;
}
