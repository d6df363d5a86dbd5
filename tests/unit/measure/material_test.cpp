#include <string>

#include <planish/core/error.h>
#include <planish/measure/material.h>

#include <gtest/gtest.h>

namespace planish {
namespace {

TEST(Material, HasTheStrainOfItsSource) {
  EXPECT_EQ(material_named("steel").max_strain, 0.002);
  EXPECT_EQ(material_named("leather").max_strain, 0.01);
  EXPECT_EQ(material_named("cotton").max_strain, 0.05);
  EXPECT_EQ(material_named("neoprene").max_strain, 0.10);
}

TEST(Material, IsFoundByTheNameThatItHas) {
  double last = 0.0;
  for (const Material& material : materials()) {
    EXPECT_EQ(material_named(material.name).max_strain, material.max_strain);
    EXPECT_GT(material.max_strain, last);  // stiffest first
    EXPECT_FALSE(material.source.empty());
    last = material.max_strain;
  }
}

TEST(Material, NamesTheKnownOnesWhenAskedForAnother) {
  for (const std::string name : {"silk", "", "Leather"}) {
    try {
      material_named(name);
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::unknown_name);
      EXPECT_EQ(error.message(), "no material is called \"" + name +
                                     "\"; known are steel, leather, cotton, neoprene");
    }
  }
}

}  // namespace
}  // namespace planish
