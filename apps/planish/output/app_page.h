#pragma once

#include <span>
#include <string_view>

namespace planish::cli {

/// The page of the app (docs/app.md), in parts that follow on each other; none where the program
/// was built without it (cmake/PlanishAppPage.cmake).
std::span<const std::string_view> app_page();

}  // namespace planish::cli
