#pragma once

#include "shell/command.h"
#include "shell/session.h"

namespace planish::cli {

/// The arguments with the unit of length that the input files state, all the same one, where the
/// verb has --unit; says in a note whose words were taken, or that --unit says otherwise. Of
/// several files that disagree none is taken: each is scaled when it is read, as in_run_unit()
/// tells. Files that cannot be read state nothing: running says why.
Arguments with_stated_unit(const Command& command, Arguments arguments, Session& session);

}  // namespace planish::cli
