#include <cmath>

#include <planish/pattern/pattern_hash.h>

namespace planish {

namespace {

constexpr std::uint64_t k_offset = 0xcbf29ce484222325U, k_prime = 0x100000001b3U;

std::uint64_t with_number(std::uint64_t hash, double millimetres) {
  auto bytes = static_cast<std::uint64_t>(std::llround(1000.0 * millimetres));
  for (int i = 0; i < 8; ++i) {
    hash = (hash ^ (bytes & 0xffU)) * k_prime;
    bytes >>= 8U;
  }
  return hash;
}

}  // namespace

std::uint64_t pattern_hash(std::span<const Vec2> positions) {
  std::uint64_t hash = k_offset;
  for (const Vec2 p : positions)
    hash = with_number(with_number(hash, p.x), p.y);
  return hash;
}

std::string hash_text(std::uint64_t hash) {
  std::string text(16, '0');
  for (auto digit = text.rbegin(); digit != text.rend(); ++digit) {
    *digit = "0123456789abcdef"[hash & 0xfU];
    hash >>= 4U;
  }
  return text;
}

}  // namespace planish
