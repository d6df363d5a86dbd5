#pragma once

namespace planish::python {

/// Makes exceptions of the library and of the program those of planish.errors.
void register_errors();

}  // namespace planish::python
