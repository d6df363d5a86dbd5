#pragma once

#include <filesystem>
#include <iosfwd>
#include <span>
#include <string>

#include "shell/run_context.h"

// The program in a window that the system made for it, because somebody clicked on its icon or
// dropped files onto it. The window closes at the end, so what it says last has to be read first.

namespace planish::cli {

/// What that window has.
struct OwnWindow {
  std::istream& in;
  std::ostream& out;
  std::ostream& err;
  /// open_document() of host.h
  std::string (*open)(const std::filesystem::path& path);
};

/// Whether the words are nothing but full names of files or folders that are there.
bool are_dropped(std::span<const std::string> words);

/// - Without words: says what to do, and waits for Enter.
/// - Dropped files are flattened, into a folder beside the first one that has its name and
///   "-pattern", of several files "-and-more-pattern", and the page of the report is opened. Asks
///   for the unit where the meshes have no usual size in millimetres. After a failure waits for
///   Enter.
/// - All else is done as in any other window, without waiting: a script might have asked for it.
/// @return the exit code of the program
int run_in_own_window(std::span<const std::string> words, const OwnWindow& window,
                      const RunContext& context);

}  // namespace planish::cli
