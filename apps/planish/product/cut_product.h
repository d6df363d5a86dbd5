#pragma once

#include <optional>

#include <planish/flatten/flatten.h>

#include "cut/cut_flag.h"
#include "product/parts.h"

namespace planish::cli {

/// For pieces of what these options flatten: with limits and a tolerance, they may change within
/// it.
PanelRules panel_rules(const FlattenOptions& options, const Arguments& arguments);

/// Cuts an input of one patch open as --cut and --symmetric say; where that divides it, it has
/// several patches from then on. Without them, and of several patches, divides those that cannot
/// be laid flat as they are into panels.
/// @throws UsageError for lines and an input of several patches or a product file, Error as
/// cut_as_asked() and divided_into_panels()
std::optional<CutOutcome> cut_product(ProductInput& input, const FlattenOptions& options,
                                      const Arguments& arguments, Session& session);

}  // namespace planish::cli
