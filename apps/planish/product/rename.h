#pragma once

#include "product/parts.h"

namespace planish::cli {

/// --rename, for patches whose names the file does not give, as those that a cut makes.
Flag rename_flag();

/// The input with the names that --rename gives, also of its folders.
/// @throws UsageError for a name that no patch has, one that would be there twice, and a product
///   file, which has names of its own
void rename_pieces(ProductInput& input, const Arguments& arguments);

}  // namespace planish::cli
