#pragma once

#include <atomic>
#include <ostream>
#include <span>
#include <string>

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

/// The planish program. Never throws.
/// @param args the command line without the program's name
/// @return the exit code
int run(std::span<const std::string> args, std::ostream& out, std::ostream& err,
        const RunContext& context = {});

}  // namespace planish::cli
