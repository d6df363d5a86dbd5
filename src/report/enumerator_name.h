#pragma once

#include <string_view>

namespace planish {

/// What the options of methods call an enumerator, as in "sequential".
template <class Enumeration>
std::string_view enumerator_name(Enumeration value) {
  for (const auto& [enumerator, name] : names_of(value)) {
    if (enumerator == value) return name;
  }
  return {};
}

}  // namespace planish
