#include "panels/piece/piece_corners.h"

#include <algorithm>

#include "mesh/disjoint_sets.h"

namespace planish {

namespace {

/// Which side of a triangle an edge is.
std::size_t side_of(const PanelMesh& mesh, Index triangle, Index edge) {
  std::size_t side = 0;
  while (mesh.edge_of(triangle, side) != edge)
    ++side;
  return side;
}

}  // namespace

PieceCorners::PieceCorners(const PanelMesh& mesh, const OpenEdges& open,
                           std::span<const Index> triangles)
    : triangles_(triangles) {
  std::vector<Index> place(mesh.triangles().size(), PanelEdge::none);
  for (std::size_t k = 0; k < triangles.size(); ++k)
    place[triangles[k]] = static_cast<Index>(k);
  for (const Index t : triangles) {
    std::array<Index, 3> across{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Index e = mesh.edge_of(t, i), other = mesh.edges()[e].other(t);
      across[i] = open[e] != 0 || other == PanelEdge::none ? PanelEdge::none : place[other];
    }
    across_.push_back(across);
  }
  unite(mesh);
  trace_border(mesh, place);
}

void PieceCorners::unite(const PanelMesh& mesh) {
  DisjointSets<Index> fans(3 * triangles_.size());
  const auto corner = [](std::size_t k, std::size_t i) {
    return static_cast<Index>(3 * k + i % 3);
  };
  for (std::size_t k = 0; k < across_.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index next = across_[k][i];
      if (next == PanelEdge::none || next < k) continue;
      const std::size_t j = side_of(mesh, triangles_[next], mesh.edge_of(triangles_[k], i));
      fans.join(corner(k, i), corner(next, j + 1));
      fans.join(corner(k, i + 1), corner(next, j));
    }
  }
  std::vector<Index> number(3 * triangles_.size(), 0);
  corners_.resize(triangles_.size());
  for (Index c = 0; c < number.size(); ++c) {
    const Index first = fans.first_of(c);
    if (first == c) {
      number[c] = static_cast<Index>(vertex_of_.size());
      vertex_of_.push_back(mesh.triangles()[triangles_[c / 3]][c % 3]);
    }
    corners_[c / 3][c % 3] = number[first];
  }
}

/// @param place of each triangle of the mesh in the piece
void PieceCorners::trace_border(const PanelMesh& mesh, std::span<const Index> place) {
  is_border_.assign(vertex_of_.size(), 0);
  std::size_t ends = 0;
  std::vector<std::array<unsigned char, 3>> seen(across_.size(), {0, 0, 0});
  for (std::size_t k = 0; k < across_.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!is_end(k, i)) continue;
      ++ends;
      is_border_[corners_[k][i]] = is_border_[corners_[k][(i + 1) % 3]] = 1;
      if (seen[k][i] != 0) continue;
      std::vector<Index>& loop = loops_.emplace_back();
      bool is_cut = false, is_slit = true;
      for (std::size_t t = k, side = i; seen[t][side] == 0;) {
        seen[t][side] = 1;
        loop.push_back(corners_[t][side]);
        const PanelEdge& edge = mesh.edges()[mesh.edge_of(triangles_[t], side)];
        is_cut = is_cut || !edge.is_border();
        is_slit =
            is_slit && !edge.is_border() && place[edge.other(triangles_[t])] != PanelEdge::none;
        side = (side + 1) % 3;
        while (!is_end(t, side)) {
          const Index next = across_[t][side];
          side = (side_of(mesh, triangles_[next], mesh.edge_of(triangles_[t], side)) + 1) % 3;
          t = next;
        }
      }
      cut_loops_ += is_cut ? 1 : 0;
      is_slit_.push_back(is_slit ? 1 : 0);
    }
  }
  // Euler: V - E + F + loops = 2 for a sphere with holes, in one part.
  const std::size_t edges = (3 * across_.size() + ends) / 2;
  is_planar_ = vertex_of_.size() + across_.size() + loops_.size() == edges + 2;
}

}  // namespace planish
