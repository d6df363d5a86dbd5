// Terms of layouts in the plane.

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/math.h"
#include "energy/edge_bounds.h"
#include "energy/strain_price.h"
#include "energy/turn_bending.h"
#include "support/meshes.h"

namespace planish {
namespace {

constexpr double k_step = 1e-6;

/// A closed line of six vertices, each a little elsewhere than on a circle.
std::vector<Vec2> some_line(unsigned seed) {
  meshes::Random random(seed);
  std::vector<Vec2> flat;
  for (int k = 0; k < 6; ++k)
    flat.push_back({math::cos(k) + 0.2 * random.number(), math::sin(k) + 0.2 * random.number()});
  return flat;
}

/// The difference quotient of a function of positions by those of a vertex; nothing moves in the
/// end.
template <class Function>
Vec2 slope_of(const Function& function, Vec2& at) {
  const auto by = [&](double& x) {
    const double middle = x;
    x = middle + k_step;
    const double above = function();
    x = middle - k_step;
    const double below = function();
    x = middle;
    return (above - below) / (2.0 * k_step);
  };
  return {by(at.x), by(at.y)};
}

void expect_near(Vec2 a, Vec2 b, double most) {
  EXPECT_NEAR(a.x, b.x, most);
  EXPECT_NEAR(a.y, b.y, most);
}

/// That second derivatives are those of the gradient, by the second end of an edge.
template <class TermOf>
void expect_second_derivatives(const TermOf& term_of, Vec2& at, double most) {
  const EdgeTerm term = term_of();
  expect_near({term.xx, term.xy}, slope_of([&] { return term_of().gradient.x; }, at), most);
  expect_near({term.xy, term.yy}, slope_of([&] { return term_of().gradient.y; }, at), most);
}

void expect_positive(const EdgeTerm& term) {
  EXPECT_GE(term.xx, 0.0);
  EXPECT_GE(term.xx * term.yy - term.xy * term.xy, -1e-12 * term.xx * term.yy);
}

TurnBending around(const std::vector<Vec2>& like) {
  std::vector<TurnBending::Turn> turns;
  for (Index k = 0; k < like.size(); ++k)
    turns.push_back({{k, (k + 1) % 6, (k + 2) % 6}, 0.5 + 0.1 * k});
  return {turns, like};
}

TEST(TurnBending, IsNothingWhereALineTurnsAsItWould) {
  const std::vector<Vec2> line = some_line(1);
  const TurnBending bend = around(line);
  EXPECT_EQ(bend.value(line), 0.0);
  std::vector<Vec2> turned = line;
  const double c = math::cos(2.0), s = math::sin(2.0);
  for (Vec2& p : turned)
    p = 3.0 * Vec2{c * p.x - s * p.y, s * p.x + c * p.y};
  EXPECT_NEAR(bend.value(turned), 0.0, 1e-25);
  EXPECT_GT(bend.value(some_line(2)), 1e-3);
}

TEST(TurnBending, HasTheDerivativesOfDifferenceQuotients) {
  const TurnBending bend = around(some_line(1));
  std::vector<Vec2> flat = some_line(2);
  std::vector<Vec2> gradient(flat.size());
  for (std::size_t k = 0; k < bend.turns().size(); ++k) {
    const Summand<3, Vec2> part = bend.summand(k, flat), twice = bend.summand(k, flat, 2.0);
    EXPECT_EQ(part.second, 2.0 * bend.turns()[k].weight);
    EXPECT_EQ(twice.first, 2.0 * part.first);
    for (std::size_t i = 0; i < 3; ++i) {
      gradient[part.vertices[i]] = gradient[part.vertices[i]] + part.first * part.gradient[i];
      // f' is f'' times the change of the turn, so its slope that times the turn's.
      const auto first = [&] { return bend.summand(k, flat).first; };
      expect_near(part.second * part.gradient[i], slope_of(first, flat[part.vertices[i]]), 1e-8);
    }
  }
  const auto value = [&] { return bend.value(flat); };
  for (std::size_t v = 0; v < flat.size(); ++v)
    expect_near(gradient[v], slope_of(value, flat[v]), 1e-8);
}

TEST(Price, HasTheSlopeAndCurvatureOfItsValue) {
  constexpr double h = 1e-5;
  for (Price (*price)(double) : {peak_price, square_price}) {
    for (const double x : {-3.0, -1.2, -0.7, 0.3, 0.9, 1.1, 4.0}) {
      const double slope = (price(x + h).value - price(x - h).value) / (2.0 * h);
      const double curvature = (price(x + h).slope - price(x - h).slope) / (2.0 * h);
      EXPECT_NEAR(price(x).slope, slope, 1e-7 * (1.0 + std::abs(slope))) << x;
      EXPECT_NEAR(price(x).curvature, curvature, 1e-7 * (1.0 + curvature)) << x;
    }
  }
}

TEST(Price, GoesOnSmoothlyWhereItIsOne) {
  const Price below = peak_price(std::nextafter(1.0, 0.0)), at = peak_price(1.0);
  EXPECT_NEAR(below.value, at.value, 1e-12);
  EXPECT_NEAR(below.slope, at.slope, 1e-12);
  EXPECT_NEAR(below.curvature, at.curvature, 1e-12);
  EXPECT_DOUBLE_EQ(peak_price(0.5).value, 1.0 / 256.0) << "x^8";
}

TEST(StrainPrice, HasTheDerivativesOfDifferenceQuotients) {
  // The first is too long, so all of its second derivative is there; the second is too short.
  const std::vector<FlatEdge> edges = {{0, 1, 0.8, 0.3}, {2, 1, 1.6, 0.7}};
  std::vector<Vec2> flat = {{0.0, 0.0}, {0.6, 0.8}, {-0.3, 0.3}};
  for (Price (*price_of)(double) : {peak_price, square_price}) {
    const StrainPrice price{edges, 0.5, *price_of};
    const Vec2 first = price.term(edges[0], flat).gradient,
               second = price.term(edges[1], flat).gradient;
    const auto value = [&] { return price.value(flat); };
    expect_near(-1.0 * first, slope_of(value, flat[0]), 1e-8);
    expect_near(first + second, slope_of(value, flat[1]), 1e-8);
    expect_near(2.0 * first, price.term(edges[0], flat, 2.0).gradient, 1e-15);
    expect_second_derivatives([&] { return price.term(edges[0], flat); }, flat[1], 1e-7);
    for (const FlatEdge& edge : edges)
      expect_positive(price.term(edge, flat));
  }
}

/// The barrier of an edge of length 0.8, with multipliers as on its central path.
struct Barrier {
  static constexpr double mu = 0.03;
  FlatEdge edge{0, 1, 0.8, 1.0};
  EdgeBounds bounds;
  double scale = 1.2;
  std::vector<Vec2> flat = {{0.1, -0.1}, {0.6, 0.5}};

