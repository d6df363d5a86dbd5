#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <planish/core/vec.h>

namespace planish {

/// Goes over the numbers of an attribute of SVG: with blanks, a comma or nothing between them where
/// they differ.
class SvgNumbers {
 public:
  explicit SvgNumbers(std::string_view text) : text_(text) {}

  bool at_end();
  /// The next number; nothing where none stands or it is not finite.
  std::optional<double> number();
  /// The next 0 or 1, which nothing need follow.
  std::optional<bool> flag();
  /// The next byte, which is taken; 0 at the end.
  char letter();
  char peek();
  /// What is left, for messages.
  std::string_view rest() const { return text_; }

 private:
  void skip_separators();

  std::string_view text_;
};

/// All numbers of a list; nothing where anything else stands in it.
std::optional<std::vector<double>> svg_numbers(std::string_view text);

/// A length in user units, as "10", "10mm" or "1.5in"; a share of `whole` as "50%". Nothing for
/// other texts.
std::optional<double> svg_length(std::string_view text, double whole);

/// User units of CSS in a millimetre.
inline constexpr double k_user_units_per_mm = 96.0 / 25.4;

/// x' = a x + c y + e, y' = b x + d y + f.
struct Affine {
  double a = 1.0, b = 0.0, c = 0.0, d = 1.0, e = 0.0, f = 0.0;

  Vec2 operator()(Vec2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  /// First `inner`, then this one.
  Affine after(const Affine& inner) const;
};

/// A list as "translate(1 2) rotate(30)"; nothing where it is none.
std::optional<Affine> svg_transform(std::string_view text);

/// The value of a property in a style, as "none" of "display" in "fill:red; display:none"; empty
/// where it has none.
std::string_view style_value(std::string_view style, std::string_view property);

}  // namespace planish
