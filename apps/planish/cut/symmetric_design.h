#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <planish/mesh/symmetry.h>

#include "cut/requested_lines.h"
#include "shell/session.h"

namespace planish::cli {

/// --symmetric and --mirror-surface, for verbs that take --cut.
std::vector<Flag> symmetric_flags();

/// Whether the design is to be its own mirror image.
/// @throws UsageError for --mirror-surface without a plane, and beside what has no mirror image
bool asks_for_symmetry(const Arguments& arguments);

/// That in the plane of --symmetric, found where it is auto or not given; model units.
/// @throws Error as find_symmetry(); UsageError
Symmetry requested_symmetry(const Patch& patch, const Arguments& arguments);

/// A design that is to be its own mirror image.
class SymmetricDesign {
 public:
  /// Finds the plane, or looks at the design in that which is named, and tells it.
  /// @param mesh,path,arguments must outlive it
  /// @throws Error as find_symmetry() and require_symmetric(); UsageError
  SymmetricDesign(const TriMesh& mesh, const std::string& path, const Arguments& arguments,
                  Session& session);

  /// Its normal has length 1; model units.
  const Plane& plane() const { return plane_; }

  /// The design itself, or with --mirror-surface the half with more lines, or else more area, and
  /// its mirror image.
  /// @param asked the lines, on the design; on the result from then on, those of its half
  TriMesh surface_for(RequestedLines& asked);

  /// The lines with their mirror images.
  /// @param surface what surface_for() gave
  RequestedLines with_images(RequestedLines asked, const TriMesh& surface) const;

  /// The cut mesh, in which each piece that has a twin on the other side is replaced by the mirror
  /// image of that twin.
  TriMesh with_symmetric_pieces(const TriMesh& cut) const;

 private:
  /// Takes pieces as they were that their mirrored form would leave without a pattern.
  void keep_sound(std::span<const TriMesh> pieces, std::vector<TriMesh>& symmetric) const;
  /// In the coordinates of the file, in which lines are.
  Plane plane_in_file() const;

  const TriMesh& mesh_;
  const std::string& path_;
  const Arguments& arguments_;
  Session& session_;
  Plane plane_;
  MirrorSide side_ = MirrorSide::above;
};

}  // namespace planish::cli
