#include "support/bad/sound_files.h"

namespace planish::bad {
namespace {

/// The sound patch with something behind each vertex and each face.
Lines with_tails(const std::string& header, const std::string& vertex, const std::string& face) {
  const SoundText text = sound_off();
  Lines lines = text.lines.with(1, header);
  for (std::size_t line = 3; line < 28; ++line)
    lines = lines.with(line, lines.at(line) + vertex);
  for (std::size_t line = 28; line <= lines.count(); ++line)
    lines = lines.with(line, lines.at(line) + face);
  return lines;
}

void add_off_headers(Collection& files) {
  const Lines lines = sound_off().lines;
  files.same("colours_coff", with_tails("COFF", " 255 0 0 255", "").text(), "dropped");
  files.same("normals_noff", with_tails("NOFF", " 0 0 1", "").text(), "dropped");
  files.same("texture_stoff", with_tails("STOFF", " 0.5 0.5", "").text(), "dropped");
  files.same("all_stcnoff", with_tails("STCNOFF", " 0 0 1 1 0 0 1 0.5 0.5", "").text(), "dropped");
  files.same("colours_unannounced", with_tails("OFF", " 255 0 0", "").text(), "dropped");
  files.same("colours_of_faces", with_tails("OFF", "", " 0.5 0.5 1").text());
  files.same("colour_numbers_of_faces", with_tails("OFF", "", " 7").text());
  files.same("comments_behind", with_tails("OFF # a", " # b", " # c").text());
  files.same("counts_on_the_first_line", lines.without(2).with(1, "OFF 25 32 56").text());
  files.same("counts_without_edges", lines.with(2, "25 32").text());
  files.same("counts_wrong_edges", lines.with(2, "25 32 999999").text());
  files.same("comments_between", [&] {
    std::string text;
    for (std::size_t line = 1; line <= lines.count(); ++line)
      text += "# " + std::to_string(line) + "\n\n" + lines.at(line) + "\n";
    return text;
  }());
  const auto header = [&](const std::string& word, ErrorCode code) {
    files.at_line("header_" + word, lines.with(1, word).text(), code, 1, "\"" + word + "\"");
  };
  for (const std::string word : {"4OFF", "nOFF", "ST4OFF", "C4nOFF"})
    header(word, ErrorCode::unsupported_format);
  for (const std::string word : {"off", "Off", "OBJ", "OFFX", "0FF"})
    header(word, k_malformed);
  files.at_line("header_missing", lines.without(1).text(), k_malformed, 1, "begins with OFF");
  files.at_line("header_binary", "OFF BINARY\n" + std::string(200, '\0'),
                ErrorCode::unsupported_format, 1, "binary");
  files.as_a_whole("header_only", "OFF\n", k_truncated);
}

void add_off_counts(Collection& files) {
  const Lines lines = sound_off().lines;
  const auto counts = [&](const std::string& name, const std::string& words, ErrorCode code) {
    files.at_line("counts_" + name, lines.with(2, words).text(), code, 2);
  };
  counts("one", "25", k_malformed);
  counts("negative", "-25 32 0", k_malformed);
  counts("negative_faces", "25 -32 0", k_malformed);
  counts("fraction", "25.5 32 0", k_malformed);
  counts("letters", "25 32x 0", k_malformed);
  counts("hexadecimal", "0x19 32 0", k_malformed);
  counts("letters_of_edges", "25 32 many", k_malformed);
  counts("no_faces", "25 0 0", ErrorCode::no_triangles);
  for (const std::string huge :
       {"1000000", "4294967295", "4294967297", "18446744073709551615", "99999999999999999999999"}) {
    counts("vertices_" + huge, huge + " 32 0", k_truncated);
    counts("faces_" + huge, "25 " + huge + " 0", k_truncated);
  }
  files.at_line("counts_one_vertex_more", lines.with(2, "26 32 0").text(), k_malformed, 28);
  files.as_a_whole("counts_one_face_more", lines.with(2, "25 33 0").text(), k_truncated);
  files.as_a_whole("counts_one_vertex_less", lines.with(2, "24 32 0").text(), k_malformed);
  files.at_line("counts_one_face_less", lines.with(2, "25 31 0").text(), k_malformed, 59, "31");
  files.at_line("counts_swapped", lines.with(2, "32 25 0").text(), k_malformed, 28);
  files.as_a_whole("counts_no_vertices", lines.with(2, "0 32 0").text(), k_malformed);
}

void add_off_bodies(Collection& files) {
  const Lines lines = sound_off().lines;
  const auto bad = [&](const std::string& name, std::size_t line, const std::string& words,
                       ErrorCode code, std::string part = {}) {
    files.at_line(name, lines.with(line, words).text(), code, line, std::move(part));
  };
  bad("vertex_of_one", 10, "1", k_malformed);
  bad("vertex_of_two", 10, "1 2", k_malformed);
  bad("vertex_of_two_and_comment", 10, "1 2 # 3", k_malformed);
  bad("face_of_none", 40, "0", k_malformed, "3 corners");
  bad("face_of_one", 40, "1 5", k_malformed);
  bad("face_of_two", 40, "2 5 6", k_malformed);
  bad("face_too_short", 40, "3 5 6", k_malformed);
  bad("face_length_negative", 40, "-3 5 6 7", k_malformed);
  bad("face_length_fraction", 40, "3.0 5 6 7", k_malformed);
  bad("face_length_letters", 40, "three 5 6 7", k_malformed);
  bad("face_length_huge", 40, "4294967299 5 6 7", k_malformed);
  bad("face_length_wraps", 40, "18446744073709551619 5 6 7", k_malformed);
  bad("face_length_too_large", 40, "300 5 6 7", k_malformed);
  bad("face_repeats", 40, "4 5 6 7 6", k_malformed, "vertex twice");
  files.at_line("vertex_missing", lines.without(10).text(), k_malformed, 27, "4 numbers");
  files.at_line("vertex_of_four", lines.with(10, "1 2 3 4").text(), k_malformed, 10, "4 numbers");
  files.as_a_whole("face_missing", lines.without(40).text(), k_truncated);
}

}  // namespace

BadMeshes bad_off() {
  Collection files("off_", ".off");
  add_off_headers(files);
  add_off_counts(files);
  add_off_bodies(files);
  return files.take();
}

}  // namespace planish::bad
