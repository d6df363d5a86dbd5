#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "draw/image.h"

namespace planish {

namespace {

constexpr int k_samples = 2;  // per pixel and direction

struct Sample {
  float depth = -std::numeric_limits<float>::infinity();
  Color color = {};

  bool is_covered() const { return depth > -std::numeric_limits<float>::infinity(); }
};

struct Span {
  int from, to;  // without `to`
};

// The whole numbers i with low <= i + 0.5 <= high, and one more at each end against rounding, cut
// to [0, size). Also right where the bounds are too large for an int.
Span samples_between(double low, double high, int size) {
  const double from = std::clamp(std::floor(low - 0.5), 0.0, static_cast<double>(size));
  const double to = std::clamp(std::ceil(high - 0.5) + 1.0, 0.0, static_cast<double>(size));
  return {static_cast<int>(from), static_cast<int>(to)};
}

// The line through two corners. It is worked out from the smaller vertex number, so that the
// triangles on both sides of an edge agree to the last bit which side a sample is on and none falls
// between them.
struct Edge {
  Vec2 from, along;
  double sign;

  /// Twice the signed area of the triangle of both corners and p.
  double side(Vec2 p) const { return sign * cross(along, p - from); }
};

Edge edge_of(Index a, Vec3 at_a, Index b, Vec3 at_b) {
  const Vec2 p = {at_a.x, at_a.y}, q = {at_b.x, at_b.y};
  return a < b ? Edge{p, q - p, 1.0} : Edge{q, p - q, -1.0};
}

// A triangle as it is drawn: places in samples, edges across from their corner.
struct Facet {
  std::array<Vec3, 3> corners;
  std::array<Edge, 3> edges;
  std::array<Color, 3> colors;
  std::array<double, 3> brightness;
  double area;  // twice, with its sign

  bool is_drawn() const {
    const Vec3 sum = corners[0] + corners[1] + corners[2];  // finite only where all are
    return std::isfinite(sum.x + sum.y + sum.z) && std::isfinite(area) && area != 0.0;
  }
};

Facet facet_of(const ShadedSurface& surface, const std::array<Index, 3>& triangle) {
  Facet facet = {};
  for (int i = 0; i < 3; ++i) {
    const Vec3 p = surface.vertices[triangle[i]];
    facet.corners[i] = {k_samples * p.x, k_samples * p.y, p.z};
    facet.colors[i] = surface.colors[triangle[i]];
    facet.brightness[i] = surface.brightness[triangle[i]];
  }
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    facet.edges[i] = edge_of(triangle[j], facet.corners[j], triangle[k], facet.corners[k]);
  }
  facet.area = facet.edges[2].side({facet.corners[2].x, facet.corners[2].y});
  return facet;
}

Color shade(const Facet& facet, const std::array<double, 3>& weights) {
  double r = 0.0, g = 0.0, b = 0.0, brightness = 0.0;
  for (int i = 0; i < 3; ++i) {
    const Color color = facet.colors[i];
    r += weights[i] * color.r;
    g += weights[i] * color.g;
    b += weights[i] * color.b;
    brightness += weights[i] * facet.brightness[i];
  }
  const auto part = [&](double value) {
    return static_cast<std::uint8_t>(std::clamp(value * brightness + 0.5, 0.0, 255.0));
  };
  return {part(r), part(g), part(b)};
}

class Canvas {
 public:
  Canvas(int width, int height)
      : width_(k_samples * width),
        height_(k_samples * height),
        samples_(static_cast<std::size_t>(width_) * height_) {}

  void draw(const Facet& facet);
  Image smoothed(std::optional<Color> background) const;

 private:
  void draw_row(const Facet& facet, int row);
  Span columns_of(const Facet& facet, double y) const;

  int width_, height_;
  std::vector<Sample> samples_;
};

void Canvas::draw(const Facet& facet) {
  const auto& [p, q, r] = facet.corners;
  const auto [from, to] =
      samples_between(std::min({p.y, q.y, r.y}), std::max({p.y, q.y, r.y}), height_);
  for (int row = from; row < to; ++row)
    draw_row(facet, row);
}

// Where the line at y may be inside: between its crossings with the edges.
Span Canvas::columns_of(const Facet& facet, double y) const {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (int i = 0; i < 3; ++i) {
    const Vec3 a = facet.corners[i], b = facet.corners[(i + 1) % 3];
    if (std::max(a.y, b.y) < y || std::min(a.y, b.y) > y) continue;
    const double share = a.y == b.y ? 0.0 : (y - a.y) / (b.y - a.y);
    const double x = a.x + share * (b.x - a.x);
    low = std::min({low, x, a.y == b.y ? b.x : x});
    high = std::max({high, x, a.y == b.y ? b.x : x});
  }
  return samples_between(low, high, width_);
}

void Canvas::draw_row(const Facet& facet, int row) {
  const auto& [p, q, r] = facet.corners;
  const auto& [across_p, across_q, across_r] = facet.edges;
  const double y = row + 0.5;
  const auto [from, to] = columns_of(facet, y);
  Sample* const samples = samples_.data() + static_cast<std::size_t>(row) * width_;
  for (int column = from; column < to; ++column) {
    const Vec2 place = {column + 0.5, y};
    const std::array weights = {across_p.side(place) / facet.area,
                                across_q.side(place) / facet.area,
                                across_r.side(place) / facet.area};
    const auto [u, v, w] = weights;
    if (!(u >= 0.0 && v >= 0.0 && w >= 0.0)) continue;
    const auto depth = static_cast<float>(u * p.z + v * q.z + w * r.z);
    if (depth > samples[column].depth) samples[column] = {depth, shade(facet, weights)};
  }
}

Image Canvas::smoothed(std::optional<Color> background) const {
  Image image{width_ / k_samples, height_ / k_samples, {}, {}};
  for (int row = 0; row < height_; row += k_samples) {
    for (int column = 0; column < width_; column += k_samples) {
      int r = 0, g = 0, b = 0, count = 0, covered = 0;
      for (int i = 0; i < k_samples * k_samples; ++i) {
        const auto place = static_cast<std::size_t>(row + i / k_samples) * width_ + column;
        const Sample& sample = samples_[place + i % k_samples];
        if (!sample.is_covered() && !background) continue;
        const Color color = sample.is_covered() ? sample.color : *background;
        r += color.r, g += color.g, b += color.b, ++count;
        covered += sample.is_covered() ? 1 : 0;
      }
      const auto mean = [&](int sum) {
        return static_cast<std::uint8_t>(count > 0 ? (sum + count / 2) / count : 0);
      };
      image.pixels.push_back({mean(r), mean(g), mean(b)});
      if (!background) {
        const int alpha = covered * 255 / (k_samples * k_samples);
        image.alpha.push_back(static_cast<std::uint8_t>(alpha));
      }
    }
  }
  return image;
}

}  // namespace

Image render(const ShadedSurface& surface, int width, int height, std::optional<Color> background) {
  Canvas canvas(width, height);
  for (const auto& triangle : surface.triangles) {
    const Facet facet = facet_of(surface, triangle);
    if (facet.is_drawn()) canvas.draw(facet);
  }
  return canvas.smoothed(background);
}

}  // namespace planish
