#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <planish/core/context.h>
#include <planish/evolve/method.h>
#include <planish/mesh/patch.h>

#include "shell/session.h"

namespace planish::cli {

/// The memory that a dense patch will take, for a note before the work begins, and a hint to
/// --remesh where that is more than there is. Empty for methods other than auto, and below 100,000
/// vertices.
/// @param available bytes, 0 where that is not known
std::string memory_text(const Method& method, std::size_t vertices, std::size_t available);

/// Says of a run that will take more than a minute how long it takes and how long it would with
/// --remesh, both as estimated from how far it came.
/// @param seconds since the run began
/// @param share of the whole run that is done, 0 to 1
/// @param vertices of the patch, and with --remesh
/// @return nothing for a shorter run, while it is too early to tell, and where --remesh would not
///   be several times shorter
std::optional<std::string> remesh_offer(double seconds, double share, std::size_t vertices,
                                        std::size_t remeshed);

/// The context of a run that says so once, when there is a place to say it.
/// @param session must outlive it
Context offering_remesh(Context context, const Patch& patch, Session& session);

}  // namespace planish::cli
