#include "io/formats/stated_unit.h"

#include <algorithm>
#include <array>
#include <utility>

#include "io/file/cursor_error.h"

namespace planish {

namespace {

/// Comments of people are shorter, and stand at the front.
constexpr std::size_t k_longest_comment = 200;
constexpr std::size_t k_most_bytes = 65536;

/// A unit of length by its names in files; feet have none of ours.
struct UnitName {
  std::string_view name;
  std::optional<Unit> unit;
};

constexpr std::array<UnitName, 25> k_unit_names = {{
    {"mm", Unit::mm},          {"millimeter", Unit::mm},
    {"millimeters", Unit::mm}, {"millimetre", Unit::mm},
    {"millimetres", Unit::mm}, {"cm", Unit::cm},
    {"centimeter", Unit::cm},  {"centimeters", Unit::cm},
    {"centimetre", Unit::cm},  {"centimetres", Unit::cm},
    {"dm", Unit::dm},          {"decimeter", Unit::dm},
    {"decimeters", Unit::dm},  {"decimetre", Unit::dm},
    {"decimetres", Unit::dm},  {"m", Unit::m},
    {"meter", Unit::m},        {"meters", Unit::m},
    {"metre", Unit::m},        {"metres", Unit::m},
    {"in", Unit::in},          {"inch", Unit::in},
    {"inches", Unit::in},      {"ft", std::nullopt},
    {"feet", std::nullopt},
}};

struct Word {
  std::string lower;
  std::size_t begin;  // in the comment
};

bool is_word_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.' || c == '-';
}

std::vector<Word> words_of(std::string_view comment) {
  std::vector<Word> words;
  bool within = false;
  for (std::size_t k = 0; k < comment.size(); ++k) {
    char c = comment[k];
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    const bool letter = is_word_letter(c);
    if (letter && !within) words.push_back({{}, k});
    if (letter) words.back().lower += c;
    within = letter;
  }
  for (Word& word : words) {
    while (!word.lower.empty() && (word.lower.back() == '.' || word.lower.back() == '-'))
      word.lower.pop_back();
  }
  return words;
}

const UnitName* unit_name(std::string_view word) {
  const auto found = std::find_if(k_unit_names.begin(), k_unit_names.end(),
                                  [&](const UnitName& known) { return known.name == word; });
  return found == k_unit_names.end() ? nullptr : &*found;
}

bool is_unit_word(const Word& word) {
  return word.lower == "unit" || word.lower == "units";
}

/// Whether it is a number, and not 1.
bool is_other_number(const Word& word) {
  if (word.lower.empty() || word.lower.find_first_not_of("0123456789.") != std::string::npos) {
    return false;
  }
  return word.lower.find_first_not_of("1.0") != std::string::npos ||
         word.lower.substr(0, word.lower.find('.')) != "1";
}

/// Whether "m" and "in", which are also names and words of English, stand where a unit does: right
/// behind "units", "of", "=" and the like, and with nothing behind that makes them another word.
bool stands_as_unit(std::string_view comment, const std::vector<Word>& words, std::size_t at) {
  const std::string& word = words[at].lower;
  if (word != "m" && word != "in") return true;
  if (word == "in" && at + 1 < words.size()) return false;
  const std::string_view before = comment.substr(0, words[at].begin);
  const std::size_t sign = before.find_last_not_of(" \t");
  const bool behind_sign = sign != std::string_view::npos &&
                           std::string_view("=:([").find(before[sign]) != std::string_view::npos;
  const bool behind_word = at > 0 && (is_unit_word(words[at - 1]) || words[at - 1].lower == "of" ||
                                      words[at - 1].lower == "in" || words[at - 1].lower == "1");
  return (behind_sign || behind_word) &&
         comment.substr(words[at].begin + word.size()).find_first_of("/^") ==
             std::string_view::npos;
}

/// Collects what comments say.
class UnitFinder {
 public:
  void look_at(std::string_view comment, std::size_t line);

  UnitFinding take() {
    if (contradicted_) finding_.unit.reset();
    return std::move(finding_);
  }

