#include <planish/mesh/symmetry.h>

#include <gtest/gtest.h>

#include "support/test_files.h"

namespace planish {
namespace {

class SymmetryOfProducts : public WithProducts<> {};

TEST_F(SymmetryOfProducts, IsFoundWhereTheirMakersSayItIs) {
  for (const char* name : {"body", "car"}) {
    const Symmetry symmetry = find_symmetry(product(name));
    EXPECT_EQ(symmetry.plane.normal, (Vec3{1.0, 0.0, 0.0})) << name;
    EXPECT_EQ(symmetry.plane.offset, 0.0) << name;
    EXPECT_EQ(symmetry.largest, 0.0) << name;
    EXPECT_FALSE(symmetry.image.empty()) << name;
  }
  const Patch hull = product("hull");
  const Symmetry nearly = find_symmetry(hull);
  EXPECT_NO_THROW(require_symmetric(hull, nearly));
  EXPECT_GT(nearly.largest, 0.0);
  for (const char* name : {"shoe", "toy"}) {
    const Patch patch = product(name);
    EXPECT_THROW(require_symmetric(patch, find_symmetry(patch)), Error) << name;
  }
}

}  // namespace
}  // namespace planish
