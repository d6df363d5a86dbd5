#pragma once

#include <span>

#include <planish/mesh/tri_mesh.h>

#include "draw/image.h"
#include "report/pictures/view.h"

namespace planish {

/// Draws surfaces with the triangles of one mesh alike: seen from one place, at one scale, in
/// pictures of one size with a clear ground.
class PatchView {
 public:
  /// The view is that of view_of() for the mesh itself.
  /// @param mesh is kept by reference
  /// @param others more positions of its vertices that must be in the picture
  /// @param width of the pictures, pixels
  PatchView(const TriMesh& mesh, std::span<const std::span<const Vec3>> others, int width);

  /// The same from where somebody else says.
  PatchView(const TriMesh& mesh, std::span<const std::span<const Vec3>> others, int width,
            const View& view);

  /// @param positions, colors one per vertex of the mesh
  Image picture(std::span<const Vec3> positions, std::span<const Color> colors) const;

  /// The surface alone, in a light grey.
  Image shaded(std::span<const Vec3> positions) const;

  /// The mesh itself with a colour for every vertex, and all that is nearer to this vertex than to
  /// the other corners of its triangles in that colour: for colours that stand for kinds, where
  /// none between two of them has a meaning. Large meshes are drawn as picture() does, as their
  /// triangles are too small to tell.
  Image picture_of_kinds(std::span<const Color> colors) const;

 private:
  std::vector<Vec3> projected(std::span<const Vec3> positions) const;
  std::vector<double> brightness_of(std::span<const Vec3> positions) const;

  const TriMesh& mesh_;
  View view_;
  double scale_ = 1.0;  // pixels per model unit
  Vec2 middle_;         // of what is seen, along right and up
  int width_, height_;
};

}  // namespace planish
