#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <planish/mesh/seams.h>
#include <planish/pattern/notches.h>

namespace planish {

/// A notch on both sides of a seam.
struct SeamNotch {
  std::optional<std::size_t> seam = {};  ///< counted from 0; none: every seam
  double place = 0.5;                    ///< along the first side of the seam from its first vertex
  bool in_millimetres = false;           ///< the place; else it is a share of the length, 0 to 1
  NotchKind kind = NotchKind::slit;
  bool is_double = false;
};

/// The notches of every patch that those of the seams come to. The two of a pair are at one place
/// of the model: on the same edge at the same share of it. In patterns whose seams match they are
/// at the same length from the end of the seam.
/// @param patches whose seams they are; lengths are measured on them
/// @param names of the patches, for messages
/// @param unit millimetres in a model unit
/// @throws Error misplaced_notch for seams that there are not and places beyond a seam's length
std::vector<std::vector<Notch>> notches_of_patches(std::span<const SeamNotch> notches,
                                                   std::span<const Seam> seams,
                                                   std::span<const TriMesh> patches,
                                                   std::span<const std::string> names, double unit);

}  // namespace planish
