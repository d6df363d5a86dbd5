#pragma once

#include <string>
#include <vector>

#include <planish/flatten/compare.h>

#include "shell/command.h"
#include "shell/session.h"

namespace planish::cli {

/// --with, for verbs that compare methods: results and programs from outside.
Flag with_flag();

/// The words that a command is made of: divided at spaces, but not between quotes, which are left
/// out. No other character means anything: there is no shell.
/// @throws UsageError where a quote is not closed
std::vector<std::string> words_of_command(const std::string& command);

/// @throws UsageError for a name that is no word for tables and files, or that is of a method
void check_other_name(const std::string& name);

/// The positions of a result that has the triangles of the design, in any order.
/// @throws Error method_failed where it has others
std::vector<Vec3> positions_over(const TriMesh& design, TriMesh result);

/// What --with asks for, each as a method whose only sweep takes what another program made. Files
/// are read, and programs run, when that sweep is made; what is wrong is an error then. The runs
/// must not outlive arguments and session.
/// @param path of the input
/// @throws UsageError for what is not NAME=RESULT, and for names that are bad, of a method or twice
std::vector<CompareRun> runs_with(const std::string& path, const Arguments& arguments,
                                  Session& session);

}  // namespace planish::cli
