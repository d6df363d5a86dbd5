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

class Canvas {
 public:
  Canvas(const ShadedSurface& surface, int width, int height)
      : surface_(surface),
        width_(k_samples * width),
        height_(k_samples * height),
        samples_(static_cast<std::size_t>(width_) * height_) {}

  void draw(const std::array<Index, 3>& triangle);
  Image smoothed(std::optional<Color> background) const;

 private:
  Vec3 corner(Index v) const {
    const Vec3 p = surface_.vertices[v];
    return {k_samples * p.x, k_samples * p.y, p.z};
  }

  // Twice the signed area of the triangle a, b, p. It is worked out from the smaller vertex number,
  // so that the triangles on both sides of an edge agree to the last bit which side p is on and no
  // sample falls between them.
  double side(Index a, Index b, Vec2 p) const {
    if (a > b) return -side(b, a, p);
    const Vec3 from = corner(a), to = corner(b);
    return cross(Vec2{to.x - from.x, to.y - from.y}, Vec2{p.x - from.x, p.y - from.y});
  }

  void draw_row(const std::array<Index, 3>& triangle, int row, double area);
  Color shade(const std::array<Index, 3>& triangle, const std::array<double, 3>& weights) const;

  const ShadedSurface& surface_;
  int width_, height_;
  std::vector<Sample> samples_;
};

void Canvas::draw(const std::array<Index, 3>& triangle) {
  const auto [a, b, c] = triangle;
  const Vec3 p = corner(a), q = corner(b), r = corner(c);
  const Vec3 sum = p + q + r;  // finite only where all are
  const double area = side(a, b, {r.x, r.y});
  if (!std::isfinite(sum.x + sum.y + sum.z) || !std::isfinite(area) || area == 0.0) return;
  const auto [from, to] =
      samples_between(std::min({p.y, q.y, r.y}), std::max({p.y, q.y, r.y}), height_);
  for (int row = from; row < to; ++row)
    draw_row(triangle, row, area);
}

void Canvas::draw_row(const std::array<Index, 3>& triangle, int row, double area) {
  const double y = row + 0.5;
  // Where the row may be inside: between the crossings of the row's line with the edges.
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (int i = 0; i < 3; ++i) {
    const Vec3 a = corner(triangle[i]), b = corner(triangle[(i + 1) % 3]);
    if (std::max(a.y, b.y) < y || std::min(a.y, b.y) > y) continue;
    const double share = a.y == b.y ? 0.0 : (y - a.y) / (b.y - a.y);
    const double x = a.x + share * (b.x - a.x);
    low = std::min({low, x, a.y == b.y ? b.x : x});
    high = std::max({high, x, a.y == b.y ? b.x : x});
  }
  const auto [from, to] = samples_between(low, high, width_);
  for (int column = from; column < to; ++column) {
    const Vec2 place = {column + 0.5, y};
    std::array<double, 3> weights;
    for (int i = 0; i < 3; ++i) {
      weights[i] = side(triangle[(i + 1) % 3], triangle[(i + 2) % 3], place) / area;
    }
    if (!(std::min({weights[0], weights[1], weights[2]}) >= 0.0)) continue;
    double depth = 0.0;
    for (int i = 0; i < 3; ++i)
      depth += weights[i] * surface_.vertices[triangle[i]].z;
    Sample& sample = samples_[static_cast<std::size_t>(row) * width_ + column];
    const auto narrow = static_cast<float>(depth);
    if (narrow > sample.depth) sample = {narrow, shade(triangle, weights)};
  }
}

Color Canvas::shade(const std::array<Index, 3>& triangle,
                    const std::array<double, 3>& weights) const {
  double r = 0.0, g = 0.0, b = 0.0, brightness = 0.0;
  for (int i = 0; i < 3; ++i) {
    const Color color = surface_.colors[triangle[i]];
    r += weights[i] * color.r;
    g += weights[i] * color.g;
    b += weights[i] * color.b;
    brightness += weights[i] * surface_.brightness[triangle[i]];
  }
  const auto part = [&](double value) {
    return static_cast<std::uint8_t>(std::clamp(value * brightness + 0.5, 0.0, 255.0));
  };
  return {part(r), part(g), part(b)};
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
  Canvas canvas(surface, width, height);
  for (const auto& triangle : surface.triangles)
    canvas.draw(triangle);
  return canvas.smoothed(background);
}

}  // namespace planish
