#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include <planish/core/context.h>

namespace planish::cli {

/// What a bug report has to say of the system.
struct SystemFacts {
  std::string name = "not known";  ///< "Linux 6.1.0 x86_64, glibc 2.36"
  std::string processor;           ///< the maker's name for it; empty where it is not known
  std::string document_opener;     ///< what open_document() starts; empty where it is missing
};

/// What the process around the program is like.
struct RunContext {
  bool err_is_terminal = false;                    ///< draws the progress line
  const std::atomic<bool>* interrupted = nullptr;  ///< set by a signal: stop, write nothing
  /// Those of host.h; null where the program runs inside another process.
  std::string (*open_document)(const std::filesystem::path&) = nullptr;
  SystemFacts (*system_facts)() = nullptr;
  std::string (*run_program)(const std::vector<std::string>& words,
                             const std::function<bool()>& is_cancelled) = nullptr;
  /// Gets the progress of jobs that have a line of progress, from their thread; may be empty.
  std::function<void(const Progress&)> on_progress = {};
  std::istream* in = nullptr;  ///< standard input; null where there is none
  /// Gets each line of results that a run prints while it works, without its end; may be empty.
  std::function<void(std::string_view line)> on_line = {};
};

inline constexpr int k_exit_done = 0;
inline constexpr int k_exit_failed = 1;  ///< input, output or unusable mesh
inline constexpr int k_exit_usage = 2;
inline constexpr int k_exit_target_missed = 3;
inline constexpr int k_exit_interrupted = 130;

}  // namespace planish::cli
