#pragma once

#include <exception>
#include <functional>
#include <string_view>

namespace planish {

/// How far a long job is.
struct Progress {
  std::string_view stage;         ///< "measuring", "evolving", "unfolding", ...
  double share = 0.0;             ///< of the whole job, 0 to 1; never less than before
  std::string_view subject = {};  ///< of several: the method or patch that the work is on
};

/// What a long job is run with.
struct Context {
  unsigned threads = 0;  ///< 0: all processors it may use; results never depend on it
  /// Called now and then, from the calling thread. What it throws ends the job and is passed on.
  std::function<void(const Progress&)> on_progress = {};
  /// Asked often, from any thread; true ends the job, which throws Cancelled.
  std::function<bool()> is_cancelled = {};
};

/// Thrown by a job that Context::is_cancelled ended. No part of its result remains.
class Cancelled : public std::exception {
 public:
  /// "cancelled"
  const char* what() const noexcept override { return "cancelled"; }
};

}  // namespace planish
