#include "panels/uv_score.h"

#include <cmath>
#include <sstream>
#include <string>

#include <planish/mesh/shapes.h>
#include <planish/panels/suggest_panels.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/own_folder.h"

namespace planish {
namespace {

/// Two squares of 2 by 2 side by side, of unit quads, whose common side has vertices for each. In
/// the texture the second one lies apart, stretched in x, and the first has a slit from the middle
/// of its lower side to its centre, where its sides lie elsewhere.
struct TwoSquares {
  double stretch = 1.0;
  Vec2 slit_left{1.0, 0.0}, slit_right{1.0, 0.0};
  bool is_mirrored = false;

  std::string obj() const {
    std::ostringstream vertices, texture, faces;
    for (const double left : {0.0, 2.0}) {
      for (int v = 0; v < 9; ++v)
        vertices << "v " << left + v % 3 << ' ' << v / 3 << " 0\n";
    }
    int corner = 0;
    for (int quad = 0; quad < 8; ++quad) {
      const int square = quad / 4, x = quad % 2, y = quad % 4 / 2;
      faces << 'f';
      for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        const Vec2 place = place_of(square, x, {double(x + dx), double(y + dy)});
        texture << "vt " << (is_mirrored ? -place.x : place.x) << ' ' << place.y << '\n';
        faces << ' ' << 9 * square + 3 * (y + dy) + x + dx + 1 << '/' << ++corner;
      }
      faces << '\n';
    }
    return vertices.str() + texture.str() + faces.str();
  }

 private:
  Vec2 place_of(int square, int column, Vec2 p) const {
    if (square == 1) return {10.0 + stretch * p.x, p.y};
    if (p == Vec2{1.0, 0.0}) return column == 0 ? slit_left : slit_right;
    return p;
  }
};

class UvScoreTest : public OwnFolder {
 protected:
  UvScore score(const std::string& obj) {
    const auto path = folder_ / "map.obj";
    put_file(path, obj);
    return score_of(read_uv_map(path));
  }
};

TEST_F(UvScoreTest, HasTheStrainOfTheWholeAtEqualArea) {
  constexpr double k_stretch = 1.1;
  const UvScore score = this->score(TwoSquares{.stretch = k_stretch}.obj());
  EXPECT_EQ(score.pieces, 2U);
  EXPECT_EQ(score.tips, 0U);
  EXPECT_NEAR(score.seam, 2.0 / std::sqrt(8.0), 1e-12);
  EXPECT_NEAR(score.jag, 1.0, 1e-12);
  EXPECT_EQ(score.overlapping, 0U);
  EXPECT_EQ(score.flipped, 0U);
  // Of the stretched half a third of the area each: edges along x, along y, and diagonals.
  const double size = std::sqrt(8.0 / (4.0 + 4.0 * k_stretch));
  const double along = size * k_stretch - 1.0, across = size - 1.0;
  const double diagonal = size * std::sqrt((k_stretch * k_stretch + 1.0) / 2.0) - 1.0;
  const double squares =
      4.0 * across * across + 4.0 / 3.0 * (along * along + across * across + diagonal * diagonal);
  EXPECT_NEAR(score.strain.rms, std::sqrt(squares / 8.0), 1e-12);
  EXPECT_NEAR(score.strain.max, along, 1e-12);
  EXPECT_NEAR(score.strain.p99, along, 1e-12);
}

TEST_F(UvScoreTest, CountsSlitsAndOverlaps) {
  const TwoSquares open{.slit_left = {0.9, 0.0}, .slit_right = {1.1, 0.0}};
  for (const bool is_mirrored : {false, true}) {
    TwoSquares map = open;
    map.is_mirrored = is_mirrored;
    const UvScore score = this->score(map.obj());
    EXPECT_EQ(score.pieces, 2U);
    EXPECT_EQ(score.tips, 1U);
    EXPECT_NEAR(score.seam, 3.0 / std::sqrt(8.0), 1e-12);
    EXPECT_EQ(score.overlapping, 0U);
    EXPECT_EQ(score.flipped, 0U);
  }
  const TwoSquares lapping{.slit_left = {1.1, -0.1}, .slit_right = {0.9, 0.0}};
  EXPECT_EQ(score(lapping.obj()).overlapping, 1U);
  const TwoSquares folded{.slit_left = {0.5, 1.5}, .slit_right = {1.1, 0.0}};
  EXPECT_GT(score(folded.obj()).flipped, 0U);
}

TEST_F(UvScoreTest, AgreesWithThePanelsOfASearch) {
  const TriMesh dome = make_shape("dome", 800);
  const PanelOptions options{.limits = {.rms = 0.01}, .match_seams = false, .moves = 1};
  const PanelSuggestion found = suggest_panels(Patch(dome), options);
  const UvMap map = uv_map_of(found, options.limits);
  const UvScore direct = score_of(map);
  ASSERT_GT(found.tips, 0U);
  EXPECT_EQ(direct.pieces, found.panels.size());
  EXPECT_EQ(direct.tips, found.tips);
  EXPECT_NEAR(direct.seam, found.length / std::sqrt(meshes::area(found.mesh)), 1e-9);
  EXPECT_EQ(direct.overlapping + direct.flipped, 0U);
  EXPECT_NEAR(direct.strain.rms, found.panels[0].strain.rms, 1e-4);
  const UvScore read = score(format_panels(found, map));
  EXPECT_EQ(read.tips, direct.tips);
  EXPECT_NEAR(read.seam, direct.seam, 1e-12);
  EXPECT_NEAR(read.jag, direct.jag, 1e-12);
  EXPECT_NEAR(read.strain.rms, direct.strain.rms, 1e-12);
  EXPECT_EQ(read.overlapping, direct.overlapping);
}

TEST_F(UvScoreTest, RefusesFacesWithoutTexture) {
  try {
    score("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nf 1/1 2/1 3/1\nf 2 4 3\n");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::misplaced_cut);
    EXPECT_EQ(error.place().line, 7U);
  }
}

}  // namespace
}  // namespace planish
