#include "text/remesh_offer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <utility>

#include <planish/evolve/remesh.h>

#include "shell/text.h"

namespace planish::cli {

namespace {

/// "40 s", "4 min"
std::string about(double seconds) {
  constexpr double most_seconds = 100.0, tens = 10.0;
  if (seconds < tens) return fixed(std::max(seconds, 1.0), 0) + " s";
  if (seconds < most_seconds) return fixed(tens * std::round(seconds / tens), 0) + " s";
  return fixed(seconds / 60.0, 0) + " min";
}

}  // namespace

std::optional<std::string> remesh_offer(double seconds, double share, std::size_t vertices,
                                        std::size_t remeshed) {
  constexpr double least_seconds = 3.0, least_share = 0.01;  // to tell from
  constexpr double long_run = 60.0, much_shorter = 3.0;
  // Measured: 60,000 vertices with a limit take 22 to 30 times as long as 5,000.
  constexpr double growth = 1.25;
  if (seconds < least_seconds || share < least_share || remeshed == 0) return {};
  const double whole = seconds / share;
  const double fewer =
      std::pow(static_cast<double>(vertices) / static_cast<double>(remeshed), growth);
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
