#include "core/math.h"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <mpfr.h>

namespace planish {
namespace {

/// A number in 200 digits of two.
class Exact {
 public:
  Exact() { mpfr_init2(value_, 200); }
  explicit Exact(double x) : Exact() { mpfr_set_d(value_, x, MPFR_RNDN); }
  Exact(const Exact&) = delete;
  Exact& operator=(const Exact&) = delete;
  ~Exact() { mpfr_clear(value_); }

  mpfr_ptr get() { return value_; }

  /// How far x is away, in units of the last place of the double that is nearest to this.
  double ulps_from(double x) {
    const double nearest = std::abs(mpfr_get_d(value_, MPFR_RNDN));
    mpfr_sub_d(value_, value_, x, MPFR_RNDN);
    const double unit = std::nextafter(nearest, std::numeric_limits<double>::infinity()) - nearest;
    return std::abs(mpfr_get_d(value_, MPFR_RNDN)) / unit;
  }

 private:
  mpfr_t value_;
};

class MathTest : public testing::Test {
 protected:
  double uniform(double low, double high) {
    return low + (high - low) * std::uniform_real_distribution<double>()(random_);
  }
  double of_any_size(double least_exponent, double most_exponent) {
    return (uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0) *
           std::pow(10.0, uniform(least_exponent, most_exponent));
  }

  using Function = std::function<double(double)>;
  using Reference = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

  void expect_within(double ulps, const Function& function, Reference reference,
                     const std::function<double()>& argument) {
    for (int i = 0; i < 20000; ++i) {
      const double x = argument();
      Exact exact(x);
      reference(exact.get(), exact.get(), MPFR_RNDN);
      ASSERT_LE(exact.ulps_from(function(x)), ulps) << "of " << x;
    }
  }

 private:
  std::mt19937_64 random_{1};
};

TEST_F(MathTest, SineAndCosineAreAccurateOfSmallAndLargeAngles) {
  for (const auto& argument : std::array<std::function<double()>, 3>{
           [this] { return uniform(-4.0, 4.0); },
           [this] { return of_any_size(-10.0, 6.0); },
           // Next to whole quarter turns most digits cancel.
           [this] { return std::floor(uniform(0.0, 600000.0)) * 1.5707963267948966; },
       }) {
    expect_within(1.1, math::sin, mpfr_sin, argument);
    expect_within(1.1, math::cos, mpfr_cos, argument);
    expect_within(2.5, math::tan, mpfr_tan, argument);
  }
}

TEST_F(MathTest, SineAndCosineOfWhatIsNoAngleAreNaN) {
  for (const double x : {1.1e6, -1e300, std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_TRUE(std::isnan(math::sin(x))) << x;
    EXPECT_TRUE(std::isnan(math::cos(x))) << x;
  }
  EXPECT_EQ(math::sin(0.0), 0.0);
  EXPECT_EQ(math::sin(5e-324), 5e-324);
  EXPECT_EQ(math::cos(5e-324), 1.0);
}

TEST_F(MathTest, InverseSineAndCosineAreAccurate) {
  expect_within(3.0, math::asin, mpfr_asin, [this] { return uniform(-1.0, 1.0); });
  expect_within(3.0, math::acos, mpfr_acos, [this] { return uniform(-1.0, 1.0); });
  expect_within(3.0, math::acos, mpfr_acos,
                [this] { return 1.0 + -std::abs(of_any_size(-16, 0)); });
  EXPECT_EQ(math::acos(1.0), 0.0);
  EXPECT_EQ(math::acos(-1.0), std::acos(-1.0));
  EXPECT_TRUE(std::isnan(math::asin(1.0000000000000002)));
}

TEST_F(MathTest, AngleOfAVectorIsAccurateInAllDirectionsAndAtAllSizes) {
  for (int i = 0; i < 50000; ++i) {
    const double size = std::abs(of_any_size(-290.0, 290.0));
    const double y = size * of_any_size(-8.0, 0.0), x = size * of_any_size(-8.0, 0.0);
    Exact exact_y(y), exact_x(x);
    mpfr_atan2(exact_y.get(), exact_y.get(), exact_x.get(), MPFR_RNDN);
    ASSERT_LE(exact_y.ulps_from(math::atan2(y, x)), 2.5) << y << ", " << x;
  }
}

TEST_F(MathTest, AngleOfAVectorOnAnAxisIsThatOfTheStandardLibrary) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double y : {0.0, -0.0, 1.0, -1.0, 1e-320, infinity, -infinity, 1.7e308}) {
    for (const double x : {0.0, -0.0, 1.0, -1.0, 1e-320, infinity, -infinity, 1.7e308}) {
      EXPECT_DOUBLE_EQ(math::atan2(y, x), std::atan2(y, x)) << y << ", " << x;
      EXPECT_EQ(std::signbit(math::atan2(y, x)), std::signbit(std::atan2(y, x)));
    }
  }
  EXPECT_TRUE(std::isnan(math::atan2(std::nan(""), 1.0)));
  EXPECT_TRUE(std::isnan(math::atan2(1.0, std::nan(""))));
}

TEST_F(MathTest, PowersOfEAndLogarithmsAreAccurate) {
  expect_within(1.5, math::exp, mpfr_exp, [this] { return uniform(-690.0, 709.0); });
  expect_within(1.5, math::exp, mpfr_exp, [this] { return of_any_size(-18.0, 0.0); });
  expect_within(1.5, math::log, mpfr_log, [this] { return std::abs(of_any_size(-307.0, 308.0)); });
  expect_within(1.5, math::log, mpfr_log, [this] { return uniform(0.5, 2.0); });
  expect_within(1.5, math::log, mpfr_log, [this] { return 1.0 + of_any_size(-16.0, -1.0); });
  expect_within(2.5, math::log10, mpfr_log10, [this] { return std::abs(of_any_size(-307, 308)); });
}

TEST_F(MathTest, PowersOfEAndLogarithmsHaveTheirLimits) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(math::exp(0.0), 1.0);
  EXPECT_EQ(math::exp(1e9), infinity);
  EXPECT_EQ(math::exp(-1e9), 0.0);
  EXPECT_EQ(math::log(1.0), 0.0);
  EXPECT_EQ(math::log(0.0), -infinity);
  EXPECT_EQ(math::log(infinity), infinity);
  EXPECT_TRUE(std::isnan(math::log(-1.0)));
  EXPECT_TRUE(std::isnan(math::exp(std::nan(""))));
}

