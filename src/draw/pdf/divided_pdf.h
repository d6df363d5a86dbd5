#pragma once

#include <optional>
#include <string>

#include <planish/draw/drawing.h>

namespace planish {

/// The drawing on pages to be joined that all viewers show at true size, besides a first one of A4
/// that says where each goes; nothing where it would take more of them than anyone joins.
std::optional<std::string> format_divided_pdf(const Drawing& drawing);

}  // namespace planish
