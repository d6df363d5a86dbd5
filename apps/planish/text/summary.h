#pragma once

#include <optional>
#include <span>
#include <string>

#include <planish/flatten/compare.h>
#include <planish/flatten/flatten.h>

#include "evolve/direction.h"
#include "shell/command.h"
#include "shell/session.h"

namespace planish::cli {

/// "4242 vertices, 8196 triangles"
std::string size_text(const TriMesh& mesh);

/// "(0.129, 0.9, -0.123)"
std::string place_text(Vec3 at);

/// The results of the verbs as people read them, at most 80 columns wide.
/// @param cautions as find_cautions() of the patch
/// @param unit of the mesh
std::string measure_text(const std::string& path, const MeasuredPatch& patch,
                         const std::optional<StrainAsDesigned>& strain,
                         std::span<const Caution> cautions, Unit unit);
/// Of a mesh that cannot be measured: sizes and what is wrong.
std::string refused_text(const std::string& path, const Inspection& inspection);
std::string evolve_text(const EvolveReport& report);
std::string unfold_text(const UnfoldReport& report, std::span<const Caution> cautions);
std::string flatten_text(const FlattenReport& report);

/// How many vertices are of which class, and how many their Laplacian directions can lower.
std::string directions_text(const DirectionCounts& counts);

/// Ends with exit code 3 where the target was asked for and not met.
/// @param outcome of a verb that evolved
CommandResult with_target_checked(CommandResult outcome, const Arguments& arguments,
                                  const EvolveReport& report);

/// Tells, before any long work, that a patch cannot become flattenable as long as its border is
/// what it is, and what to do; nothing where little area is at stake.
/// @throws Error as Connectivity
void note_obstruction(Session& session, const Patch& patch);

/// Says before the work on a dense patch how much memory it will take.
void note_memory(Session& session, const Method& method, std::size_t vertices);

/// Warns that one of several methods failed.
void warn_of_method(Session& session, const Method& method, const Failure& failure);

/// Says what the mesh of one of several files cannot show.
void note_cautions(Session& session, const std::string& path, std::span<const Caution> cautions,
                   Unit unit);

}  // namespace planish::cli