TEST_F(MathTest, PowersAreAsAccurateAsTheirLogarithmIsLarge) {
  for (int i = 0; i < 20000; ++i) {
    const double x = std::abs(of_any_size(-12.0, 12.0)), y = uniform(-4.0, 4.0);
    Exact exact_x(x), exact_y(y);
    mpfr_pow(exact_x.get(), exact_x.get(), exact_y.get(), MPFR_RNDN);
    ASSERT_LE(exact_x.ulps_from(math::pow(x, y)), 4.0 + 2.0 * std::abs(y * std::log(x)));
  }
  EXPECT_EQ(math::pow(0.0, 2.0), 0.0);
  EXPECT_EQ(math::pow(0.0, 0.0), 1.0);
  EXPECT_EQ(math::pow(3.0, 0.0), 1.0);
}

TEST_F(MathTest, PowersOfTenAndTheirLogarithmsAreExact) {
  double power = 1.0;
  for (int n = 0; n <= 22; ++n, power *= 10.0) {
    EXPECT_EQ(math::power_of_ten(n), power);
    EXPECT_EQ(math::power_of_ten(-n), 1.0 / power);
    EXPECT_EQ(math::log10(power), n);
    EXPECT_EQ(math::log10(1.0 / power), -n);
  }
  EXPECT_DOUBLE_EQ(math::power_of_ten(300), 1e300);
  EXPECT_DOUBLE_EQ(math::power_of_ten(-300), 1e-300);
}

TEST_F(MathTest, LengthsAreAccurateAndNeitherOverflowNorVanish) {
  for (int i = 0; i < 50000; ++i) {
    const double size = std::abs(of_any_size(-300.0, 300.0));
    const double x = size * uniform(-1.0, 1.0), y = size * uniform(-1.0, 1.0);
    Exact exact_x(x), exact_y(y);
    mpfr_hypot(exact_x.get(), exact_x.get(), exact_y.get(), MPFR_RNDN);
    ASSERT_LE(exact_x.ulps_from(math::hypot(x, y)), 1.3) << x << ", " << y;
  }
  EXPECT_DOUBLE_EQ(math::hypot(2e300, 3e300, 6e300), 7e300);
  EXPECT_DOUBLE_EQ(math::hypot(2e-310, 3e-310, 6e-310), 7e-310);
  EXPECT_EQ(math::hypot(0.0, 0.0), 0.0);
}

TEST_F(MathTest, LengthsAndAnglesScaleByPowersOfTwoBitByBit) {
  for (int i = 0; i < 1000; ++i) {
    const double x = of_any_size(-3.0, 3.0), y = of_any_size(-3.0, 3.0);
    EXPECT_EQ(math::hypot(0x1p+900 * x, 0x1p+900 * y), 0x1p+900 * math::hypot(x, y));
    EXPECT_EQ(math::atan2(0x1p-900 * y, 0x1p-900 * x), math::atan2(y, x));
  }
}

}  // namespace
}  // namespace planish
