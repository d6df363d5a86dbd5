#include "text/lengths.h"

#include <gtest/gtest.h>

namespace planish::cli {
namespace {

std::string of_size(double width, double height, Unit unit) {
  Pattern pattern;
  pattern.width = width;
  pattern.height = height;
  return unusual_size_text(pattern, unit).value_or("");
}

TEST(ShownLengths, AreInMillimetresOrInches) {
  EXPECT_EQ(ShownLengths(Unit::m).text(0.00777), "7.77 mm");
  EXPECT_EQ(ShownLengths(Unit::cm).text(59.3214), "593.2 mm");
  EXPECT_EQ(ShownLengths(Unit::mm).text(26.0), "26.0 mm");
  EXPECT_EQ(ShownLengths(Unit::in).text(0.5), "0.500 in");
  EXPECT_EQ(ShownLengths(Unit::mm).text(0.0), "0.00 mm");
  EXPECT_EQ(ShownLengths(Unit::m).text(1e20), "1.00e+23 mm");
  EXPECT_EQ(ShownLengths::in_model_units().text(0.00777), "0.00777 model units");
}

TEST(UnusualSize, IsNotNotedOfPiecesOfUsualSize) {
  EXPECT_EQ(of_size(50.0, 1.0, Unit::mm), "");
  EXPECT_EQ(of_size(1.0, 5.0, Unit::m), "");
  EXPECT_EQ(of_size(0.0, 0.0, Unit::mm), "");
}

TEST(UnusualSize, NamesTheUnitsUnderWhichItWouldBeUsual) {
  EXPECT_EQ(of_size(0.2, 0.593, Unit::mm),
            "the pattern is 0.593 mm long; with --unit m it would be 593 mm, with --unit dm it "
            "would be 59.3 mm");
  EXPECT_EQ(of_size(24.0, 3.0, Unit::mm),
            "the pattern is 24.0 mm long; with --unit cm it would be 240 mm, with --unit dm it "
            "would be 2400 mm, with --unit in it would be 610 mm");
  EXPECT_EQ(of_size(320.0, 3.0, Unit::m),
            "the pattern is 320 m long; with --unit mm it would be 320 mm, with --unit cm it "
            "would be 3200 mm");
  EXPECT_EQ(of_size(6e6, 1.0, Unit::mm),
            "the pattern is 6000 m long; if the mesh is not in mm, give its unit with --unit");
}

}  // namespace
}  // namespace planish::cli
