#include "io/unit/unit_words.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace planish {

namespace {

/// Comments of people are shorter.
constexpr std::size_t k_longest_comment = 200;

constexpr std::string_view k_for_feet = "for feet give --unit in --scale 12";
constexpr std::string_view k_for_survey_feet =
    "for US survey feet give --unit m --scale 0.3048006096";
constexpr std::string_view k_for_yards = "for yards give --unit in --scale 36";
constexpr std::string_view k_for_miles = "for miles give --unit in --scale 63360";
constexpr std::string_view k_for_kilometres = "for kilometres give --unit m --scale 1000";
constexpr std::string_view k_for_micrometres = "for micrometres give --unit mm --scale 0.001";
constexpr std::string_view k_for_thousandths =
    "for thousandths of an inch give --unit in --scale "
    "0.001";
constexpr std::string_view k_not_plain =
    "say with --unit, and with --scale where one unit of the mesh is not one of these";

/// Whether a word is in a list of words with blanks between.
constexpr bool is_one_of(std::string_view list, std::string_view word) {
  for (std::size_t at = list.find(word); at != list.npos; at = list.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || list[at - 1] == ' ') && (end == list.size() || list[end] == ' ')) return true;
  }
  return false;
}

/// A unit of length by its names in files.
struct UnitNames {
  std::string_view names;
  SaidUnit said;
};

constexpr std::array<UnitNames, 11> k_unit_names = {{
    {"mm millimeter millimeters millimetre millimetres", {Unit::mm, {}}},
    {"cm centimeter centimeters centimetre centimetres", {Unit::cm, {}}},
    {"dm decimeter decimeters decimetre decimetres", {Unit::dm, {}}},
    {"m meter meters metre metres", {Unit::m, {}}},
    {"in inch inches", {Unit::in, {}}},
    {"ft foot feet", {{}, k_for_feet}},
    {"yd yard yards", {{}, k_for_yards}},
    {"mile miles", {{}, k_for_miles}},
    {"km kilometer kilometers kilometre kilometres", {{}, k_for_kilometres}},
    // With the micro sign, and with the Greek letter.
    {"um \xc2\xb5m \xce\xbcm micron microns micrometer micrometers micrometre micrometres",
     {{}, k_for_micrometres}},
    {"mil mils thou", {{}, k_for_thousandths}},
}};

/// Words that make another unit of one: "hundredths of an inch", "square mm", "not in mm".
constexpr std::string_view k_other_words =
    "half halves quarter quarters eighth eighths sixteenth sixteenths tenth tenths hundredth "
    "hundredths thousandth thousandths millionth millionths two three four five eight ten "
    "twelve hundred hundreds thousand thousands dozen square cubic not double twice";
/// Wherever they stand: "LENGTH_UNIT(CENTI,METRE)".
constexpr std::string_view k_prefixes = "nano micro milli centi deci deca hecto kilo";
/// A number behind them, or right before them, scales the unit.
constexpr std::string_view k_scales =
    "scale scaled scaling multiply multiplied multiplier divide divided";
constexpr std::array<std::string_view, 3> k_times = {"x", "\xc3\x97", "times"};

/// Units of these are not the unit of the coordinates: "texture units: cm".
constexpr std::string_view k_other_quantities =
    "texture textures uv angle angular weight mass area volume time speed velocity force "
    "pressure stress density temperature thickness tolerance";
/// "units of the model", "unit of each vertex".
constexpr std::string_view k_articles = "the this each a an one vertex";

/// Before a unit in the same comment they say that it is that of the file: with a sign between, or
/// with "in"; those of the second list with "in" only, as "model: M" and "size: M" are names.
constexpr std::string_view k_measures =
    "scale dimension dimensions dim dims measure measures measurement measurements coordinate "
    "coordinates coords length lengths uom distance distances";
constexpr std::string_view k_subjects =
    "all everything file mesh model geometry part drawing export data values numbers vertices "
    "points positions size sizes created made designed drawn modeled modelled exported saved "
    "written given measured expressed";

struct Word {
  std::string lower;
  std::size_t begin, end;  // in the comment
};

bool is_word_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.' || c == '-' ||
         static_cast<unsigned char>(c) >= 0x80;
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Whether a sign is a part of a number, as the comma of 0,1 and the plus of 1e+3.
bool is_sign_in_number(std::string_view text, std::size_t at) {
  if (at == 0 || at + 1 >= text.size() || !is_digit(text[at + 1])) return false;
  const char before = text[at - 1];
  return (text[at] == ',' && is_digit(before)) ||
         (text[at] == '+' && (before == 'e' || before == 'E'));
}