 private:
  UnitFinding finding_;
  bool contradicted_ = false;
};

void UnitFinder::look_at(std::string_view comment, std::size_t line) {
  if (comment.size() > k_longest_comment) return;
  const std::vector<Word> words = words_of(comment);
  if (std::none_of(words.begin(), words.end(), is_unit_word)) return;
  std::vector<const UnitName*> names;
  bool scaled = false;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const UnitName* const name = unit_name(words[k].lower);
    const bool named = name != nullptr && stands_as_unit(comment, words, k);
    if (named) names.push_back(name);
    const bool counts = is_unit_word(words[k]) || (named && names.size() == 1);
    if (counts && k > 0 && is_other_number(words[k - 1])) scaled = true;
  }
  if (names.empty()) return;
  const std::string where = line == 0 ? "the header" : "line " + std::to_string(line);
  const std::string says = where + " says " + in_quotes(comment);
  const bool several = std::any_of(names.begin(), names.end(), [&](const UnitName* name) {
    return name->unit != names.front()->unit;
  });
  std::optional<StatedUnit>& unit = finding_.unit;
  if (scaled || several) {
    finding_.notes.push_back(says +
                             ", which is not used: say with --unit, and with --scale where "
                             "one unit of the mesh is not one of these");
  } else if (!names.front()->unit) {
    finding_.notes.push_back(says + ", which is not used: for feet give --unit in --scale 12");
  } else if (unit && unit->unit != *names.front()->unit) {
    contradicted_ = true;
    finding_.notes.push_back(says + ", but line " + std::to_string(unit->line) + " says \"" +
                             unit->words + "\": neither is used; say with --unit");
  } else if (!unit) {
    unit = StatedUnit{*names.front()->unit, printable(comment), line};
  }
}

/// Calls visit(line, number) for the lines of a text until it returns false. Lines end in LF, CR LF
/// or CR.
template <class Visit>
void for_each_line(std::string_view text, const Visit& visit) {
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    if (!visit(text.substr(0, end), number)) return;
    text.remove_prefix(end);
    text.remove_prefix(text.starts_with("\r\n") ? 2 : text.empty() ? 0 : 1);
  }
}

std::string_view without_blanks(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  return text.substr(0, text.find_last_not_of(" \t") + 1);
}

/// Takes a comment sign from the line, if it begins with one.
bool take_sign(std::string_view sign, std::string_view& line) {
  if (!line.starts_with(sign)) return false;
  line = without_blanks(line.substr(sign.size()));
  return true;
}

/// Whether vertices or faces of an OBJ file begin with the line.
bool begins_mesh(std::string_view line) {
  return line.starts_with("v ") || line.starts_with("f ") || line.starts_with("v\t") ||
         line.starts_with("f\t");
}

UnitFinding find_in_text(std::string_view text, MeshFormat format) {
  UnitFinder finder;
  std::size_t numbers = 0;  // lines of an OFF file: counts, then vertices
  for_each_line(text, [&](std::string_view line, std::size_t number) {
    line = without_blanks(line);
    if (format == MeshFormat::ply) {
      if (take_sign("comment ", line) || take_sign("obj_info ", line)) finder.look_at(line, number);
      return line != "end_header";
    }
    if (take_sign("#", line)) {
      while (take_sign("#", line)) {
      }
      finder.look_at(line, number);
      return true;
    }
    if (!line.empty() && std::string_view("+-.0123456789").find(line.front()) != line.npos)
      ++numbers;
    return !begins_mesh(line) && numbers < 2;
  });
  return finder.take();
}

UnitFinding find_in_stl(std::string_view bytes) {
  const std::string_view front = bytes.substr(0, k_longest_comment);
  const auto is_print = [](char c) { return c >= ' ' && c <= '~'; };
  const auto end = std::find_if_not(front.begin(), front.end(), is_print);
  const bool is_line = end != front.end() && (*end == '\n' || *end == '\r');
  const auto length = static_cast<std::size_t>(end - front.begin());
  UnitFinder finder;
  finder.look_at(
      without_blanks(front.substr(0, is_line ? length : std::min<std::size_t>(length, 80))),
      is_line ? 1 : 0);
  return finder.take();
}

}  // namespace

UnitFinding find_unit(std::string_view bytes, MeshFormat format) {
  if (format == MeshFormat::stl) return find_in_stl(bytes);
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  return find_in_text(bytes.substr(0, k_most_bytes), format);
}

}  // namespace planish
