#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "unit/io/io_testing.h"

namespace planish {
namespace {

ReadResult obj_with(const std::string& comment) {
  return parse_mesh("# made by hand\n" + comment + "\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n",
                    MeshFormat::obj, "mesh");
}

TEST(StatedUnit, IsFoundInCommentsAsProgramsWriteThem) {
  const std::vector<std::pair<std::string, Unit>> comments = {
      {"# File units = inches", Unit::in},
      {"# File units = meters", Unit::m},
      {"# units: mm", Unit::mm},
      {"#Unit: meters", Unit::m},
      {"## Units:\tCentimetres", Unit::cm},
      {"# Units in mm", Unit::mm},
      {"# Units: m", Unit::m},
      {"# units = in", Unit::in},
      {"# units: Millimeters (mm)", Unit::mm},
      {"# 1 unit = 1 meter", Unit::m},
      {"# unit: 1.0 dm", Unit::dm},
      {"# --- File units = inches ---", Unit::in},
      {"# This file uses centimeters as units for non-parametric coordinates.", Unit::cm},
      {"# units millimetres; maximum extent exactly 200.0 mm", Unit::mm}};
  for (const auto& [comment, unit] : comments) {
    const ReadResult result = obj_with(comment);
    ASSERT_TRUE(result.unit.has_value()) << comment;
    EXPECT_EQ(result.unit->unit, unit) << comment;
    EXPECT_EQ(result.unit->line, 2U);
    EXPECT_TRUE(result.notes.empty()) << comment;
  }
  EXPECT_EQ(obj_with("#  File units = inches \r").unit->words, "File units = inches");
}

TEST(StatedUnit, IsNotFoundWhereWordsMeanOtherThings) {
  for (const std::string comment :
       {"# inches", "# a united front in mm", "# unit normals in file", "# units of the model",
        "# speed units: m/s", "# unit vectors, m of them", "# units: unknown", "# units in use"}) {
    const ReadResult result = obj_with(comment);
    EXPECT_FALSE(result.unit.has_value()) << comment;
    EXPECT_TRUE(result.notes.empty()) << comment;
  }
  EXPECT_FALSE(obj_with("# units: mm" + std::string(300, '!')).unit.has_value());
}

TEST(StatedUnit, IsToldButNotUsedWhereItIsNoneOfOurs) {
  const auto only_note = [](const std::string& comment) {
    const ReadResult result = obj_with(comment);
    EXPECT_FALSE(result.unit.has_value()) << comment;
    EXPECT_EQ(result.notes.size(), 1U) << comment;
    return result.notes.empty() ? std::string() : result.notes.front();
  };
  EXPECT_EQ(only_note("# units: feet"),
            "line 2 says \"units: feet\", which is not used: for feet give --unit in --scale 12");
  EXPECT_NE(only_note("# 1 unit = 2.54 cm").find("--scale"), std::string::npos);
  EXPECT_NE(only_note("# units changed from inches to mm").find("--unit"), std::string::npos);
  EXPECT_NE(only_note("# units: mm\n# units: inches").find("neither is used"), std::string::npos);
  EXPECT_TRUE(obj_with("# units: mm\n# unit = millimeter").unit.has_value());
}

TEST(StatedUnit, IsFoundInEveryFormat) {
  const std::string ply_begin = "ply\nformat ascii 1.0\n";
  const std::string ply_end =
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n";
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\n"
      "endfacet\nendsolid\n";
  std::string binary = "part UNITS=mm";
  binary.resize(80, '\0');
  binary += packed(std::endian::little, std::uint32_t{1}, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F,
                   0.F, 1.F, 1.F, 0.F, std::uint16_t{0});
  const auto unit_of = [](const std::string& bytes, MeshFormat format) {
    const ReadResult result = parse_mesh(bytes, format, "mesh");
    return result.unit
               ? std::string(to_string(result.unit->unit)) + " " + std::to_string(result.unit->line)
               : std::string();
  };
  EXPECT_EQ(unit_of(ply_begin + "comment units mm\n" + ply_end, MeshFormat::ply), "mm 3");
  EXPECT_EQ(unit_of(ply_begin + "obj_info Unit = cm\n" + ply_end, MeshFormat::ply), "cm 3");
  EXPECT_EQ(unit_of("OFF\n# units: in\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n", MeshFormat::off),
            "in 2");
  EXPECT_EQ(unit_of("solid part units: inches\n" + facet, MeshFormat::stl), "in 1");
  EXPECT_EQ(unit_of(binary, MeshFormat::stl), "mm 0");
}

}  // namespace
}  // namespace planish
