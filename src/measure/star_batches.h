#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <planish/core/vec.h>

#include "measure/simd/star_defects.h"

namespace planish {

/// Takes stars one by one and computes their defects several at a time, those of one valence
/// together: calls on_defect(center, defect) for each, in an order of its own.
template <class OnDefect>
class StarBatches {
 public:
  StarBatches(const Site* sites, OnDefect on_defect)
      : sites_(sites), on_defect_(std::move(on_defect)), batches_(k_valences) {}

  void add(Index center, std::span<const Index> ring) {
    const std::size_t valence = ring.size();
    Batch& batch = batches_[std::min(valence, k_valences - 1)];
    batch.stars[batch.count++] = {ring.data(), center};
    // The last batch is for all the valences above; they are rare.
    if (batch.count == batch.stars.size() || valence >= k_valences - 1) flush(batch, valence);
  }

  /// Computes what is left.
  void finish() {
    for (std::size_t valence = 0; valence < k_valences; ++valence)
      flush(batches_[valence], valence);
  }

 private:
  static constexpr std::size_t k_valences = 16, k_stars = 32;
  struct Batch {
    std::array<Star, k_stars> stars;
    std::size_t count = 0;
  };

  void flush(Batch& batch, std::size_t valence) {
    std::array<double, k_stars> defects;
    star_defects_(sites_, batch.stars.data(), batch.count, valence, defects.data());
    for (std::size_t i = 0; i < batch.count; ++i)
      on_defect_(batch.stars[i].center, defects[i]);
    batch.count = 0;
  }

  const Site* sites_;
  OnDefect on_defect_;
  StarDefects star_defects_ = star_defects_for(best_isa());
  std::vector<Batch> batches_;
};

}  // namespace planish
