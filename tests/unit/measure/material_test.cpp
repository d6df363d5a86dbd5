#include <cmath>
#include <string>
#include <utility>

#include <planish/core/error.h>
#include <planish/measure/material.h>

#include <gtest/gtest.h>

namespace planish {
namespace {

TEST(Material, HasTheStrainOfItsSource) {
  for (const auto& [name, strain] :
       {std::pair{"steel", 0.002}, std::pair{"aluminium", 0.002}, std::pair{"leather", 0.01},
        std::pair{"cotton", 0.05}, std::pair{"neoprene", 0.10}}) {
    const Material& material = material_named(name);
    EXPECT_EQ(material.stretch.usual.strain, strain) << name;
    EXPECT_EQ(material.compression.usual.strain, strain) << name << " gives alike";
    EXPECT_FALSE(material.stretch.largest || material.compression.largest) << name;
  }
}

TEST(Material, OfALastedUpperIsThatOfACone) {
  const Material& lasted = material_named("leather-lasted");
  const double radius = 12.5, height = 7.0, side = std::hypot(radius, height);
  EXPECT_LE(lasted.stretch.usual.strain, 1.0 - radius / side) << "a share of the form";
  EXPECT_GT(lasted.stretch.usual.strain, 0.9 * (1.0 - radius / side));
  EXPECT_EQ(lasted.compression.usual.strain, material_named("leather").compression.usual.strain);
}

TEST(Material, OfStretchYarnsIsAShareOfTheForm) {
  EXPECT_NEAR(material_named("stretch-woven").stretch.usual.strain, 0.12 / 1.12, 2e-4);
}

TEST(Material, IsFoundByTheNameThatItHas) {
  double last = 0.0;
  for (const Material& material : materials()) {
    EXPECT_EQ(&material_named(material.name), &material);
    EXPECT_GE(material.stretch.usual.strain, last) << "the least stretch first";
    last = material.stretch.usual.strain;
    EXPECT_FALSE(material.use.empty()) << material.name;
    for (const MaterialLimit* limit : {&material.stretch, &material.compression}) {
      EXPECT_FALSE(limit->usual.source.empty()) << material.name;
      if (!limit->largest) continue;
      EXPECT_FALSE(limit->largest->source.empty()) << material.name;
      EXPECT_GE(limit->largest->strain, limit->usual.strain) << material.name;
    }
  }
}

TEST(Material, NamesTheKnownOnesWhenAskedForAnother) {
  for (const std::string name : {"silk", "", "Leather"}) {
    try {
      material_named(name);
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::unknown_name);
      EXPECT_EQ(error.message(),
                "no material is called \"" + name +
                    "\"; known are steel, aluminium, leather, cotton, neoprene, stretch-woven, "
                    "leather-lasted");
    }
  }
}

}  // namespace
}  // namespace planish
