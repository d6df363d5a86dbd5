#include "mesh/polygon/diagonal.h"

#include <algorithm>
#include <cstddef>

namespace planish {

namespace {

/// The square of the difference of angles that decides nothing, radians, of a quad of equal sides.
constexpr double k_tie = 1e-6;

/// The sine of the sum of two opposite angles, times the lengths of the four sides.
double sine_of_sum(const std::array<Vec2, 4>& quad, std::size_t corner) {
  const auto angle = [&](std::size_t at) {  // as a complex number: no arctangent is needed
    const Vec2 on = quad[(at + 1) % 4] - quad[at % 4];
    const Vec2 back = quad[(at + 3) % 4] - quad[at % 4];
    return Vec2{dot(on, back), cross(on, back)};
  };
  const Vec2 a = angle(corner), b = angle(corner + 2);
  return a.x * b.y + a.y * b.x;
}

/// The half of a number's digits that counts most (Dekker 1971).
double upper_half(double x) {
  const double shifted = 134217729.0 * x;  // 2^27 + 1
  return shifted - (shifted - x);
}

/// What rounding left of a product, exactly.
double rest_of_product(double a, double b, double rounded) {
  const double a_high = upper_half(a), b_high = upper_half(b);
  const double a_low = a - a_high, b_low = b - b_high;
  return ((a_high * b_high - rounded) + a_high * b_low + a_low * b_high) + a_low * b_low;
}

}  // namespace

int side_of(Vec2 a, Vec2 b, Vec2 c) {
  const Vec2 along = b - a, to = c - a;  // no digit is lost
  const double left = along.x * to.y, right = along.y * to.x;
  // Rounding keeps the order of what differs once rounded; where roundings are equal the remainders
  // decide.
  if (left != right) return left > right ? 1 : -1;
  const double left_rest = rest_of_product(along.x, to.y, left);
  const double right_rest = rest_of_product(along.y, to.x, right);
  return left_rest == right_rest ? 0 : left_rest > right_rest ? 1 : -1;
}

Diagonal better_diagonal(const std::array<Vec2, 4>& quad) {
  // The angles of a quad sum to a full turn: one of the sines is the other with another sign.
  const double difference = sine_of_sum(quad, 1) - sine_of_sum(quad, 0);
  double shortest = dot(quad[0] - quad[3], quad[0] - quad[3]);
  double longest = shortest, product = shortest;
  for (std::size_t k = 0; k < 3; ++k) {
    const double side = dot(quad[k + 1] - quad[k], quad[k + 1] - quad[k]);
    shortest = std::min(shortest, side);
    longest = std::max(longest, side);
    product *= side;
  }
  // Both sides of the comparison are squares; angles of a slender quad are that much smaller.
  if (0.25 * difference * difference * longest <= k_tie * shortest * product) {
    return Diagonal::either;
  }
  return difference > 0.0 ? Diagonal::through_first : Diagonal::through_second;
}

}  // namespace planish
