#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "shell/run_context.h"

// What the system around the program has to be asked for. One source for each system: host_*.cpp.

namespace planish::cli {

/// Prepares the process and returns what it runs in. Call this once, before anything else.
///
/// - Freed memory stays with the program. Each step allocates the same amount again, and memory
///   that comes from the system has to be cleared each time: a sixth of the time of `auto` on 4,000
///   vertices.
/// - A file that is opened does not become one of the three standard ones, where messages would go
///   into it.
/// - The first interrupt (Ctrl-C, SIGTERM) sets `interrupted` in the context; the second one ends
///   the program at once.
/// - A closed pipe and a file size limit are errors of writing and do not end the process.
///
/// On Windows standard output has to be set to binary as well, and a terminal is what has a console
/// mode: isatty() is true for NUL.
RunContext prepare_process();

/// The words of the command line behind the program's name, in UTF-8.
/// @param argc,argv of main(); on Windows they have lost letters, and the system is asked instead
std::vector<std::string> command_words(int argc, char** argv);

/// Opens a page in the program that the user has for such files, usually the browser, and does not
/// wait for it. That program outlives this one and shares no standard file with it.
/// @param path absolute
/// @return why it cannot be opened, for a note: "xdg-open is not installed"; empty where it can
std::string open_document(const std::filesystem::path& path);

/// Runs a program of the search path and waits for its end. It reads nothing, and what it prints
/// goes to standard error. No shell takes part. On Windows there is none of this.
/// @param words the program and what it is given, in UTF-8
/// @param is_cancelled asked now and then; true ends the program and all that it started
/// @return why there is no result, behind the program's name: "ended with code 3"; empty where it
///   ended well
std::string run_program(const std::vector<std::string>& words,
                        const std::function<bool()>& is_cancelled);

/// What `planish doctor` says of the system.
SystemFacts system_facts();

/// Whether the system made a window for this run alone, which closes when it ends: after a click on
/// the program's icon, or files dropped onto it. On Windows only.
bool has_own_window();

/// Says something on standard error and ends the program, without destructors and without memory.
[[noreturn]] void end_at_once(std::string_view message, int exit_code) noexcept;

}  // namespace planish::cli
