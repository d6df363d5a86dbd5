#pragma once

#include <planish/flatten/flatten.h>

namespace planish {

/// Checks the range of every option of a run, before any work: what a run would not come to, or
/// would take for nothing asked, is refused too.
/// @throws Error option_out_of_range
void check_request(const FlattenOptions& options);

}  // namespace planish