  double strain() const { return LaidEdge(edge, flat).strain; }
  Bound bound(double slack) const { return {slack, mu / slack}; }
  double value() const {
    return -mu * (std::log(scale * bounds.longer - strain()) +
                  std::log(scale * bounds.shorter + strain()));
  }
  BarrierTerm term() const {
    return {edge,
            LaidEdge(edge, flat),
            bounds,
            bound(scale * bounds.longer - strain()),
            bound(scale * bounds.shorter + strain()),
            mu};
  }
  double by_scale(double h) {
    scale += h;
    const double value = this->value();
    scale -= h;
    return value;
  }
};

TEST(BarrierTerm, HasTheDerivativesOfDifferenceQuotients) {
  for (const EdgeBounds& bounds : {EdgeBounds{0.05, 0.3}, EdgeBounds{0.3, 0.1}}) {
    Barrier barrier{.bounds = bounds};
    const BarrierTerm term = barrier.term();
    expect_near(term.ends.gradient, slope_of([&] { return barrier.value(); }, barrier.flat[1]),
                1e-8);
    expect_near(term.mixed, slope_of([&] { return barrier.term().scale; }, barrier.flat[1]), 1e-7);
    EXPECT_NEAR(term.scale, (barrier.by_scale(k_step) - barrier.by_scale(-k_step)) / (2.0 * k_step),
                1e-8);
    Barrier more = barrier, less = barrier;
    more.scale += k_step, less.scale -= k_step;
    EXPECT_NEAR(term.scale_twice, (more.term().scale - less.term().scale) / (2.0 * k_step), 1e-6);
    expect_positive(term.ends);
    // Where it pulls the edge shorter, nothing of the second derivative is left out.
    if (bounds.longer < bounds.shorter)
      expect_second_derivatives([&] { return barrier.term().ends; }, barrier.flat[1], 1e-6);
  }
}

}  // namespace
}  // namespace planish
