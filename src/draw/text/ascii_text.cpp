#include "draw/text/ascii_text.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "draw/hex.h"
#include "draw/text/utf8.h"

namespace planish {

namespace {

/// Consecutive characters from the first on, their spellings with a blank between them. "~" stands
/// for none.
struct Run {
  char32_t first;
  std::string_view spellings;
};

constexpr std::array<Run, 6> k_runs = {{
    {U'\u00C0',
     "A A A A Ae A AE C E E E E I I I I D N O O O O Oe x O U U U Ue Y Th ss "
     "a a a a ae a ae c e e e e i i i i d n o o o o oe / o u u u ue y th y"},
    {U'\u0100',
     "A a A a A a C c C c C c C c D d D d E e E e E e E e E e G g G g G g G g H h H h "
     "I i I i I i I i I i IJ ij J j K k k L l L l L l L l L l N n N n N n n N n "
     "O o O o O o OE oe R r R r R r S s S s S s S s T t T t T t U u U u U u U u U u U u "
     "W w Y y Y Z z Z z Z z s"},
    {U'\u0391',
     "A B G D E Z I Th I K L M N X O P R ~ S T Y F Ch Ps O I Y a e i i y "
     "a b g d e z i th i k l m n x o p r s s t y f ch ps o i y o y o"},
    {U'\u0400',
     "E Yo Dj G Ye Z I Yi J Lj Nj C K I U Dz "
     "A B V G D E Zh Z I Y K L M N O P R S T U F Kh Ts Ch Sh Shch ~ Y ~ E Yu Ya "
     "a b v g d e zh z i y k l m n o p r s t u f kh ts ch sh shch ~ y ~ e yu ya "
     "e yo dj g ye z i yi j lj nj c k i u dz"},
    {U'\u2010', "- - - - - - | = ' ' , ' \" \" \" \""},
    {U'\u1E9E', "SS"},
}};

struct Sign {
  char32_t sign;
  std::string_view spelling;
};
constexpr std::array<Sign, 12> k_signs = {{{U'\u00A0', " "},
                                           {U'\u00B0', "deg"},
                                           {U'\u00B1', "+-"},
                                           {U'\u00B2', "2"},
                                           {U'\u00B3', "3"},
                                           {U'\u00B5', "u"},
                                           {U'\u00B7', "."},
                                           {U'\u00BD', "1/2"},
                                           {U'\u00F7', "/"},
                                           {U'\u2026', "..."},
                                           {U'\u2212', "-"},
                                           {U'\u20AC', "EUR"}}};

/// The spelling of that number; nothing behind the last one.
std::string_view spelling_in(std::string_view spellings, std::size_t number) {
  for (; number > 0; --number) {
    const std::size_t blank = spellings.find(' ');
    if (blank == std::string_view::npos) return {};
    spellings.remove_prefix(blank + 1);
  }
  return spellings.substr(0, spellings.find(' '));
}

std::string_view spelling_of(char32_t point) {
  const auto* const sign = std::find_if(k_signs.begin(), k_signs.end(),
                                        [&](const Sign& some) { return some.sign == point; });
  if (sign != k_signs.end()) return sign->spelling;
  for (const Run& run : k_runs) {
    if (point < run.first || point - run.first > 0x100) continue;
    const std::string_view spelling = spelling_in(run.spellings, point - run.first);
    if (!spelling.empty()) return spelling;
  }
  return {};
}

/// Accents that stand by themselves behind their letter.
bool is_accent(char32_t point) {
  return point >= U'\u0300' && point <= U'\u036F';
}

}  // namespace

std::string ascii_letters(char32_t point) {
  if (point < U' ' || point == 0x7F) return " ";
  if (point < 0x7F) return {static_cast<char>(point)};
  const std::string_view spelling = spelling_of(point);
  if (!spelling.empty()) return spelling == "~" ? std::string() : std::string(spelling);
  if (is_accent(point)) return {};
  std::string number = "u";
  append_hex(number, point, point > 0xFFFF ? 6 : 4);
  return number;
}

std::string ascii_text(std::string_view text) {
  std::string ascii;
  for (const char32_t point : code_points(text))
    ascii += ascii_letters(point);
  return ascii;
}

}  // namespace planish
