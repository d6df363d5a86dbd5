#include "core/likely_units.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(LikelyUnits, AreThoseThatMakeTheSizeUsual) {
  EXPECT_THAT(likely_units(0.6, Unit::mm), ElementsAre(Unit::m, Unit::dm)) << "a jacket in metres";
  EXPECT_THAT(likely_units(60.0, Unit::m), ElementsAre(Unit::cm, Unit::in, Unit::mm));
  EXPECT_THAT(likely_units(600.0, Unit::m), ElementsAre(Unit::mm));
}

TEST(LikelyUnits, AreNoneWhereNoneFits) {
  EXPECT_THAT(likely_units(1e-6, Unit::mm), IsEmpty());
  EXPECT_THAT(likely_units(1e9, Unit::mm), IsEmpty());
  EXPECT_THAT(likely_units(0.0, Unit::mm), IsEmpty());
}

}  // namespace
}  // namespace planish
