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

/// Each comment of an .obj file states the unit, and there is nothing to note.
void expect_units(const std::vector<std::pair<std::string, Unit>>& comments) {
  for (const auto& [comment, unit] : comments) {
    const ReadResult result = obj_with(comment);
    ASSERT_TRUE(result.unit.has_value()) << comment;
    EXPECT_EQ(result.unit->unit, unit) << comment;
    EXPECT_TRUE(result.notes.empty()) << comment;
  }
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
      {"# units millimetres; maximum extent exactly 200.0 mm", Unit::mm},
      {"# length_unit=in", Unit::in},
      {"# 1 unit=1mm", Unit::mm}};
  for (const auto& [comment, unit] : comments) {
    const ReadResult result = obj_with(comment);
    ASSERT_TRUE(result.unit.has_value()) << comment;
    EXPECT_EQ(result.unit->unit, unit) << comment;
    EXPECT_EQ(result.unit->line, 2U);
    EXPECT_TRUE(result.notes.empty()) << comment;
  }
  EXPECT_EQ(obj_with("#  File units = inches \r").unit->words, "File units = inches");
}

TEST(StatedUnit, IsFoundInCommentsWithoutTheWordUnit) {
  const std::vector<std::pair<std::string, Unit>> comments = {
      {"# all dimensions in inches", Unit::in},
      {"# ALL DIMENSIONS ARE IN INCHES UNLESS OTHERWISE SPECIFIED", Unit::in},
      {"# Millimeters", Unit::mm},
      {"# in mm", Unit::mm},
      {"# Centimetres (cm)", Unit::cm},
      {"# scale: cm", Unit::cm},
      {"# scale = m", Unit::m},
      {"# Dimensions (in)", Unit::in},
      {"# Scale 1:1, all lengths in mm.", Unit::mm},
      {"# coordinates are in metres, z up", Unit::m},
      {"# measurements inches", Unit::in},
      {"# two panels, model in dm", Unit::dm},
      {"# 2021-05-02 exported in m", Unit::m}};
  expect_units(comments);
}

