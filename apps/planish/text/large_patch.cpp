#include "text/large_patch.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <utility>
#include <variant>

#include <planish/evolve/remesh.h>

#include "shell/text.h"

namespace planish::cli {

namespace {

// docs/performance.md, "What to expect": 5.9 kB a vertex at 195,000, 6.8 kB at a million; and what
// is left of the vertices with --remesh.
constexpr double k_bytes_a_vertex = 7'500.0, k_remeshed_bytes_a_vertex = 500.0;
constexpr std::size_t k_worth_a_note = 100'000;

std::string gigabytes(double bytes) {
  return digits(bytes / 1e9, 2) + " GB";
}

/// "40 s", "4 min"
std::string about(double seconds) {
  constexpr double most_seconds = 100.0, tens = 10.0;
  if (seconds < tens) return fixed(std::max(seconds, 1.0), 0) + " s";
  if (seconds < most_seconds) return fixed(tens * std::round(seconds / tens), 0) + " s";
  return fixed(seconds / 60.0, 0) + " min";
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

std::optional<std::string> remesh_offer(double seconds, double share, std::size_t vertices,
                                        std::size_t remeshed) {
  constexpr double least_seconds = 3.0, least_share = 0.01;  // to tell from
  constexpr double long_run = 60.0, much_shorter = 3.0;
  if (seconds < least_seconds || share < least_share || remeshed == 0) return {};
  const double whole = seconds / share;
  // Measured: 60,000 vertices with a limit take 22 to 30 times as long as 5,000.
  const double times = static_cast<double>(vertices) / static_cast<double>(remeshed);
  const double fewer = times * std::sqrt(std::sqrt(times));
  if (whole < long_run || fewer < much_shorter) return {};
  return "this will take about " + about(whole) + "; with --remesh, which works on " +
         std::to_string(remeshed) + " of the " + std::to_string(vertices) + " vertices, about " +
         about(whole / fewer) + " (Ctrl-C ends this run, and nothing is written)";
}

Context offering_remesh(Context context, const Patch& patch, Session& session) {
  using Clock = std::chrono::steady_clock;
  context.on_progress = [started = Clock::now(), is_said = std::make_shared<bool>(false),
                         vertices = patch.vertex_count(), remeshed = vertices_of_remeshed(patch),
                         &session,
                         next = std::move(context.on_progress)](const Progress& progress) {
    const std::chrono::duration<double> passed = Clock::now() - started;
    if (!*is_said) {
      if (const auto offer = remesh_offer(passed.count(), progress.share, vertices, remeshed)) {
        session.note(*offer);
        *is_said = true;  // of all copies
      }
    }
    if (next) next(progress);
  };
  return context;
}

}  // namespace planish::cli
