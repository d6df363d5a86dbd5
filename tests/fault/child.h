#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace planish::fault {

/// How a process ended.
struct Ended {
  int exit_code = -1;  ///< -1 where a signal ended it
  int signal = 0;      ///< 0 where it ended by itself
  std::string out, err;
};

/// Says it all in a line, for messages of tests.
std::string told(const Ended& ended);

/// What a process may take; 0 for no limit.
struct Limits {
  std::size_t memory = 0;     ///< bytes of address space
  unsigned cpu_seconds = 0;   ///< the system ends it with SIGXCPU then
  std::size_t file_size = 0;  ///< bytes; a write beyond fails, as on a full disk
};

/// Where the standard files of a process go. Empty: they are kept and come back as text.
struct Standard {
  std::string out = {};  ///< path; "-" for closed, "|" for a pipe that nobody reads
  std::string err = {};
};

/// The instructions that the program needs, as callgrind counts them; 0 where it cannot.
std::uint64_t instructions_of(const std::vector<std::string>& args);

/// How often the program calls a function, as callgrind counts it; 0 where it cannot.
/// @param function as the demangled name begins, as in "planish::inspect("
std::uint64_t calls_of(const std::string& function, const std::vector<std::string>& args);

/// The planish program, in a process of its own.
Ended run_program(const std::vector<std::string>& args, const Limits& limits = {},
                  const Standard& standard = {});

/// The same, not waited for. What it says is dropped.
class Running {
 public:
  explicit Running(const std::vector<std::string>& args);
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  void send(int signal) const;
  Ended wait();

 private:
  pid_t id_ = -1;
};

using Files = std::map<std::string, std::string>;

/// Files below a folder, path from there -> content; folders are there with a slash behind them,
/// symbolic links with "-> " and where they lead.
Files contents(const std::filesystem::path& folder);

/// Whether limits of memory can be set: not with sanitizers, which reserve much.
bool can_limit_memory();

}  // namespace planish::fault
