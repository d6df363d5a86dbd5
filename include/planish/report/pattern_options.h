#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <planish/pattern/grain.h>
#include <planish/pattern/marks.h>
#include <planish/pattern/notches.h>
#include <planish/pattern/offset_outline.h>

namespace planish {

/// What is written inside a piece; nothing where all is empty.
struct PieceLabel {
  std::string name = {};
  std::string size = {};
  int quantity = 0;  ///< how many to cut; 0: not said, which for machines is one
  std::string fabric = {};
  std::string note = {};  ///< as "cut on fold" or "one mirrored"
};

/// The grain of a pattern: a direction on the model, or one in the pattern by its angle to the
/// sheet's x axis, in degrees, counter-clockwise.
using Grain = std::variant<Vec3, double>;

/// What a pattern gets besides its outline.
struct PatternOptions {
  std::optional<Allowance> allowance = {};
  std::vector<Notch> notches = {};
  NotchSizes notch_sizes = {};
  std::optional<Grain> grain = {};
  std::vector<Mark> marks = {};
  PieceLabel label = {};
  std::string date = {};  ///< for the sheet's label; never taken from a clock
};

}  // namespace planish
