#pragma once

#include <filesystem>

#include "shell/command.h"

namespace planish::cli {

class Session;

/// --open, for verbs that write a page.
Flag open_flag();

/// Opens the page where --open is given; called when it is written. Never fails.
void open_if_asked(const Arguments& arguments, const std::filesystem::path& page,
                   Session& session) noexcept;

}  // namespace planish::cli
