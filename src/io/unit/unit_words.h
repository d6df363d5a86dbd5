#pragma once

#include <optional>
#include <string_view>

#include <planish/core/unit.h>

namespace planish {

/// What a comment says of the unit of length of its file.
struct SaidUnit {
  std::optional<Unit> unit = {};  ///< none where it is none of ours, or not plain
  std::string_view advice = {};   ///< then: which flags say it
};

/// Looks for one unit of length, in a comment that has the word unit or units ("File units =
/// inches"), that says what is in it ("all dimensions in inches", "scale: cm", "exported in mm"),
/// or that is nothing else ("Millimeters"). A comment of more than 200 bytes says nothing.
std::optional<SaidUnit> unit_said_by(std::string_view comment);

}  // namespace planish
