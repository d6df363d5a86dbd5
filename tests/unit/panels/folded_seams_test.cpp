#include "panels/folded_seams.h"

#include <algorithm>
#include <cmath>

#include <planish/mesh/symmetry.h>
#include <planish/panels/suggest_panels.h>

#include <gtest/gtest.h>

#include "panels/cells/halved_product.h"
#include "support/meshes.h"
#include "support/solids.h"

namespace planish {
namespace {

const Plane k_across_x{{1.0, 0.0, 0.0}, 0.0};

/// A closed pear, its own mirror image in x = 0 alone.
TriMesh pear() {
  TriMesh mesh = solids::sphere(1.0, 24);
  for (Vec3& p : mesh.positions)
    p = {(1.0 + 0.3 * p.y) * p.x, 1.5 * p.y, 0.8 * p.z + 0.3 * p.y * p.y};
  return mesh;
}

Patch half_pear() {
  return *halved_product(Patch(pear()), k_across_x);
}

TEST(MirroredPanelMesh, HasAnImageOfEachEdgeAndTriangle) {
  const PanelMesh mesh(half_pear(), k_across_x);
  ASSERT_TRUE(mesh.is_mirrored());
  std::size_t on_plane = 0;
  for (Index e = 0; e < mesh.edges().size(); ++e) {
    const Index image = mesh.image_of_edge(e);
    EXPECT_EQ(mesh.image_of_edge(image), e);
    EXPECT_DOUBLE_EQ(mesh.edges()[image].length, mesh.edges()[e].length);
    const auto& x = mesh.patch().positions();
    const auto& [v, w] = mesh.edges()[e].ends;
    EXPECT_EQ(image == e, x[v].x == 0.0 && x[w].x == 0.0);
    on_plane += image == e ? 1 : 0;
    for (const Index t : mesh.edges()[e].triangles) {
      const auto& sides = mesh.edges()[image].triangles;
      EXPECT_NE(std::find(sides.begin(), sides.end(), mesh.image_of_triangle(t)), sides.end());
    }
  }
  EXPECT_GT(on_plane, 20U);
  for (Index t = 0; t < mesh.triangles().size(); ++t) {
    EXPECT_NE(mesh.is_image(t), mesh.is_image(mesh.image_of_triangle(t)));
    EXPECT_DOUBLE_EQ(mesh.area(mesh.image_of_triangle(t)), mesh.area(t));
  }
}

TEST(HalvedProduct, DividesEdgesThatBothHalvesWouldHave) {
  // Two triangles of which the plane x = 0 has the ends of the edge that they share.
  const TriMesh chord{{{0, 0, 0}, {1, 1, 0}, {0, 2, 0}, {0, 1, 1}}, {{0, 1, 2}, {0, 2, 3}}};
  const TriMesh divided = without_chords(chord, {{1.0, 0.0, 0.0}, 0.0});
  EXPECT_EQ(divided.triangles.size(), 4U);
  EXPECT_EQ(divided.positions.back(), (Vec3{0, 1, 0}));
  EXPECT_DOUBLE_EQ(meshes::area(divided), meshes::area(chord));
}

TEST(HalvedProduct, IsHalfOfTheArea) {
  EXPECT_NEAR(meshes::area(half_pear().mesh()), 0.5 * meshes::area(pear()), 1e-5)
      << "but for snapping";
  TriMesh turned = pear();
  for (Vec3& p : turned.positions)
    p = {p.x + 0.4 * p.y, p.y, p.z};
  EXPECT_THROW(halved_product(Patch(turned), k_across_x), Error);
}

TEST(FoldedSeams, UnfoldToThoseTheyWere) {
  ThreadPool pool(1);
  const Patch half = half_pear();
  const Division division =
      divided(PanelMesh(half), k_across_x, 0.05, {}, {.cells = 20, .plane = 10.0}, pool);
  const SeamNet& net = *division.net;
  const OpenEdges& open = division.state.open();
  for (Index e = 0; e < open.size(); ++e)
    EXPECT_EQ(open[net.mesh.image_of_edge(e)], open[e]);
  const CarriedSeams again = unfolded_seams(folded_seams(net, open), k_across_x);
  EXPECT_EQ(again.open, open);
  EXPECT_EQ(again.net.seams, net.seams);
  EXPECT_EQ(again.net.mesh.triangles(), net.mesh.triangles());

  // And lie on a finer half where they were.
  const CarriedSeams carried = carried_mirrored_seams(half, net, open, 0.01);
  EXPECT_NEAR(open_length(carried.net.mesh, carried.open), open_length(net.mesh, open),
              0.1 * open_length(net.mesh, open));
  const SeamState state(carried.net.mesh, carried.open, pool);
  EXPECT_EQ(state.piece_count(), division.state.piece_count());
}

/// The middle of each panel.
std::vector<Vec3> middles(const PanelSuggestion& found) {
  std::vector<Vec3> all;
  for (const SuggestedPanel& panel : found.panels) {
    Vec3 sum;
    for (const Index t : panel.triangles) {
      for (const Index v : found.mesh.triangles[t])
        sum = sum + found.mesh.positions[v];
    }
    all.push_back((1.0 / (3.0 * static_cast<double>(panel.triangles.size()))) * sum);
  }
  return all;
}

TEST(SuggestPanels, AreTheirOwnMirrorImageWhereAskedFor) {
  PanelOptions options{.limits = {.rms = 0.02}, .moves = 2, .symmetric_in = k_across_x};
  options.trial_vertices = 600;
  const PanelSuggestion found = suggest_panels(Patch(pear()), options);
  ASSERT_TRUE(found.met);
  const std::vector<Vec3> all = middles(found);
  for (const Vec3 middle : all) {
    const auto is_image = [&](Vec3 other) {
      return norm(mirrored(k_across_x, middle) - other) < 0.05;
    };
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), is_image));
  }
  double left = 0.0, right = 0.0;
  for (const std::vector<Index>& seam : found.seams) {
    for (std::size_t i = 1; i < seam.size(); ++i) {
      const Vec3 a = found.mesh.positions[seam[i - 1]], b = found.mesh.positions[seam[i]];
      if (a.x + b.x > 1e-6) right += norm(b - a);
      if (a.x + b.x < -1e-6) left += norm(b - a);
    }
  }
  EXPECT_NEAR(left, right, 0.01 * (left + right));
  options.symmetric_in = Plane{{0.0, 1.0, 0.0}, 0.0};
  EXPECT_THROW(suggest_panels(Patch(pear()), options), Error);
}

}  // namespace
}  // namespace planish
