#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <planish/draw/color.h>
#include <planish/flatten/flatten.h>
#include <planish/mesh/patch.h>
#include <planish/pattern/pattern_options.h>
#include <planish/unfold/suggest_cuts.h>

#include "batch/input_list.h"
#include "output/pattern_output.h"
#include "shell/command.h"
#include "shell/session.h"

namespace planish::cli {

// What verbs do with a patch and their flags, without files: for the verbs, and for the Python
// package, which has the patch in memory.

/// What the flags of `flatten` ask for, but for constraints.
/// @throws UsageError, Error option_out_of_range
FlattenOptions flatten_options_from(const Arguments& arguments);

/// Flattens each of many inputs by itself.
/// @param inputs of all shards, in their order
/// @param arguments with the folder --output
/// @param on_record receives the record of each patch, a line of JSON, as soon as it is there
/// @throws as run_list(), and what the flags are refused for
CommandResult flatten_list(std::vector<ListedInput> inputs, const Arguments& arguments,
                           const std::function<void(const std::string& record)>& on_record,
                           Session& session);

/// The colors of a report's pictures, as --colors says.
/// @throws UsageError for unknown names
ColorMap colors_from(const Arguments& arguments);

/// What the flags of `evolve` ask for, but for constraints.
struct EvolveRequest {
  Unit unit = Unit::mm;
  Method method = {};
  Stopping stopping = {};
  double smooth_first = 0.0;  ///< model units; 0 for not at all
  bool remesh = false;
  std::optional<Plane> symmetric_in = {};  ///< that of --symmetric, from the mesh
};

/// @param standard the method where the flags name none
/// @throws UsageError, Error option_out_of_range
EvolveRequest evolve_request_from(const Arguments& arguments, const Method& standard = {});

/// What `evolve` made of a patch.
struct Evolved {
  TriMesh mesh;  ///< with the evolved positions
  EvolveReport report;
  std::vector<Caution> cautions = {};  ///< what the mesh of the patch cannot show
};

/// Evolves a patch as the flags of `evolve` ask.
/// @param path of its file, for the line of progress
/// @param arguments with the constraints
/// @throws Error as constraints_from() and evolve_patch(); Cancelled
Evolved evolve_as_asked(const Patch& patch, const std::string& path, const EvolveRequest& request,
                        const Arguments& arguments, Session& session);

/// What the flags of `unfold` ask for.
struct UnfoldRequest {
  Unit unit = Unit::mm;
  PatternOutput output = {};
  UnfoldOptions options = {};
  PatternOptions annotations = {};
};

/// @param writes_sheet whether a pattern is drawn at all
/// @throws UsageError, and as annotations_from()
UnfoldRequest unfold_request_from(const Arguments& arguments, bool writes_sheet);

/// Of the patch laid flat as it is; nothing where that is not possible and no limit was asked for.
/// @throws Error the problem that prevents it, where a limit was asked for; Cancelled
std::optional<StrainAsDesigned> strain_as_asked(const Patch& patch, const StrainLimits& limits,
                                                Session& session);

/// What the flags of `suggest-cuts` ask for.
/// @throws UsageError, Error option_out_of_range
SuggestOptions suggest_options_from(const Arguments& arguments);

}  // namespace planish::cli
