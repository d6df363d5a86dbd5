#include <cmath>
#include <sstream>
#include <string>

#include <planish/draw/format_drawing.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish {
namespace {

using testing::HasSubstr;

Drawing drawing_in_unit() {
  Path path{{{{0.0, 0.0}, {254.0, 0.0}, {254.0, 127.003}}}, true, Stroke{}};
  Path arc{{{{0, 0}, {10, 0}}}, false, Stroke{}};
  arc.fitted.curves = {Curve{{0, 0}, {CubicTo{{10, 0}, {20, 10}, {25.4, 25.4}}}}};
  return {"t",
          300.0,
          200.0,
          {Layer{"cut", {path, arc}}, Layer{"label", {Text{{25.4, 50.8}, 2.54, "x"}}}}};
}

/// All values of a code that are numbers, in the order of the file.
std::vector<double> values_of(const std::string& dxf, int wanted) {
  std::vector<double> values;
  std::istringstream file(dxf);
  for (std::string code, value; std::getline(file, code) && std::getline(file, value);) {
    if (std::stoi(code) == wanted) values.push_back(std::stod(value));
  }
  return values;
}

TEST(DxfInInches, HasEveryLengthDividedAndSaysSo) {
  for (const DxfVersion version : {DxfVersion::r12, DxfVersion::r2000}) {
    const std::string metric = format_dxf(drawing_in_unit(), {.version = version});
    const std::string inches =
        format_dxf(drawing_in_unit(), {.version = version, .unit = Unit::in});
    EXPECT_THAT(inches, HasSubstr("$INSUNITS\n70\n1\n"));
    EXPECT_THAT(inches, HasSubstr("$MEASUREMENT\n70\n0\n"));
    EXPECT_THAT(metric, HasSubstr("$INSUNITS\n70\n4\n"));
    for (const int code : {10, 11, 20, 30, 49}) {
      const std::vector<double> a = values_of(metric, code), b = values_of(inches, code);
      ASSERT_EQ(a.size(), b.size()) << code;
      for (std::size_t i = 0; i < a.size(); ++i)
        EXPECT_NEAR(25.4 * b[i], a[i], 0.0002) << code;
    }
    EXPECT_EQ(values_of(metric, 70).size(), values_of(inches, 70).size());
  }
}

TEST(DxfInInches, KeepsKnotsOfSplines) {
  const DxfOptions options{.version = DxfVersion::r2000, .unit = Unit::in};
  const std::string dxf = format_dxf(drawing_in_unit(), options);
  const std::size_t spline = dxf.find("\nSPLINE\n");
  ASSERT_NE(spline, std::string::npos);
  EXPECT_THAT(dxf.substr(spline, 400), HasSubstr("\n40\n1.0\n"));
}

TEST(DxfInInches, IsEnglishForApparelPrograms) {
  Drawing drawing = drawing_in_unit();
  drawing.pieces = {{"front"}};
  const std::string dxf = format_dxf(drawing, {.profile = DxfProfile::aama, .unit = Unit::in});
  EXPECT_THAT(dxf, HasSubstr("Units: ENGLISH"));
  EXPECT_THAT(dxf, testing::Not(HasSubstr("METRIC")));
}

}  // namespace
}  // namespace planish
