#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <planish/core/vec.h>

#include "product/job.h"
#include "product/twins.h"

namespace planish::cli {

/// What became of a patch. Without failure and files it was cancelled.
struct FlattenedPatch {
  std::optional<Failure> failure;
  std::optional<PatchFiles> files;
  TriMesh mesh;               ///< as it was processed
  std::vector<Vec2> pattern;  ///< of that, model units
  bool is_twin = false;       ///< made from what was made of another one
};

/// Flattens patches on threads, the largest first, and hands each to `on_done` on the calling
/// thread as it is finished, by its number. Twins get what was made of the other one, where that is
/// among the patches and does not fail.
/// @param numbers of the patches to be flattened
/// @param on_done false cancels the rest, which is handed on too
void flatten_patches(const ProductJob& job, const ProductTwins& twins,
                     std::vector<std::size_t> numbers, unsigned threads,
                     const std::function<bool()>& interrupted,
                     const std::function<bool(std::size_t, FlattenedPatch)>& on_done);

}  // namespace planish::cli
