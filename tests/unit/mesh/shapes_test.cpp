#include <cmath>

#include <planish/core/error.h>
#include <planish/measure/flattenability.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

namespace planish {
namespace {

TEST(Shapes, HaveAboutTheAskedNumberOfVertices) {
  for (const Shape& shape : shapes()) {
    for (const std::size_t n : {100U, 1000U, 20'000U}) {
      const auto made = static_cast<double>(make_shape(shape.name, n).positions.size());
      const auto asked = static_cast<double>(n);
      EXPECT_NEAR(made, asked, 2.0 * std::sqrt(asked)) << shape.name;
    }
  }
}

TEST(Shapes, AreFlattenableWhenTheySaySo) {
  for (const Shape& shape : shapes()) {
    for (const std::size_t n : {100U, 3000U}) {
      const TriMesh mesh = make_shape(shape.name, n);
      const double e_max = measure(Patch(mesh)).e_max;
      EXPECT_EQ(e_max < 1e-13, shape.flattenable) << shape.name << " " << e_max;
      EXPECT_EQ(e_max > 1e-4, !shape.flattenable) << shape.name << " " << e_max;
    }
  }
}

TEST(Shapes, AreBentAndUnevenLikeRealMeshes) {
  for (const Shape& shape : shapes()) {
    const TriMesh mesh = make_shape(shape.name, 2000);
    const Flattenability figures = measure(Patch(mesh));
    EXPECT_GT(figures.roughness, 0.3) << shape.name;
    EXPECT_GT(figures.min_angle, 0.1) << shape.name;
    EXPECT_LT(figures.min_angle, 0.6) << shape.name;
  }
}

TEST(Shapes, AreTheSameEveryTime) {
  for (const Shape& shape : shapes()) {
    EXPECT_EQ(make_shape(shape.name, 500).positions, make_shape(shape.name, 500).positions);
  }
}

TEST(Shapes, RefuseUnknownNamesAndSizesOutOfRange) {
  try {
    make_shape("sphere", 500);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::unknown_name);
    EXPECT_STREQ(error.what(),
                 "there is no sample called \"sphere\"; known are panel, saddle, dome, cylinder, "
                 "cone, tangent");
  }
  EXPECT_THROW(make_shape("dome", 99), Error);
  EXPECT_THROW(make_shape("dome", 10'000'001), Error);
}

}  // namespace
}  // namespace planish
