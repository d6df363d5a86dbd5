#include "flags/units.h"

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fast_float/fast_float.h>

#include "flags/scale_flag.h"
#include "shell/failures.h"
#include "shell/nearest.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

struct UnitWord {
  std::string_view word;
  Unit unit;
};

/// What people write instead of the short names.
constexpr std::array<UnitWord, 19> k_unit_words = {{{"millimetre", Unit::mm},
                                                    {"millimeter", Unit::mm},
                                                    {"millimetres", Unit::mm},
                                                    {"millimeters", Unit::mm},
                                                    {"centimetre", Unit::cm},
                                                    {"centimeter", Unit::cm},
                                                    {"centimetres", Unit::cm},
                                                    {"centimeters", Unit::cm},
                                                    {"decimetre", Unit::dm},
                                                    {"decimeter", Unit::dm},
                                                    {"decimetres", Unit::dm},
                                                    {"decimeters", Unit::dm},
                                                    {"metre", Unit::m},
                                                    {"meter", Unit::m},
                                                    {"metres", Unit::m},
                                                    {"meters", Unit::m},
                                                    {"inch", Unit::in},
                                                    {"inches", Unit::in},
                                                    {"\"", Unit::in}}};

/// A unit of several others, as 0.5m, is one of them and a factor.
/// @throws UsageError
void refuse_number_with_unit(const std::string& word) {
  const std::size_t end = word.find_first_not_of("0123456789.");
  const std::size_t begin = word.find_first_not_of(" 0123456789.");
  if (end == 0 || begin == std::string::npos) return;
  const auto unit = unit_of_word(std::string_view(word).substr(begin));
  double factor = 0.0;
  const auto parsed = fast_float::from_chars(word.data(), word.data() + end, factor);
  if (!unit || parsed.ec != std::errc() || parsed.ptr != word.data() + end || !(factor > 0.0))
    return;
  throw UsageError("unknown unit " + word + "; if one unit of the mesh is " + word +
                   ", give --unit " + std::string(to_string(*unit)) + " --scale " +
                   word.substr(0, end));
}

}  // namespace

std::optional<Unit> unit_of_word(std::string_view word) {
  for (const Unit unit : k_units) {
    if (same_word(word, to_string(unit))) return unit;
  }
  for (const UnitWord& known : k_unit_words) {
    if (same_word(word, known.word)) return known.unit;
  }
  return std::nullopt;
}

Flag unit_flag() {
  return {"--unit",
          "UNIT",
          "unit of the mesh's coordinates: " + list_of(names_of(k_units)) +
              " (default: as the file says, else mm)",
          0,
          false,
          {.choices = names_of(k_units)}};
}

Unit unit_from(const Arguments& arguments) {
  if (!arguments.has("--unit")) return arguments.stated_unit.value_or(Unit::mm);
  const std::string word = arguments.text("--unit");
  const auto unit = unit_of_word(word);
  if (!unit) refuse_number_with_unit(word);
  return unit ? *unit : unit_named(known_name("unit", word, names_of(k_units)));
}

RunUnit run_unit_from(const Arguments& arguments) {
  return {unit_from(arguments), arguments.has("--unit")};
}

ReadResult in_run_unit(ReadResult file, RunUnit unit, const std::string& path, Session& session) {
  if (unit.is_asked || !file.unit || file.unit->unit == unit.unit) return file;
  const double scale = millimetres_per(file.unit->unit) / millimetres_per(unit.unit);
  file.mesh = scaled(std::move(file.mesh), scale, path);
  session.note(path + ": the file says \"" + file.unit->words + "\": scaled from " +
               std::string(to_string(file.unit->unit)) + " to " +
               std::string(to_string(unit.unit)) + ", the unit of this run");
  return file;
}

}  // namespace planish::cli
