#pragma once

#include <planish/evolve/evolve.h>

namespace planish {

/// @throws Error option_out_of_range naming the first of both that is out of its range
void check_stopping(Stopping stopping);

}  // namespace planish