/// How many of its first letters are a number, as 25.4, 0,1 or 1e-3.
std::size_t length_of_number(std::string_view word) {
  const auto digits_from = [&](std::size_t at, std::string_view letters) {
    return std::min(word.find_first_not_of(letters, at), word.size());
  };
  if (word.find_first_of("0123456789") > 1 || !(is_digit(word[0]) || word[0] == '.')) return 0;
  const std::size_t end = digits_from(0, "0123456789.,");
  if (end == word.size() || word[end] != 'e') return end;
  const std::size_t power = digits_from(end + 1, "+-");
  return power < word.size() && is_digit(word[power]) ? digits_from(power, "0123456789") : end;
}

const UnitNames* unit_named(std::string_view word) {
  const auto found =
      std::find_if(k_unit_names.begin(), k_unit_names.end(),
                   [&](const UnitNames& known) { return is_one_of(known.names, word); });
  return found == k_unit_names.end() ? nullptr : &*found;
}

/// Words in small letters; a number and a unit without a blank between are two.
std::vector<Word> words_of(std::string_view comment) {
  std::vector<Word> words;
  for (std::size_t k = 0; k < comment.size();) {
    Word word{{}, k, k};
    for (; word.end < comment.size(); ++word.end) {
      char c = comment[word.end];
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
      if (!is_word_letter(c) && !is_sign_in_number(comment, word.end)) break;
      word.lower += c;
    }
    k = std::max(word.end, k + 1);
    while (!word.lower.empty() && (word.lower.back() == '.' || word.lower.back() == '-')) {
      word.lower.pop_back();
      --word.end;
    }
    if (word.lower.empty()) continue;
    const std::size_t number = length_of_number(word.lower);
    if (number > 0 && unit_named(word.lower.substr(number)) != nullptr) {
      words.push_back({word.lower.substr(0, number), word.begin, word.begin + number});
      word = {word.lower.substr(number), word.begin + number, word.end};
    }
    words.push_back(std::move(word));
  }
  return words;
}

constexpr std::string_view k_unit_words =
    "unit units lengthunit lengthunits length_unit length_units length-unit file_unit "
    "file_units model_unit model_units mesh_unit mesh_units lengthscale";

bool is_unit_word(const Word& word) {
  return is_one_of(k_unit_words, word.lower);
}

/// Things and persons have such names too.
constexpr std::string_view k_also_names = "m in foot yard mil thou mile";

bool is_number(std::string_view word) {
  return !word.empty() && length_of_number(word) == word.size();
}

/// Whether it is a number, and not 1. One with a comma may be a thousand.
bool is_other_number(std::string_view word) {
  return is_number(word) && (word.find_first_not_of("1.0") != std::string_view::npos ||
                             word.substr(0, word.find('.')) != "1");
}

/// The number of "x10"; empty where it is none.
std::string_view behind_times(std::string_view word) {
  for (const std::string_view times : k_times) {
    if (word.starts_with(times)) return word.substr(times.size());
  }
  return {};
}

/// A comment and its words.
class Comment {
 public:
  explicit Comment(std::string_view text) : text_(text), words_(words_of(text)) {}

  std::optional<SaidUnit> unit() const;

 private:
  /// The last letter before a word that is no blank; 0 for none.
  char sign_before(std::size_t at) const {
    const std::string_view before = text_.substr(0, words_[at].begin);
    const std::size_t last = before.find_last_not_of(" \t");
    return last == std::string_view::npos ? '\0' : before[last];
  }

  bool is_behind_sign(std::size_t at) const {
    const char sign = sign_before(at);
    return sign != '\0' && std::string_view("=:([").find(sign) != std::string_view::npos;
  }

  bool is_behind(std::size_t at, std::string_view word) const {
    return at > 0 && words_[at - 1].lower == word;
  }

  bool is_lower(std::size_t at, std::string_view word) const {
    return at < words_.size() && words_[at].lower == word;
  }

  /// What stands between a word and the one before it.
  std::string_view gap_before(std::size_t at) const {
    return text_.substr(words_[at - 1].end, words_[at].begin - words_[at - 1].end);
  }

  /// Whether the word before it is in the same part of the sentence.
  bool is_joined(std::size_t at) const {
    return at > 0 && at < words_.size() &&
           gap_before(at).find_first_of(",;") == std::string_view::npos;
  }

