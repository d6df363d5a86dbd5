#include <string>
#include <vector>

#include <planish/io/read_mesh.h>

#include <gtest/gtest.h>

namespace planish {
namespace {

const std::string k_group_corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\n";

FaceGroups obj_groups(const std::string& statements) {
  return parse_mesh(k_group_corners + statements, MeshFormat::obj, "mesh").groups;
}

void expect_groups(const FaceGroups& groups, const std::string& kind,
                   const std::vector<std::string>& names, const std::vector<Index>& of_triangle) {
  EXPECT_EQ(groups.kind, kind);
  EXPECT_EQ(groups.names, names);
  EXPECT_EQ(groups.of_triangle, of_triangle);
}

TEST(ReadGroups, TakesThoseThatDivideTheFacesOfAnObj) {
  expect_groups(obj_groups("g left\nf 1 2 3 4\ng right side\nf 2 5 3\n"), "g",
                {"left", "right side"}, {0, 0, 1});
  expect_groups(obj_groups("o a\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 3 4\no b\nf 2 5 3\n"), "o",
                {"a", "b"}, {0, 0, 1});
}

TEST(ReadGroups, KeepsMaterialsApartFromObjects) {
  const std::string statements = "usemtl red\nf 1 2 3\nusemtl blue\nf 1 3 4\n";
  for (const std::string& before : {std::string(), std::string("o all\ng all\n")}) {
    const ReadResult file =
        parse_mesh(k_group_corners + before + statements, MeshFormat::obj, "mesh");
    expect_groups(file.groups, "", {}, {});
    expect_groups(file.materials, "usemtl", {"red", "blue"}, {0, 1});
  }
  expect_groups(
      parse_mesh(k_group_corners + "usemtl red\nf 1 2 3 4\n", MeshFormat::obj, "mesh").materials,
      "", {}, {});
}

TEST(ReadGroups, GoesOnWithAGroupThatComesAgain) {
  expect_groups(obj_groups("g a\nf 1 2 3\ng b\nf 1 3 4\ng a\nf 2 5 3\n"), "g", {"a", "b"},
                {0, 1, 0});
}

TEST(ReadGroups, CallsFacesWithoutANameDefault) {
  expect_groups(obj_groups("f 1 2 3\ng\nf 1 3 4\ng b\nf 2 5 3\n"), "g", {"default", "b"},
                {0, 0, 1});
}

TEST(ReadGroups, AreNoneWhereThereIsOneOnly) {
  expect_groups(obj_groups("f 1 2 3\nf 1 3 4\n"), "", {}, {});
  expect_groups(obj_groups("o a\ng b\nusemtl c\nf 1 2 3\ng empty\ng b\nf 1 3 4\ng last\n"), "", {},
                {});
}

TEST(ReadGroups, TakesAnIntegerOfTheFacesOfAPly) {
  const auto groups = [](const std::string& properties, const std::string& faces) {
    return parse_mesh(
               "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
               "property float z\nelement face 2\n" +
                   properties + "end_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n" + faces,
               MeshFormat::ply, "mesh")
        .groups;
  };
  const std::string list = "property list uchar int vertex_indices\n";
  expect_groups(groups(list + "property int label\n", "3 0 1 2 7\n3 0 2 3 -1\n"), "label",
                {"label-7", "label--1"}, {0, 1});
  expect_groups(groups("property uchar patch\n" + list, "2 3 0 1 2\n0 3 0 2 3\n"), "patch",
                {"patch-2", "patch-0"}, {0, 1});
  expect_groups(groups(list + "property int label\n", "3 0 1 2 7\n3 0 2 3 7\n"), "", {}, {});
  expect_groups(groups(list + "property float label\n", "3 0 1 2 7\n3 0 2 3 1\n"), "", {}, {});
  expect_groups(groups(list + "property int red\n", "3 0 1 2 7\n3 0 2 3 1\n"), "", {}, {});
}

}  // namespace
}  // namespace planish
