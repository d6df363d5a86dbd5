#include "pattern/pattern_hash.h"

#include <array>
#include <cmath>

#include "core/fnv_hash.h"

namespace planish {

namespace {

void add_thousandths(FnvHash& hash, double millimetres) {
  auto number = static_cast<std::uint64_t>(std::llround(1000.0 * millimetres));
  std::array<char, 8> bytes{};
  for (char& byte : bytes) {
    byte = static_cast<char>(number & 0xffU);
    number >>= 8U;
  }
  hash.add({bytes.data(), bytes.size()});
}

}  // namespace

std::uint64_t pattern_hash(std::span<const Vec2> positions) {
  FnvHash hash;
  for (const Vec2 p : positions) {
    add_thousandths(hash, p.x);
    add_thousandths(hash, p.y);
  }
  return hash.value();
}

}  // namespace planish
