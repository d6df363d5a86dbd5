#include "report/page/packed_array.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "draw/base64.h"

namespace planish {

namespace {

constexpr double k_last_place = 65535.0;

template <class Number>
void append_bytes(std::string& bytes, Number number) {
  for (std::size_t i = 0; i < sizeof number; ++i)
    bytes += static_cast<char>(number >> (8 * i) & 0xFFU);
}

std::array<double, 3> coordinates(Vec3 p) {
  return {p.x, p.y, p.z};
}

std::array<double, 2> coordinates(Vec2 p) {
  return {p.x, p.y};
}

template <class Lists>
PackedPoints pack(const Lists& lists, std::size_t axes) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  PackedPoints packed{std::vector(axes, infinity), std::vector(axes, 0.0), {}};
  std::vector<double> high(axes, -infinity);
  for (const auto& points : lists) {
    for (const auto& point : points) {
      const auto place = coordinates(point);
      for (std::size_t a = 0; a < axes; ++a) {
        if (!std::isfinite(place[a])) continue;
        packed.low[a] = std::min(packed.low[a], place[a]);
        high[a] = std::max(high[a], place[a]);
      }
    }
  }
  for (std::size_t a = 0; a < axes; ++a) {
    if (!(packed.low[a] <= high[a])) packed.low[a] = high[a] = 0.0;
    // Divided first: the extent itself may overflow.
    packed.step[a] = high[a] / k_last_place - packed.low[a] / k_last_place;
  }
  for (const auto& points : lists) {
    std::string bytes;
    bytes.reserve(2 * axes * points.size());
    for (const auto& point : points) {
      const auto place = coordinates(point);
      for (std::size_t a = 0; a < axes; ++a) {
        const double steps =
            packed.step[a] > 0.0 ? (place[a] - packed.low[a]) / packed.step[a] : 0.0;
        const double whole =
            std::isfinite(steps) ? std::clamp(std::round(steps), 0.0, k_last_place) : 0.0;
        append_bytes(bytes, static_cast<std::uint16_t>(whole));
      }
    }
    packed.data.push_back(base64(bytes));
  }
  return packed;
}

}  // namespace

std::string packed_floats(std::span<const double> values) {
  std::string bytes;
  bytes.reserve(4 * values.size());
  for (const double value : values)
    append_bytes(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
  return base64(bytes);
}

std::string packed_numbers(std::span<const Index> values) {
  std::string bytes;
  bytes.reserve(4 * values.size());
  for (const Index value : values)
    append_bytes(bytes, value);
  return base64(bytes);
}

std::string packed_small_numbers(std::span<const Index> values) {
  std::string bytes;
  bytes.reserve(2 * values.size());
  for (const Index value : values)
    append_bytes(bytes, static_cast<std::uint16_t>(value));
  return base64(bytes);
}

PackedPoints packed_points(std::span<const std::vector<Vec3>> lists) {
  return pack(lists, 3);
}

PackedPoints packed_points(std::span<const Vec2> points) {
  return pack(std::array{points}, 2);
}

}  // namespace planish
