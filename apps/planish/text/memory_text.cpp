#include "text/memory_text.h"

#include <variant>

#include "shell/text.h"

namespace planish::cli {

namespace {

// docs/performance.md, "Dense patches": 5.9 kB a vertex at 195,000, 6.8 kB at a million; and what
// is left of the vertices with --remesh.
constexpr double k_bytes_a_vertex = 7'500.0, k_remeshed_bytes_a_vertex = 500.0;
constexpr std::size_t k_worth_a_note = 100'000;

std::string gigabytes(double bytes) {
  return digits(bytes / 1e9, 2) + " GB";
}

}  // namespace

std::string memory_text(const Method& method, std::size_t vertices, std::size_t available) {
  if (vertices < k_worth_a_note || !std::holds_alternative<Auto>(method)) return {};
  const auto count = static_cast<double>(vertices);
  const double needed = k_bytes_a_vertex * count;
  std::string text =
      std::to_string(vertices) + " vertices take about " + gigabytes(needed) + " of memory";
  if (available == 0 || static_cast<double>(available) > needed) return text;
  return text + ", and " + gigabytes(static_cast<double>(available)) +
         " are free: --remesh works on fewer vertices, keeps the border and takes about " +
         gigabytes(k_remeshed_bytes_a_vertex * count);
}

}  // namespace planish::cli
