#pragma once

#include <optional>

#include <planish/flatten/product.h>

#include <planish_json/json.h>

namespace planish::cli {

/// The figures of a finished patch, for the state that --resume reads: all but mesh and positions.
/// Every struct is a list of its fields in their order, as the same version alone reads it.
Json figures_json(FinishedPatch patch);

/// A patch with these figures, its mesh and positions empty. Nothing where one of them is missing
/// or cannot be: anybody may have written them.
std::optional<FinishedPatch> patch_of_figures(const Json& figures);

}  // namespace planish::cli
