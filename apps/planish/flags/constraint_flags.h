#pragma once

#include <planish/evolve/constraints.h>
#include <planish/mesh/patch.h>

#include "shell/command.h"

namespace planish::cli {

/// --fix, --weights and --obstacle, for verbs that evolve.
FlagGroup constraint_flags();

/// Refuses a constraint that the method cannot honour, before anything is read.
/// @throws UsageError naming the methods that can
void refuse_unsupported_constraints(const Arguments& arguments, const Method& method);

/// What the flags' files say about a mesh.
/// @throws Error as read_fixed_vertices(), weights_in() and read_mesh()
Constraints constraints_from(const Arguments& arguments, const Patch& patch, Session& session);

}  // namespace planish::cli
