#include <algorithm>
#include <limits>

#include "support/bad/sound_files.h"

namespace planish::bad {
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

void add_ply_headers(Collection& files) {
  const SoundText text = sound_ply();
  const Lines& lines = text.lines;
  const auto odd = [&](const std::string& name, std::size_t line, const std::string& words) {
    files.same("header_" + name, lines.before(line, words).text());
  };
  odd("comment", 3, "comment made by \xff hand");
  odd("comment_empty", 3, "comment");
  odd("obj_info", 3, "obj_info num_cols 5");
  odd("comment_before_format", 2, "comment first");
  odd("comment_end_header", 3, "comment end_header");
  odd("empty_element_of_material", 9, "element material 0\nproperty int x");
  files.same("header_crlf_only", [&] {
    Lines crlf = lines;
    for (std::size_t line = 1; line <= 9; ++line)
      crlf = crlf.with(line, crlf.at(line) + "\r");
    return crlf.text();
  }());
  for (const std::string type : {"double", "float64", "float32", "float"}) {
    Lines typed = lines;
    for (std::size_t line = 4; line <= 6; ++line)
      typed = typed.with(line, replaced(typed.at(line), "float", type));
    files.same("vertices_of_" + type, typed.text());
  }
  for (const std::string type : {"char", "int8", "uchar", "uint8", "short", "int16", "ushort",
                                 "uint16", "int", "int32", "uint", "uint32", "float", "double"}) {
    files.same("indices_of_" + type,
               lines.with(8, "property list uchar " + type + " vertex_indices").text());
    files.same("lengths_of_" + type,
               lines.with(8, "property list " + type + " int vertex_indices").text());
  }
  files.same("list_vertex_index", lines.with(8, "property list uchar int vertex_index").text());

  const auto bad = [&](const std::string& name, std::size_t line, const std::string& words,
                       ErrorCode code, std::string part = {}) {
    files.at_line("header_" + name, lines.with(line, words).text(), code, line, std::move(part));
  };
  bad("no_ply", 1, "PLY", k_malformed, "begins with a line");
  bad("ply_and_more", 1, "ply file", k_malformed);
  bad("format_missing", 2, "format", k_malformed);
  bad("format_unknown", 2, "format binary_middle_endian 1.0", k_malformed, "encoding");
  bad("format_upper", 2, "format ASCII 1.0", k_malformed);
  bad("statement_unknown", 2, "material red", k_malformed, "statement");
  bad("count_missing", 3, "element vertex", k_malformed);
  bad("count_negative", 3, "element vertex -5", k_malformed, "count");
  bad("count_fraction", 3, "element vertex 25.5", k_malformed);
  bad("count_exponent", 3, "element vertex 2.5e1", k_malformed);
  bad("count_hexadecimal", 3, "element vertex 0x19", k_malformed);
  bad("count_letters", 3, "element vertex 25x", k_malformed);
  bad("count_comma", 3, "element vertex 2,5", k_malformed);
  bad("type_unknown", 4, "property half x", k_malformed, "type");
  bad("type_missing", 4, "property", k_malformed);
  bad("name_missing", 4, "property float", k_malformed);
  bad("list_of_nothing", 8, "property list uchar int", k_malformed);
  bad("list_type_unknown", 8, "property list byte int vertex_indices", k_malformed);
  bad("property_first", 3, "property float x", k_malformed, "before the first element");
  bad("element_nameless", 7, "element", k_malformed);
  bad("vertices_twice", 7, lines.at(3), k_malformed, "twice");
  bad("x_twice", 6, "property float x", k_malformed, "twice");
  files.at_line("header_indices_twice", lines.before(9, lines.at(8)).text(), k_malformed, 9,
                "twice");
  bad("end_and_more", 9, "end_header now", k_malformed);
  files.as_a_whole("header_no_format", lines.without(2).text(), k_malformed, "no format");
  files.as_a_whole("header_no_end", lines.without(9).text(), k_malformed);
  files.at_line("header_only_ply", "ply\n", k_truncated, 2);
  files.at_line("header_ends_early", lines.first(5).text(), k_truncated, 6, "end_header");
  files.as_a_whole("header_no_z", lines.without(6).text(), k_malformed, "x, y and z");
  files.as_a_whole("header_list_as_x", lines.with(4, "property list uchar float x").text(),
                   k_malformed, "x, y and z");
  files.as_a_whole("header_no_vertices", lines.without(6).without(5).without(4).without(3).text(),
                   k_malformed, "vertex");
  files.as_a_whole("header_no_faces", lines.without(8).without(7).text(), ErrorCode::no_triangles);
  files.as_a_whole("header_faces_without_list", lines.with(8, "property int vertex_indices").text(),
                   k_malformed);
  files.as_a_whole("header_vertices_without_numbers", lines.without(6).without(5).without(4).text(),
                   k_malformed);
  files.as_a_whole("strips_of_triangles",
                   lines.with(7, "element tristrips 1")
                       .with(8, "property list int int vertex_indices")
                       .first(34)
                       .before(35, "8 0 5 1 6 2 7 -1 8")
                       .text(),
                   ErrorCode::unsupported_format, "strips");
}

void add_ply_counts(Collection& files) {
  const SoundText text = sound_ply();
  const Lines& lines = text.lines;
  const std::string binary = binary_ply();
  for (const std::string count : {"26", "33", "1000", "4294967295", "4294967296", "4000000000000",
                                  "18446744073709551615", "99999999999999999999999"}) {
    files.as_a_whole("vertex_count_" + count, lines.with(3, "element vertex " + count).text(),
                     count == "26" || count == "33" ? k_malformed : k_truncated);
    if (count == "26") continue;
    files.as_a_whole("face_count_" + count, lines.with(7, "element face " + count).text(),
                     k_truncated);
    files.as_a_whole("binary_face_count_" + count, replaced(binary, "face 32", "face " + count),
                     k_truncated);
    files.as_a_whole("binary_vertex_count_" + count,
                     replaced(binary, "vertex 25", "vertex " + count), k_truncated);
  }
  files.as_a_whole("vertex_count_too_small", lines.with(3, "element vertex 24").text(),
                   k_malformed);
  files.as_a_whole("vertex_count_0", lines.with(3, "element vertex 0").text(), k_malformed);
  files.at_line("face_count_too_small", lines.with(7, "element face 31").text(), k_malformed, 66,
                "31");
  files.at_line("face_count_1", lines.with(7, "element face 1").text(), k_malformed, 36);
  files.as_a_whole("face_count_0", lines.with(7, "element face 0").text(), ErrorCode::no_triangles);
}

void add_ply_bodies(Collection& files) {
  const SoundText text = sound_ply();
  const Lines& lines = text.lines;
  const auto vertex = [&](const std::string& name, const std::string& words, ErrorCode code,
                          std::size_t line) {
    files.at_line("vertex_" + name, lines.with(14, words).text(), code, line);
  };
  vertex("of_two", "1 2", k_malformed, 15);
  vertex("of_four", "1 2 3 4", k_malformed, 14);
  vertex("of_none", "", k_malformed, 35);
  const auto face = [&](const std::string& name, const std::string& words, ErrorCode code,
                        std::size_t line) {
    files.at_line("face_" + name, lines.with(40, words).text(), code, line);
  };
  face("of_none", "0", k_malformed, 40);
  face("of_one", "1 3", k_malformed, 40);
  face("of_two", "2 3 4", k_malformed, 40);
  face("too_short", "3 0 1", k_malformed, 41);
  face("too_long", "3 0 1 2 3", k_malformed, 40);
  face("length_negative", "-3 0 1 2", k_malformed, 40);
  face("length_fraction", "3.5 0 1 2", k_malformed, 40);
  face("length_letter", "a 0 1 2", ErrorCode::bad_number, 40);
  face("repeats", "4 0 1 2 1", k_malformed, 40);
  files.same("long_lines_broken", [&] {
    std::string broken = lines.first(9).text();
    for (std::size_t line = 10; line <= lines.count(); ++line) {
      std::string words = lines.at(line);
      std::replace(words.begin(), words.end(), ' ', '\n');
      broken += words + "\n";
    }
    return broken;
  }());
}

void add_elements(Collection& files) {
  const SoundText text = sound_ply();
  const Lines& lines = text.lines;
  std::string faces_first = lines.first(2).text() + lines.at(7) + "\n" + lines.at(8) + "\n";
  for (std::size_t line = 3; line <= 6; ++line)
    faces_first += lines.at(line) + "\n";
  faces_first += "end_header\n";
  for (std::size_t line = 35; line <= 66; ++line)
    faces_first += lines.at(line) + "\n";
  for (std::size_t line = 10; line <= 34; ++line)
    faces_first += lines.at(line) + "\n";
  files.same("faces_first", faces_first);
  files.same("unknown_element_between", lines.before(35, "2 7 8")
                                            .before(35, "0")
                                            .before(7, "property list uchar float b")
                                            .before(7, "element chain 2")
                                            .text());
  files.same("unknown_element_first", lines.before(10, "1.5 x")
                                          .before(3, "property int b")
                                          .before(3, "property float a")
                                          .before(3, "element odd 1")
                                          .text());
  files.same("unknown_element_last", lines.before(67, "0 1")
                                         .before(67, "1 2")
                                         .before(9, "property int v2")
                                         .before(9, "property int v1")
                                         .before(9, "element edge 2")
                                         .text());
  Lines more = lines;
  for (std::size_t line = 35; line <= 66; ++line)
    more = more.with(line, "255 " + lines.at(line) + " 2 0.5 0.5");
  for (std::size_t line = 10; line <= 34; ++line)
    more = more.with(line, "nan " + lines.at(line) + " 9 9 9");
  files.same("more_properties", more.before(9, "property list uchar float texcoord")
                                    .before(8, "property uchar flags")
                                    .before(7, "property uchar blue")
                                    .before(7, "property uchar green")
                                    .before(7, "property uchar red")
                                    .before(4, "property float confidence")
                                    .text());
}

void add_binary_ply(Collection& files) {
  const std::string sound_bytes = binary_ply();
  const std::size_t body = binary_ply_body(sound_bytes), faces = body + 25 * 12;
  files.same("binary", sound_bytes);
  std::string big = replaced(sound_bytes, "little", "big");
  const std::size_t big_body = binary_ply_body(big);
  for (std::size_t i = 0; i < 75; ++i)
    std::reverse(big.begin() + static_cast<std::ptrdiff_t>(big_body + 4 * i),
                 big.begin() + static_cast<std::ptrdiff_t>(big_body + 4 * i + 4));
  for (std::size_t i = 0; i < 96; ++i) {
    const auto at = static_cast<std::ptrdiff_t>(big_body + 300 + 13 * (i / 3) + 1 + 4 * (i % 3));
    std::reverse(big.begin() + at, big.begin() + at + 4);
  }
  files.same("binary_big_endian", big);
  files.same("binary_byte_order_mark", "\xef\xbb\xbf" + sound_bytes);
  files.same("binary_bytes_behind", sound_bytes + std::string(100, '\x5a'), "100 bytes");
  std::string crlf = sound_bytes.substr(0, body);
  for (std::size_t at = 0; (at = crlf.find('\n', at)) != std::string::npos; at += 2)
    crlf.insert(at, "\r");
  files.same("binary_header_crlf", crlf + sound_bytes.substr(body));
  files.as_a_whole("binary_as_big_endian", replaced(sound_bytes, "little", "big"),
                   ErrorCode::index_out_of_range);
  files.as_a_whole("binary_as_ascii", replaced(sound_bytes, "binary_little_endian", "ascii"),
                   ErrorCode::bad_number);
  files.as_a_whole("ascii_as_binary",
                   replaced(sound_ply().lines.text(), "ascii", "binary_little_endian"),
                   ErrorCode::index_out_of_range);
  const auto bad_float = [&](const std::string& name, std::size_t vertex, float value) {
    files.at_byte("binary_" + name, patched(sound_bytes, body + 12 * vertex + 4, value),
                  ErrorCode::non_finite_coordinate, body + 12 * vertex);
  };
  for (const NamedPlace& place : places_in(25)) {
    bad_float("nan_" + place.name, place.number, std::numeric_limits<float>::quiet_NaN());
    bad_float("signalling_nan_" + place.name, place.number,
              std::numeric_limits<float>::signaling_NaN());
    bad_float("inf_" + place.name, place.number, std::numeric_limits<float>::infinity());
    bad_float("minus_inf_" + place.name, place.number, -std::numeric_limits<float>::infinity());
  }
  for (const NamedPlace& place : places_in(32)) {
    const std::size_t at = faces + 13 * place.number;
    for (const std::int32_t index : {25, -1, 2147483647, -2147483647 - 1, 16777216}) {
      files.at_byte("binary_index_" + std::string(index < 0 ? "minus_" : "") +
                        std::to_string(index < 0 ? 0U - static_cast<std::uint32_t>(index)
                                                 : static_cast<std::uint32_t>(index)) +
                        "_" + place.name,
                    patched(sound_bytes, at + 5, index), ErrorCode::index_out_of_range, at);
    }
    for (const int length : {0, 1, 2}) {
      files.at_byte("binary_length_" + std::to_string(length) + "_" + place.name,
                    patched(sound_bytes, at, static_cast<char>(length)), k_malformed, at);
    }
    for (const int length : {4, 255}) {
      files.either("binary_length_" + std::to_string(length) + "_" + place.name,
                   patched(sound_bytes, at, static_cast<char>(length)));
    }
  }
  for (const std::size_t cut : {body, body + 1, body + 150, faces - 1, faces, faces + 1,
                                faces + 200, sound_bytes.size() - 13, sound_bytes.size() - 1}) {
    files.as_a_whole("binary_cut_after_" + std::to_string(cut), sound_bytes.substr(0, cut),
                     k_truncated);
  }
}

}  // namespace

BadMeshes bad_ply() {
  Collection files("ply_", ".ply");
  add_ply_headers(files);
  add_ply_counts(files);
  add_ply_bodies(files);
  add_elements(files);
  add_binary_ply(files);
  return files.take();
}

}  // namespace planish::bad
