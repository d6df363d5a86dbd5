#pragma once

namespace planish::cli {

/// How many degrees a radian has.
inline constexpr double k_degrees = 57.295779513082320877;

}  // namespace planish::cli
