#include "core/likely_units.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(LikelyUnits, AreThoseThatMakeTheSizeUsual) {
  EXPECT_THAT(likely_units(0.6, Unit::mm), ElementsAre(Unit::m, Unit::dm)) << "a jacket in metres";
  EXPECT_THAT(likely_units(60.0, Unit::m), ElementsAre(Unit::cm, Unit::mm, Unit::in));
  EXPECT_THAT(likely_units(600.0, Unit::m), ElementsAre(Unit::mm));
}

TEST(LikelyUnits, ComeByHowUsualTheSizeWouldBe) {
  EXPECT_EQ(likely_units(10.3, Unit::m).front(), Unit::dm) << "a suit of MakeHuman, not of a doll";
  EXPECT_EQ(likely_units(1.95, Unit::mm).front(), Unit::dm) << "a shoe of MakeHuman";
  EXPECT_EQ(likely_units(0.59, Unit::mm).front(), Unit::m) << "a wetsuit of GarmentCode";
  EXPECT_EQ(likely_units(320.0, Unit::m).front(), Unit::mm);
}

TEST(LikelyUnits, AreNoneWhereNoneFits) {
  EXPECT_THAT(likely_units(1e-6, Unit::mm), IsEmpty());
  EXPECT_THAT(likely_units(1e9, Unit::mm), IsEmpty());
  EXPECT_THAT(likely_units(0.0, Unit::mm), IsEmpty());
}

}  // namespace
}  // namespace planish
