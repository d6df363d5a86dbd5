#pragma once

#include <atomic>

namespace planish::cli {

/// What the process around the program is like.
struct RunContext {
  bool err_is_terminal = false;                    ///< draws the progress line
  const std::atomic<bool>* interrupted = nullptr;  ///< set by a signal: stop, write nothing
};

inline constexpr int k_exit_done = 0;
inline constexpr int k_exit_failed = 1;  ///< input, output or unusable mesh
inline constexpr int k_exit_usage = 2;
inline constexpr int k_exit_target_missed = 3;
inline constexpr int k_exit_interrupted = 130;

}  // namespace planish::cli
