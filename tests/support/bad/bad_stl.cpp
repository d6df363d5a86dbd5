#include <algorithm>
#include <cctype>
#include <limits>

#include "support/bad/sound_files.h"

namespace planish::bad {
namespace {

std::string cased(std::string text, bool upper) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    const bool exponent = c == 'e' && i > 0 && std::isdigit(text[i - 1]) != 0;
    if (!exponent && (upper || i % 2 == 0)) text[i] = static_cast<char>(std::toupper(c));
  }
  return text;
}

void add_ascii(Collection& files) {
  const Lines lines = sound_stl().lines;
  const std::string plain = lines.text();
  files.same("ascii", plain);
  files.same("ascii_upper_case", cased(plain, true));
  files.same("ascii_mixed_case", cased(plain, false));
  files.same("ascii_nameless", lines.with(1, "solid").with(lines.count(), "endsolid").text());
  files.same("ascii_name_of_bytes", lines.with(1, "solid \xff\xfe\x80").text());
  files.same("ascii_name_of_keywords", lines.with(1, "solid facet vertex").text());
  files.same("ascii_other_name_behind", lines.with(lines.count(), "endsolid other").text());
  files.same("ascii_two_solids",
             lines.before(114, "solid second").before(114, "endsolid patch").text());
  files.same("ascii_an_empty_solid_more", plain + "solid nothing\nendsolid nothing\n");
  std::string one_line = plain.substr(plain.find('\n') + 1);
  std::replace(one_line.begin(), one_line.end(), '\n', ' ');
  files.same("ascii_on_one_line", "solid patch\n" + one_line);
  for (const std::string normal : {"nan nan nan", "0 0 0", "-1.#IND -1.#IND -1.#IND", "1e999 x y"})
    files.same("ascii_normal_" + std::to_string(normal.size()),
               lines.with(2, "facet normal " + normal).text());
  const auto bad = [&](const std::string& name, std::size_t line, const std::string& words,
                       std::size_t told, std::string part = {}) {
    files.at_line("ascii_" + name, lines.with(line, words).text(), k_malformed, told,
                  std::move(part));
  };
  bad("facet_of_two", 6, "endloop", 6, "expected \"vertex\", found \"endloop\"");
  bad("facet_of_four", 6, lines.at(6) + "\nvertex 1 2 3", 7,
      "expected \"endloop\", found \"vertex\"");
  bad("no_normal", 2, "facet", 3, "\"normal\"");
  bad("normal_of_two", 2, "facet normal 0 0", 3);
  bad("no_loop", 3, "outer", 4);
  bad("no_endloop", 7, "", 8);
  bad("no_endfacet", 8, "", 9);
  bad("word_unknown", 9, "faces normal 0 0 1", 9, "\"faces\"");
  files.at_line("ascii_vertex_of_two", lines.with(5, "vertex 1 2").text(), ErrorCode::bad_number, 6,
                "\"vertex\" is not a number");
  bad("vertex_of_four", 5, "vertex 1 2 3 4", 5);
  files.at_line("ascii_junk_behind", plain + "the end\n", k_malformed, lines.count() + 1);
  files.at_line("ascii_no_endsolid", lines.without(lines.count()).text(), k_truncated,
                lines.count(), "endsolid");
  files.at_line("ascii_ends_in_facet", lines.first(100).text(), k_truncated, 101);
  files.at_line("ascii_ends_in_number", lines.first(102).text() + "vertex 1 2", k_truncated, 103);
  files.at_line("ascii_empty", "solid nothing\nendsolid nothing\n", ErrorCode::no_triangles, 3);
  files.at_line("ascii_only_begun", "solid nothing\n", k_truncated, 2);
  files.same("ascii_without_solid", lines.without(1).text());
}

void add_binary_stl(Collection& files) {
  const std::string plain = binary_stl();
  files.same("binary", plain);
  files.same("binary_solid_header", binary_stl(sound(), "solid made by hand"));
  files.same("binary_solid_text_header", binary_stl(sound(), "solid\nfacet normal 0 0 1\n"));
  files.same("binary_colour_header", binary_stl(sound(), "COLOR=\xff\x80\x40\xff MATERIAL="));
  files.same("binary_header_of_zeros", binary_stl(sound(), std::string(80, '\0')));
  files.same("binary_header_of_mark", binary_stl(sound(), "\xef\xbb\xbfsolid"));
  files.same("binary_header_as_zip", binary_stl(sound(), "PK\3\4"));
  files.same("binary_header_as_utf16", binary_stl(sound(), "\xff\xfes"));
  files.same("binary_bytes_behind", plain + std::string(7, '\x5a'), "7 bytes");
  files.same("binary_nan_normal",
             patched(plain, 84 + 50 * 3, std::numeric_limits<float>::quiet_NaN()));
  std::string attributes = plain;
  for (std::size_t t = 0; t < 32; ++t)
    attributes = patched(attributes, 84 + 50 * t + 48, std::uint16_t{0xffff});
  files.same("binary_attributes", attributes);
  for (const NamedPlace& place : places_in(32)) {
    const std::size_t facet = 84 + 50 * place.number;
    for (const float value :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
      files.at_byte("binary_" + std::string(value > 0 ? "inf_" : "nan_") + place.name,
                    patched(plain, facet + 28, value), ErrorCode::non_finite_coordinate, facet);
    }
    // Two corners at one place.
    files.as_mesh("binary_degenerate_" + place.name,
                  std::string(plain).replace(facet + 24, 12, plain.substr(facet + 12, 12)),
                  ErrorCode::repeated_index, place.number);
  }
  for (const std::uint32_t count : {33U, 1000U, 0x7fffffffU, 0x80000000U, 0xffffffffU}) {
    files.at_byte("binary_count_" + std::to_string(count), patched(plain, 80, count), k_truncated,
                  84, std::to_string(count));
  }
  files.as_a_whole("binary_count_0", patched(plain, 80, std::uint32_t{0}), ErrorCode::no_triangles);
  files.as_a_whole("binary_count_31", patched(plain, 80, std::uint32_t{31}), k_malformed, "31");
  files.as_a_whole("binary_count_1", patched(plain, 80, std::uint32_t{1}), k_malformed);
  files.as_a_whole("binary_count_big_endian", patched(plain, 80, std::uint32_t{0x20000000}),
                   k_truncated);
  for (const std::size_t cut : {40UL, 80UL, 83UL, 84UL, 85UL, 133UL, 134UL, 500UL,
                                static_cast<unsigned long>(plain.size() - 1)}) {
    // As long as there is only the header, it could be text.
    files.as_a_whole("binary_cut_after_" + std::to_string(cut), plain.substr(0, cut),
                     cut <= 80 ? k_malformed : k_truncated);
  }
  files.as_a_whole("binary_empty", plain.substr(0, 80) + std::string(4, '\0'),
                   ErrorCode::no_triangles);
}

}  // namespace

BadMeshes bad_stl() {
  Collection files("stl_", ".stl");
  add_ascii(files);
  add_binary_stl(files);
  return files.take();
}

}  // namespace planish::bad
