#include <string>

#include <planish/core/error.h>
#include <planish/core/unit.h>

#include <gtest/gtest.h>

namespace planish {
namespace {

TEST(Unit, HasItsSizeInMillimetres) {
  EXPECT_EQ(millimetres_per(Unit::mm), 1.0);
  EXPECT_EQ(millimetres_per(Unit::cm), 10.0);
  EXPECT_EQ(millimetres_per(Unit::dm), 100.0);
  EXPECT_EQ(millimetres_per(Unit::m), 1000.0);
  EXPECT_EQ(millimetres_per(Unit::in), 25.4);
}

TEST(Unit, IsFoundByTheNameThatItHas) {
  for (const Unit unit : {Unit::mm, Unit::cm, Unit::dm, Unit::m, Unit::in}) {
    EXPECT_EQ(unit_named(to_string(unit)), unit);
  }
}

TEST(Unit, NamesTheKnownOnesWhenAskedForAnother) {
  for (const std::string name : {"ft", "", "MM", "mmm"}) {
    try {
      unit_named(name);
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::unknown_name);
      EXPECT_EQ(error.message(),
                "no unit is called '" + name + "'; there are mm, cm, dm, m and in");
    }
  }
}

}  // namespace
}  // namespace planish