  bool is_unit(std::size_t at) const;
  bool is_unit_or_its_word(std::size_t at) const;
  bool is_of_other_quantity(std::size_t at) const;
  bool is_of_other_thing(std::size_t at) const;
  bool is_factor_of_unit(std::size_t at) const;
  bool is_ratio(std::size_t at) const;
  bool says_factor(std::size_t at) const;
  bool ends_with(std::size_t at) const;
  bool is_all(std::size_t at) const;
  bool is_said_to_be(std::size_t at) const;
  bool is_of_file(const std::vector<std::size_t>& places) const;
  bool is_changed(std::size_t first) const;
  bool has_factor() const;

  std::string_view text_;
  std::vector<Word> words_;
};

/// Whether a unit stands there: not a part of another one, as in "kg/m" and "mm^2". "m" and "in",
/// which are also names and words of English, stand right behind "units", "of", "=" and the like,
/// with nothing behind that makes them another word.
bool Comment::is_unit(std::size_t at) const {
  const Word& word = words_[at];
  const auto letter = [&](std::size_t k) { return k < text_.size() ? text_[k] : ' '; };
  const bool is_divided = letter(word.end) == '/' && !is_digit(letter(word.end + 1));
  if (is_divided || letter(word.end) == '^' || letter(word.begin - 1) == '/') return false;
  if (word.lower != "m" && word.lower != "in") return true;
  if (word.lower == "in" && at + 1 < words_.size()) return false;
  const std::size_t next = text_.find_first_not_of(" \t", word.end);
  if (next != std::string_view::npos && text_[next] == ':') return false;
  return is_behind_sign(at) || is_behind(at, "of") || is_behind(at, "in") ||
         (at > 0 && (is_unit_word(words_[at - 1]) || is_number(words_[at - 1].lower)));
}

/// Whether a statement ends with the word.
bool Comment::ends_with(std::size_t at) const {
  const std::size_t next = text_.find_first_not_of(" \t", words_[at].end);
  return next == std::string_view::npos ||
         std::string_view(".,;!)]([*-").find(text_[next]) != std::string_view::npos ||
         (at + 1 < words_.size() && words_[at + 1].lower == "unless");
}

/// Whether the comment is the unit and nothing else.
bool Comment::is_all(std::size_t at) const {
  if (is_one_of(k_also_names, words_[at].lower)) return false;
  return std::all_of(words_.begin(), words_.end(), [&](const Word& word) {
    return word.lower == "in" || unit_named(word.lower) != nullptr;
  });
}

/// Whether the words before it say that it is the unit of what they name.
bool Comment::is_said_to_be(std::size_t at) const {
  if (!ends_with(at) || at == 0) return false;
  const auto end = words_.begin() + static_cast<std::ptrdiff_t>(at);
  const auto has = [&](std::string_view list) {
    return std::any_of(words_.begin(), end,
                       [&](const Word& word) { return is_one_of(list, word.lower); });
  };
  const bool is_subject = words_[at].lower != "in" && has(k_subjects);
  if (is_behind(at, "in") && (has(k_measures) || is_subject)) return true;
  if (is_other_number(words_[at - 1].lower))
    return std::any_of(words_.begin(), end, [](const Word& word) { return word.lower == "scale"; });
  const bool is_told = is_behind_sign(at) || is_behind(at, "are") || is_behind(at, "is") ||
                       is_behind(at, "1") || is_one_of(k_measures, words_[at - 1].lower);
  return is_told && has(k_measures);
}

bool Comment::is_of_file(const std::vector<std::size_t>& places) const {
  for (std::size_t k = 0; k < words_.size(); ++k) {
    if (is_unit_word(words_[k]) && !is_of_other_quantity(k)) return true;
  }
  if (is_all(places.front())) return true;
  return std::any_of(places.begin(), places.end(),
                     [this](std::size_t at) { return is_said_to_be(at); });
}

bool Comment::is_unit_or_its_word(std::size_t at) const {
  if (at >= words_.size()) return false;
  return is_unit_word(words_[at]) || (unit_named(words_[at].lower) != nullptr && is_unit(at));
}

/// Whether the word unit there means one of angles, of textures or the like.
bool Comment::is_of_other_quantity(std::size_t at) const {
  return (at > 0 && is_one_of(k_other_quantities, words_[at - 1].lower)) ||
         (is_lower(at + 1, "of") && at + 2 < words_.size() &&
          is_one_of(k_other_quantities, words_[at + 2].lower));
}

/// Whether the word unit there is one of a thing that is not known: "units of work", "unit test".
bool Comment::is_of_other_thing(std::size_t at) const {
  if (!is_unit_word(words_[at])) return false;
  if (is_lower(at + 1, "test") || is_lower(at + 1, "tests")) return true;
  if (!is_lower(at + 1, "of") || at + 2 >= words_.size()) return false;
  const std::string& thing = words_[at + 2].lower;
  return !is_one_of(k_measures, thing) && !is_one_of(k_subjects, thing) &&
         !is_one_of(k_articles, thing) && !is_number(thing) && unit_named(thing) == nullptr;
}

