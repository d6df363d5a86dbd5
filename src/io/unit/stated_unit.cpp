#include "io/unit/stated_unit.h"

#include <algorithm>
#include <utility>

#include "io/file/cursor_error.h"
#include "io/unit/unit_words.h"

namespace planish {

namespace {

/// They stand at the front.
constexpr std::size_t k_most_bytes = 65536;
/// The first line of an STL file is looked at so far.
constexpr std::size_t k_longest_line = 201;

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
  const auto said = unit_said_by(comment);
  if (!said) return;
  const std::string where = line == 0 ? "the header" : "line " + std::to_string(line);
  const std::string says = where + " says " + in_quotes(comment);
  std::optional<StatedUnit>& unit = finding_.unit;
  if (!said->unit) {
    finding_.notes.push_back(says + ", which is not used: " + std::string(said->advice));
  } else if (unit && unit->unit != *said->unit) {
    contradicted_ = true;
    finding_.notes.push_back(says + ", but line " + std::to_string(unit->line) + " says \"" +
                             unit->words + "\": neither is used; say with --unit");
  } else if (!unit) {
    unit = StatedUnit{*said->unit, printable(comment), line};
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
    if (const std::size_t sign = line.find('#'); format == MeshFormat::off && sign != line.npos)
      finder.look_at(without_blanks(line.substr(sign + 1)), number);
    if (!line.empty() && std::string_view("+-.0123456789").find(line.front()) != line.npos)
      ++numbers;
    return !begins_mesh(line) && numbers < 2;
  });
  return finder.take();
}

UnitFinding find_in_stl(std::string_view bytes) {
  const std::string_view front = bytes.substr(0, k_longest_line);
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
