#pragma once

#include <planish/report/html_report.h>

#include "shell/command.h"

namespace planish::cli {

/// The project file of the app (docs/app.md) that asks for what a command line of `flatten` asks
/// for. Empty where it works on a folder, a product file, a file that cannot be read, or several
/// files that are no product.
PageProject project_of(const Arguments& arguments);

}  // namespace planish::cli