TEST(StatedUnit, IsNotFoundWhereWordsMeanOtherThings) {
  for (const std::string comment : {"# created in 5 ms",
                                    "# made in China",
                                    "# made in Gary, IN",
                                    "# saved in M:/models",
                                    "# plate 20 mm",
                                    "# panel_mm",
                                    "# winches and cinches",
                                    "# size: M",
                                    "# in",
                                    "# M",
                                    "# foot",
                                    "# bolts of length 20 mm",
                                    "# dimensions 100 x 50 mm",
                                    "# inches of rain",
                                    "# drawn in inches of water",
                                    "# model: cm",
                                    "# pressure scale: kg/m",
                                    "# length in mm^2",
                                    "# file 1e5",
                                    "# .",
                                    "# -",
                                    "# a united front in mm",
                                    "# unit normals in file",
                                    "# units of the model",
                                    "# speed units: m/s",
                                    "# texture units: cm",
                                    "# units of time: m",
                                    "# unit vectors, m of them",
                                    "# units: unknown",
                                    "# units in use"}) {
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
  EXPECT_NE(only_note("# units: yards").find("--unit in --scale 36"), std::string::npos);
  EXPECT_NE(only_note("# Units = foot").find("--unit in --scale 12"), std::string::npos);
  EXPECT_NE(only_note("# units: US survey foot").find("--unit m --scale 0.3048006096"),
            std::string::npos);
  for (const std::string micrometres : {"microns", "um", "\xc2\xb5m", "\xce\xbcm"}) {
    EXPECT_NE(only_note("# units: " + micrometres).find("--unit mm --scale 0.001"),
              std::string::npos);
  }
  for (const std::string comment :
       {"# units: hundredths of an inch", "# unit: half inches", "# units: 1e-3 m",
        "# unit = 25.4mm", "# units: 1/100 inch", "# scale: 0.01 inch", "# units not in mm",
        "# scale 1:2, dimensions in cm", "# was inches, all dimensions in mm"})
    EXPECT_NE(only_note(comment).find("--scale"), std::string::npos) << comment;
  EXPECT_NE(only_note("# units changed from inches to mm").find("--unit"), std::string::npos);
  EXPECT_NE(only_note("# units: mm\n# units: inches").find("neither is used"), std::string::npos);
  EXPECT_TRUE(obj_with("# units: mm\n# unit = millimeter").unit.has_value());
}

TEST(StatedUnit, IsNotUsedWhereTheCommentScalesIt) {
  for (const std::string comment : {"# units per meter: 100",
                                    "# meters per unit: 0.01",
                                    "# 10 units per inch",
                                    "# units per mm",
                                    "# unit in meters: 0.01",
                                    "# unit (in mm): 25.4",
                                    "# LengthUnit=m factor=0.01",
                                    "# unit: m, factor 1e-3",
                                    "# unit: m, factor 1e+3",
                                    "# unit 1 m = 100",
                                    "# units 100, in m",
                                    "# units: 0,1 mm",
                                    "# unit: 1,000 m",
                                    "# Unit conversion factor (to mm): 25.4",
                                    "# unit conversion: mm, 25.4",
                                    "# LENGTH_UNIT(CENTI,METRE)",
                                    "# units: kilo meters",
                                    "# units: mm x 10",
                                    "# units: mm*10",
                                    "# units: mm/10",
                                    "# units: mm x10^-1",
                                    "# units: m \xc3\x97 0.01",
                                    "# units: mm times 10",
                                    "# Units: inches (x10)",
                                    "# Units: cm (10)",
                                    "# unit: inch, scaled by 2",
                                    "# unit: inch multiplied by 2",
                                    "# units: twice mm",
                                    "# Units: mm at 1:10 scale",
                                    "# 1:10 scale model, units mm",
                                    "# units: mm, 50% scale",
                                    "# Model at half scale, units: mm",
                                    "# 1:10 model, units: mm",
                                    "# units: mm (10:1)",
                                    "# units of work: m. smith",
                                    "# unit of sale: m",
                                    "# Unit Test Model, made in m"}) {
    const ReadResult result = obj_with(comment);
    EXPECT_FALSE(result.unit.has_value()) << comment;
    ASSERT_EQ(result.notes.size(), 1U) << comment;
    EXPECT_NE(result.notes.front().find("which is not used: say with --unit, and with --scale"),
              std::string::npos)
        << comment;
  }
}

TEST(StatedUnit, IsUsedWhereNumbersBesideItAreOfOtherThings) {
  const std::vector<std::pair<std::string, Unit>> comments = {
      {"# System units: 1 Unit = 1.0000 Inches", Unit::in},
      {"# meters per unit: 1.0", Unit::m},
      {"# LengthUnit=m factor=1", Unit::m},
      {"# units: mm, one piece per file, 3 pieces", Unit::mm},
      {"# mm units, seam 10", Unit::mm},
      {"# units: mm, 12 panels", Unit::mm},
      {"# units: mm (12 panels)", Unit::mm},
      {"# units: mm, plate 120 x 80", Unit::mm},
      {"# Exported by X - Units: Inches - Date: 2020", Unit::in},
      {"# units: mm, conversion by X 2.3", Unit::mm},
      {"# units: mm, exported 2020-01-02 12:01:30", Unit::mm},
      {"# exported 2020-01-02 1:30 pm, units: mm", Unit::mm},
      {"# version 3, scale: 1, units: mm", Unit::mm},
      {"# unit of the model: cm", Unit::cm},
      {"# unit of measure: in.", Unit::in},
      {"# Units: Centimeters; Scale: 1.0", Unit::cm},
      {"# angle units: degrees; length units: cm", Unit::cm}};
  expect_units(comments);
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
  EXPECT_EQ(unit_of("OFF # all in cm\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n", MeshFormat::off),
            "cm 1");
  EXPECT_EQ(unit_of(ply_begin + "comment Millimeters\n" + ply_end, MeshFormat::ply), "mm 3");
  EXPECT_EQ(unit_of("solid part, dimensions in inches\n" + facet, MeshFormat::stl), "in 1");
  EXPECT_EQ(unit_of("solid part units: inches\n" + facet, MeshFormat::stl), "in 1");
  EXPECT_EQ(unit_of(binary, MeshFormat::stl), "mm 0");
}

}  // namespace
}  // namespace planish