/// Whether a unit is multiplied by the number there: "mm x 10", "unit in m: 0.01", "inches (x10)".
bool Comment::is_factor_of_unit(std::size_t at) const {
  const bool has_times = is_other_number(behind_times(words_[at].lower));
  if (!is_joined(at) || !(has_times || is_other_number(words_[at].lower))) return false;
  if (std::find(k_times.begin(), k_times.end(), words_[at - 1].lower) != k_times.end())
    return is_unit_or_its_word(at - 2);
  if (!is_unit_or_its_word(at - 1)) return false;
  const std::string_view gap = gap_before(at);
  if (has_times || is_unit_word(words_[at - 1])) return true;
  // In brackets it may count what the next word says.
  return gap.find_first_of(":=*/") != std::string_view::npos ||
         (gap.find('(') != std::string_view::npos && ends_with(at));
}

/// Whether a ratio ends there that is not 1:1, as 1:10; times of the day are none.
bool Comment::is_ratio(std::size_t at) const {
  if (at == 0 || gap_before(at) != ":") return false;
  const std::string &first = words_[at - 1].lower, &second = words_[at].lower;
  const bool is_scale =
      (first == "1" && is_other_number(second)) || (second == "1" && is_other_number(first));
  const auto is_colon = [&](std::size_t k) { return k < text_.size() && text_[k] == ':'; };
  return is_scale && !is_colon(words_[at].end) && !is_colon(words_[at - 1].begin - 1) &&
         !is_lower(at + 1, "am") && !is_lower(at + 1, "pm");
}

/// Whether the word there says that a factor is beside the unit: "units per meter".
bool Comment::says_factor(std::size_t at) const {
  const std::string& word = words_[at].lower;
  if (word == "factor") return true;
  if (word != "per" && word != "conversion") return false;
  return (is_joined(at) && is_unit_or_its_word(at - 1)) ||
         (is_joined(at + 1) && is_unit_or_its_word(at + 1));
}

/// Whether it has a factor, and that is not said to be 1.
bool Comment::has_factor() const {
  bool says = false, has_one = false, has_other = false;
  for (std::size_t k = 0; k < words_.size(); ++k) {
    says = says || says_factor(k);
    has_other = has_other || is_other_number(words_[k].lower);
    has_one = has_one || is_number(words_[k].lower);
  }
  return says && (has_other || !has_one);
}

/// Whether numbers or words make another unit of it.
/// @param first the place of the unit's first name
bool Comment::is_changed(std::size_t first) const {
  constexpr std::string_view k_between = "of a an in";
  bool is_scale = false;
  for (std::size_t k = 0; k < words_.size(); ++k) {
    const std::string& word = words_[k].lower;
    const bool leads_to_unit = k + 1 == first || is_lower(k + 1, "scale") ||
                               (k < first && is_one_of(k_between, words_[k + 1].lower));
    if (leads_to_unit && is_one_of(k_other_words, word)) return true;
    const bool counts = is_unit_word(words_[k]) || k == first;
    if (counts && k > 0 && is_other_number(words_[k - 1].lower)) return true;
    if (is_one_of(k_scales, word) && is_joined(k) && is_other_number(words_[k - 1].lower))
      return true;
    is_scale = is_scale || is_one_of(k_scales, word);
    if (is_scale && is_other_number(word)) return true;
    if (is_one_of(k_prefixes, word) || is_of_other_thing(k) || is_factor_of_unit(k) || is_ratio(k))
      return true;
  }
  return has_factor();
}

std::optional<SaidUnit> Comment::unit() const {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < words_.size(); ++k) {
    if (unit_named(words_[k].lower) != nullptr && is_unit(k)) places.push_back(k);
  }
  if (places.empty() || !is_of_file(places)) return std::nullopt;
  const auto said = [&](std::size_t at) { return unit_named(words_[at].lower)->said; };
  const SaidUnit first = said(places.front());
  const bool several = std::any_of(places.begin(), places.end(), [&](std::size_t at) {
    return said(at).unit != first.unit || said(at).advice != first.advice;
  });
  if (several || is_changed(places.front())) return SaidUnit{{}, k_not_plain};
  if (first.advice == k_for_feet && is_behind(places.front(), "survey"))
    return SaidUnit{{}, k_for_survey_feet};
  return first;
}

}  // namespace

std::optional<SaidUnit> unit_said_by(std::string_view comment) {
  if (comment.size() > k_longest_comment) return std::nullopt;
  return Comment(comment).unit();
}

}  // namespace planish
