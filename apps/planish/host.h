#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "run.h"

// What the system around the program has to be asked for. One source for each system: host_*.cpp.

namespace planish::cli {

/// Gets the process ready and tells what it is like. To be called once, before anything else.
///
/// - Memory that is freed stays with the program. Steps take and free the same again and again:
///   given back to the system in between, it has to be cleared again each time, which was a sixth
///   of the time of a patch of 4,000 vertices.
/// - A file that is opened does not become one of the three standard ones, where messages would go
///   into it.
/// - The first request to end, as by Ctrl-C, is told in the context; the second one ends the
///   program at once.
/// - A reader that went away and a file that may not grow are failures like others.
///
/// On Windows standard output has to be set to binary as well, and a terminal is what has a console
/// mode: isatty() is true for NUL.
RunContext prepare_process();

/// The words of the command line behind the program's name, in UTF-8.
/// @param argc,argv of main(); on Windows they have lost letters, and the system is asked instead
std::vector<std::string> command_words(int argc, char** argv);

/// Says something on standard error and ends the program, without destructors and without memory.
[[noreturn]] void end_at_once(std::string_view message, int exit_code) noexcept;

}  // namespace planish::cli
