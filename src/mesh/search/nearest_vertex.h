#pragma once

#include <cstddef>
#include <vector>

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// Finds the vertex that is nearest to a place, of those that triangles use: a k-d tree over them.
class NearestVertex {
 public:
  /// @param mesh must outlive it
  /// @param places what will be asked for; only tells how large the numbers are
  NearestVertex(const TriMesh& mesh, const std::vector<Vec3>& places);

  /// The nearest vertex, of several the one with the smallest number.
  /// @pre the mesh has a triangle
  Index of(Vec3 place) const;

 private:
  struct Candidate {
    double square;
    Index vertex;
    bool operator<(const Candidate& other) const {
      return square != other.square ? square < other.square : vertex < other.vertex;
    }
  };

  void split(std::size_t begin, std::size_t end, int axis);
  void search(std::size_t begin, std::size_t end, int axis, Vec3 place, Candidate& best) const;

  const TriMesh& mesh_;
  double scale_;
  std::vector<Index> vertices_;  ///< the middle of each part splits it
};

}  // namespace planish
