#include <cstdio>

#include "support/bad/sound_files.h"

namespace planish::bad {
namespace {

using namespace std::string_literals;

struct NumberWord {
  std::string name, text;
};

const std::vector<NumberWord>& no_numbers() {
  static const std::vector<NumberWord> words = {{"letter", "x"},
                                                {"hexadecimal", "0x10"},
                                                {"hexadecimal_float", "0x1p3"},
                                                {"binary", "0b1"},
                                                {"letters_behind", "1abc"},
                                                {"float_suffix", "1.5f"},
                                                {"percent", "50%"},
                                                {"millimetres", "5mm"},
                                                {"decimal_comma", "0,5"},
                                                {"thousands_comma", "1,000.5"},
                                                {"thousands_and_comma", "1.234,5"},
                                                {"thousands_quote", "1'000"},
                                                {"thousands_underscore", "1_000"},
                                                {"two_points", "1.2.3"},
                                                {"no_exponent", ".5e"},
                                                {"no_exponent_digits", "1e+"},
                                                {"fortran_exponent", "1d5"},
                                                {"fraction_in_exponent", "1e0.5"},
                                                {"two_plus", "++1"},
                                                {"two_minus", "--1"},
                                                {"plus_minus", "+-1"},
                                                {"sign_behind", "1-"},
                                                {"sign_alone", "-"},
                                                {"point_alone", "."},
                                                {"exponent_alone", "e5"},
                                                {"windows_nan", "1.#QNAN"},
                                                {"windows_ind", "-1.#IND"},
                                                {"windows_inf", "1.#INF"},
                                                {"comment_behind", "1#2"},
                                                {"null", "null"},
                                                {"none", "None"},
                                                {"true", "true"},
                                                {"quoted", "\"1\""},
                                                {"bracketed", "(1)"},
                                                {"fraction", "1/2"},
                                                {"semicolon", "1;"},
                                                {"nul_behind", "1\0"s},
                                                {"nul_in_front", "\0001"s},
                                                {"nul_alone", "\0"s},
                                                {"control_character", "1\x1a"},
                                                {"arabic_digit", "\xd9\xa1"},
                                                {"full_width_digit", "\xef\xbc\x91"},
                                                {"minus_of_typography",
                                                 "\xe2\x88\x92"
                                                 "1"},
                                                {"no_break_space", "1\xc2\xa0"},
                                                {"byte_order_mark",
                                                 "\xef\xbb\xbf"
                                                 "1"},
                                                {"latin1_byte", "1\xb5"},
                                                {"too_large", "1e400"},
                                                {"too_large_negative", "-1e400"},
                                                {"too_many_digits", std::string(400, '9')}};
  return words;
}

const std::vector<NumberWord>& not_finite() {
  static const std::vector<NumberWord> words = {
      {"nan", "nan"},           {"nan_upper", "NaN"},     {"nan_negative", "-nan"},
      {"nan_plus", "+nan"},     {"nan_tagged", "nan(1)"}, {"inf", "inf"},
      {"inf_negative", "-inf"}, {"inf_upper", "INF"},     {"infinity", "Infinity"}};
  return words;
}

/// A vertex's line with a word instead of one of its numbers.
Lines with_word(const SoundText& text, std::size_t vertex, std::size_t axis,
                const std::string& word) {
  std::array<std::string, 3> words = {"0.5", "1", "2"};
  words[axis] = word;
  return text.lines.with(text.vertex_line(vertex),
                         text.before_vertex + three(words[0], words[1], words[2]));
}

/// The sound patch with every coordinate written in another way.
template <class Write>
std::string rewritten(const SoundText& text, Write write) {
  const TriMesh mesh = sound();
  std::string changed = text.lines.first(text.first_vertex - 1).text();
  const auto add = [&](Vec3 p) {
    changed += text.before_vertex + three(write(p.x), write(p.y), write(p.z)) + "\n";
  };
  if (text.format == "stl") {
    for (const Triangle& t : mesh.triangles) {
      if (&t != mesh.triangles.data()) changed += "facet normal 0 0 1\nouter loop\n";
      for (const Index v : t)
        add(mesh.positions[v]);
      changed += "endloop\nendfacet\n";
    }
    return changed + "endsolid patch\n";
  }
  for (const Vec3& p : mesh.positions)
    add(p);
  for (std::size_t line = text.first_face; line <= text.lines.count(); ++line)
    changed += text.lines.at(line) + "\n";
  return changed;
}

std::string printed(const char* format, double value) {
  char text[100];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string without_leading_zero(double value) {
  std::string text = printed("%.20f", value);
  const auto zero = text.find("0.");
  if (zero == 0 || (zero == 1 && text[0] == '-')) text.erase(zero, 1);
  return text;
}

void add_notations(const SoundText& text, Collection& collection) {
  const auto add = [&](const std::string& name, auto write) {
    collection.same("number_" + name, rewritten(text, write));
  };
  add("fixed", [](double c) { return printed("%.30f", c); });
  add("scientific", [](double c) { return printed("%.17e", c); });
  add("scientific_upper", [](double c) { return printed("%.17E", c); });
  add("plus_sign", [](double c) { return printed("%+.17g", c); });
  add("leading_zeros", [](double c) { return printed("%050.30f", c); });
  add("no_leading_zero", without_leading_zero);
  add("long_digits", [](double c) { return printed("%.70f", c); });
}

BadMeshes numbers_in(const SoundText& text) {
  Collection collection(text.format + "_", text.extension());
  const std::size_t count =
      text.format == "stl" ? sound().triangles.size() : sound().positions.size();
  for (const NamedPlace& place : places_in(count)) {
    std::size_t axis = 0;
    for (const NumberWord& word : no_numbers()) {
      collection.at_line("number_" + word.name + "_" + place.name,
                         with_word(text, place.number, axis++ % 3, word.text).text(),
                         ErrorCode::bad_number, text.vertex_line(place.number));
    }
    for (const NumberWord& word : not_finite()) {
      collection.at_line("number_" + word.name + "_" + place.name,
                         with_word(text, place.number, axis++ % 3, word.text).text(),
                         ErrorCode::non_finite_coordinate, text.vertex_line(place.number));
    }
  }
  add_notations(text, collection);
  collection.accept("number_too_small", with_word(text, 0, 2, "1e-400").text());
  collection.accept("number_minus_zero", with_word(text, 0, 2, "-0").text());
  collection.accept("number_denormal", with_word(text, 0, 2, "5e-324").text());
  return collection.take();
}

}  // namespace

BadMeshes bad_numbers() {
  BadMeshes all;
  for (const SoundText& text : {sound_obj(), sound_off(), sound_ply(), sound_stl()})
    append(all, numbers_in(text));
  return all;
}

}  // namespace planish::bad
