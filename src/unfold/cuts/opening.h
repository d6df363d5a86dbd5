#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <planish/core/context.h>
#include <planish/mesh/patch.h>

#include "unfold/cuts/essential_path.h"
#include "unfold/cuts/reduced_paths.h"

namespace planish {

/// A mesh of one part that is cut open step by step.
class Opening {
 public:
  /// In `source`: no vertex, where a line made a new one.
  static constexpr Index none = static_cast<Index>(-1);

  /// @param weights of vertices, by which lengths near them count; empty: 1 everywhere
  /// @param keep_holes border loops that close in the plane are not cut open
  /// @param along_edges cuts follow edges; else they are drawn tight through triangles
  Opening(TriMesh mesh, std::vector<double> weights, bool keep_holes, bool along_edges);

  const Patch& patch() const { return patch_; }
  const std::vector<Index>& source() const { return source_; }
  const std::vector<Index>& triangle_of() const { return triangle_of_; }
  const std::vector<double>& weights() const { return weights_; }
  /// What was cut, by vertices of the mesh as it was then made; with along_edges by those of the
  /// mesh as it came.
  const Chains& paths() const { return paths_; }
  /// The edges of the border that were there before any cut.
  std::vector<std::array<Index, 2>> old_border() const;
  std::size_t edges() const { return edges_; }
  double length() const { return length_; }

  /// Cuts along creases, as crease_cuts() says; that may divide the mesh.
  void cut_creases(double least_hinge);
  /// Cuts until the mesh has no handle, and one border loop besides holes; a closed one is left
  /// as it is where it has no handle.
  void open_handles(const Context& context);
  /// Cuts along a path of edges, drawn tight. Parts of it that would divide the mesh are not cut.
  void cut_along(const std::vector<Index>& path, const Context& context);
  /// Divides the mesh along a path of edges from border to border, drawn tight.
  void divide_along(const std::vector<Index>& path, const Context& context);

  /// Each part of a mesh that was divided.
  std::vector<Opening> parts() const;

 private:
  void find_holes();
  std::size_t loops_but_holes() const;
  std::size_t left_to_open() const;
  std::size_t left_with_holes() const;
  bool is_whole() const;
  Chains as_edges(const Chains& paths, std::size_t kept, const Context& context);
  void open_along(const EssentialPath& way, const Context& context);
  void cut(const Chains& paths);
  void carry(std::span<const Index> vertices);

  Patch patch_;
  std::vector<Index> source_, triangle_of_;  // as it came
  std::vector<double> weights_;
  std::vector<unsigned char> is_hole_, was_border_;  // by vertex
  bool keep_holes_, along_edges_;
  Chains paths_;
  std::size_t edges_ = 0;
  double length_ = 0.0;
};

}  // namespace planish
