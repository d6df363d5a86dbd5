#include <planish/io/read_features.h>

#include <gtest/gtest.h>

#include "support/own_folder.h"

namespace planish {
namespace {

/// Two squares side by side, at x from 0 to 2, of which the vertices between have been doubled
/// where `doubled`.
std::string squares(const std::string& statements, const std::string& faces) {
  return "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\n" + statements + faces;
}

class ModelLinesTest : public OwnFolder {
 protected:
  DrawnLines lines(const std::string& text, ModelLines which) {
    const auto path = folder_ / "model.obj";
    put_file(path, text);
    return read_model_lines(path, which);
  }

  ErrorCode code(const std::string& text, ModelLines which) {
    try {
      lines(text, which);
    } catch (const Error& error) {
      EXPECT_FALSE(error.place().path.empty());
      return error.code();
    }
    return ErrorCode::unfold_failed;
  }
};

void expect_middle(const DrawnLines& drawn) {
  ASSERT_EQ(drawn.lines.size(), 1U);
  EXPECT_EQ(drawn.lines[0].points, (std::vector<Vec3>{{1, 0, 0}, {1, 1, 0}}));
}

TEST_F(ModelLinesTest, AreSeamsOfTheTexture) {
  const std::string texture = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 5 0\nvt 6 0\nvt 6 1\nvt 5 1\n";
  expect_middle(
      lines(squares(texture, "f 1/1 2/2 5/3 4/4\nf 2/5 3/6 6/7 5/8\n"), ModelLines::texture));
  // The same by numbers from the end, with normals, and of a seam that has two vertices at a place.
  expect_middle(lines(
      squares(texture, "vn 0 0 1\nf 1/1/1 2/2/1 5/3/1 4/4/1\nf 2/-4/1 3/-3/1 6/-2/1 5/-1/1\n"),
      ModelLines::texture));
  expect_middle(
      lines(squares("v 1 0 0\nv 1 1 0\n" + texture, "f 1/1 2/2 5/3 4/4\nf 7/5 3/6 6/7 8/8\n"),
            ModelLines::texture));
}

TEST_F(ModelLinesTest, AreNoneWhereTheTextureGoesOn) {
  // By other numbers, but at the same places.
  const std::string texture = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 1 0\nvt 2 0\nvt 2 1\nvt 1 1\n";
  EXPECT_EQ(code(squares(texture, "f 1/1 2/2 5/3 4/4\nf 2/5 3/6 6/7 5/8\n"), ModelLines::texture),
            ErrorCode::misplaced_cut);
  EXPECT_EQ(code(squares("", "f 1 2 5 4\nf 2 3 6 5\n"), ModelLines::texture),
            ErrorCode::misplaced_cut);
}

TEST_F(ModelLinesTest, AreBordersOfGroupsAndMaterials) {
  const std::string groups = "g a\nusemtl red\nf 1 2 5 4\ng b\nf 2 3 6 5\n";
  expect_middle(lines(squares("", groups), ModelLines::groups));
  EXPECT_EQ(code(squares("", groups), ModelLines::materials), ErrorCode::misplaced_cut);
  const std::string materials = "usemtl red\nf 1 2 5 4\nusemtl blue\nf 2 3 6 5\n";
  expect_middle(lines(squares("", materials), ModelLines::materials));
  expect_middle(lines(squares("", materials), ModelLines::groups));
}

}  // namespace
}  // namespace planish
