#include <algorithm>
#include <cmath>

#include "support/bad/sound_files.h"

namespace planish::bad {
namespace {

/// The sound patch with every face written in another way.
template <class Write>
std::string with_faces(Write write) {
  SoundText text = sound_obj();
  const TriMesh mesh = sound();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::string line = "f";
    for (const Index v : mesh.triangles[t])
      line += " " + write(static_cast<long long>(v));
    text.lines = text.lines.with(text.face_line(t), line);
  }
  return text.lines.text();
}

template <class Write>
std::string with_vertices(Write write) {
  SoundText text = sound_obj();
  const TriMesh mesh = sound();
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    text.lines = text.lines.with(text.vertex_line(v), write(numbers(mesh.positions[v])));
  return text.lines.text();
}

void add_faces(Collection& files) {
  const auto n = [](long long v) { return std::to_string(v); };
  const auto back = [n](long long v) { return n(v - 25); };
  const std::string attributes = "vt 0 0\nvn 0 0 1\n";
  const auto faces = [&](const std::string& name, auto write) {
    files.same("faces_" + name, attributes + with_faces(write));
  };
  faces("v_vt", [&](long long v) { return n(v + 1) + "/1"; });
  faces("v_vt_vn", [&](long long v) { return n(v + 1) + "/1/1"; });
  faces("v_vn", [&](long long v) { return n(v + 1) + "//1"; });
  faces("v_slash", [&](long long v) { return n(v + 1) + "/"; });
  faces("v_slashes", [&](long long v) { return n(v + 1) + "//"; });
  faces("v_vt_slash", [&](long long v) { return n(v + 1) + "/1/"; });
  faces("negative", back);
  faces("all_negative", [&](long long v) { return back(v) + "/-1/-1"; });
  faces("plus", [&](long long v) { return "+" + n(v + 1); });
  faces("leading_zeros", [&](long long v) { return "000000000000000000000000" + n(v + 1); });
  faces("vt_out_of_range", [&](long long v) { return n(v + 1) + "/99999/99999"; });

  SoundText text = sound_obj();
  const std::size_t line = text.face_line(3);
  const auto face = [&](const std::string& name, const std::string& words, std::string part) {
    files.at_line("face_" + name, text.lines.before(line, words).text(), k_malformed, line,
                  std::move(part));
  };
  face("of_none", "f", "3 corners");
  face("of_one", "f 1", "3 corners");
  face("of_two", "f 1 2", "3 corners");
  face("of_two_and_comment", "f 1 2 # 3", "3 corners");
  face("polygon_repeats", "f 1 2 3 2", "vertex twice");
  face("polygon_crosses_itself", "f 1 3 2 4", "crosses itself");
  face("upper_case", "F 1 2 3", "\"F\"");
  face("without_blank", "f1 2 3", "\"f1\"");
  std::string many = "f";
  for (int i = 0; i < 60000; ++i)
    many += " " + std::to_string(1 + i % 3);
  face("of_60000", many, "60000 corners");
}

void add_vertices(Collection& files) {
  const auto vertices = [&](const std::string& name, const std::string& behind,
                            const std::string& part = {}) {
    files.same("vertices_" + name,
               with_vertices([&](const std::string& xyz) { return "v " + xyz + behind; }), part);
  };
  vertices("with_weight", " 1.0");
  vertices("with_colour", " 0.5 0.25 1", "colours");
  vertices("with_colour_and_opacity", " 0.5 0.25 1 1", "colours");
  vertices("with_comment", " # 12");
  files.same("vertices_tab_first",
             with_vertices([](const std::string& xyz) { return "\tv\t" + xyz; }));
  SoundText text = sound_obj();
  const auto vertex = [&](const std::string& name, const std::string& words, ErrorCode code) {
    files.at_line("vertex_" + name, text.lines.with(12, words).text(), code, 12);
  };
  vertex("of_none", "v", k_malformed);
  vertex("of_one", "v 1", k_malformed);
  vertex("of_two", "v 1 2", k_malformed);
  vertex("of_two_and_comment", "v 1 2 # 3", k_malformed);
  vertex("of_five", "v 1 2 3 4 5", k_malformed);
  vertex("of_eight", "v 1 2 3 4 5 6 7 8", k_malformed);
  vertex("colour_no_number", "v 1 2 3 red green blue", ErrorCode::bad_number);
  vertex("weight_nan", "v 1 2 3 nan", ErrorCode::non_finite_coordinate);
  vertex("upper_case", "V 1 2 3", k_malformed);
  vertex("without_blank", "v1 2 3", k_malformed);
  vertex("with_mark", "\xef\xbb\xbfv 1 2 3", k_malformed);
  vertex("with_nul", std::string("v\0 1 2 3", 8), k_malformed);
}

void add_statements(Collection& files) {
  const SoundText text = sound_obj();
  const std::string plain = text.lines.text();
  const auto odd = [&](const std::string& name, const std::string& line, std::string part = {}) {
    files.same("statement_" + name, text.lines.before(30, line).text(), std::move(part));
    files.same("statement_" + name + "_first", line + "\n" + plain);
    files.same("statement_" + name + "_last", plain + line);
  };
  odd("comment", "# v 1 2 3");
  odd("comment_backslash", "# a path\\");
  odd("comment_bytes", "# \xff\xfe\x80\x01");
  odd("material_missing", "mtllib missing file.mtl");
  odd("group_latin1",
      "g Stra\xdf"
      "e \xff");
  odd("group_nameless", "g");
  odd("object", "o part #2");
  odd("smooth", "s off");
  odd("texture", "vt 0.5 nan");
  odd("normal", "vn 0 0 0");
  odd("line", "l 1 2 3", "statements of kinds l");
  odd("point", "p 1", "statements of kinds p");
  odd("parameter_vertex", "vp 0.5 0.5", "vp");
  odd("curve", "curv 0 1 1 2 3", "curv");
  odd("surface", "surf 0 1 0 1 1 2 3 4", "surf");
  odd("end", "end", "end");
  odd("call", "call other.obj", "call");
  odd("csh", "csh rm -r", "unknown");
  odd("unknown", "hello world", "unknown");
  odd("unknown_bytes", "\x01\x02\x03", "unknown");
  odd("backslash_blank", "\\ ", "unknown");
  odd("merge_marks", "<<<<<<< HEAD", "unknown");
}

void add_lines(Collection& files) {
  const SoundText text = sound_obj();
  const std::string plain = text.lines.text();
  std::string continued;
  for (const char c : plain)
    continued += c == ' ' ? " \\\n" : std::string(1, c);
  files.same("continued_at_blanks", continued);
  files.at_line("continued_number_error", "v 0 0 \\\n\\\n x\n" + plain, ErrorCode::bad_number, 3);
  files.either("continued_in_number", text.lines.with(3, "v 0.\\\n5 1 2").text());
  files.at_line("backslash_and_blank", text.lines.with(26, "f 1 2 \\ \n3").text(),
                ErrorCode::bad_number, 26);
  files.at_line(
      "continued_past_end",
      text.lines.with(57, "f 1 2 \\").text().substr(0, plain.size() - text.lines.at(57).size() + 6),
      ErrorCode::bad_number, 57);
  files.same("long_comment", "# " + std::string(200'000, 'x') + "\n" + plain);
  files.same("long_name", "g " + std::string(200'000, 'x') + "\n" + plain);
  files.same("long_blank", std::string(200'000, ' ') + "\n" + plain);
  files.same("many_empty_lines", std::string(100'000, '\n') + plain);
  files.at_line("long_word", text.lines.with(5, "v 0 0 " + std::string(200'000, '7') + "x").text(),
                ErrorCode::bad_number, 5);
  const auto faces = plain.find('f');
  files.same("faces_first", plain.substr(faces) + plain.substr(0, faces));
  files.at_line("no_faces", plain.substr(0, faces), ErrorCode::no_triangles, 26, "25 vertices");
  files.at_line("no_vertices", plain.substr(faces), ErrorCode::index_out_of_range, 1, "0 vertices");
  files.at_line("comments_only", "# nothing\n# at all\n", ErrorCode::no_triangles, 3);
  files.at_line("lines_only", plain.substr(0, faces) + "l 1 2 3\n", ErrorCode::no_triangles, 27);
  files.at_line(
      "upper_case",
      [&] {
        std::string upper = plain;
        std::replace(upper.begin(), upper.end(), 'v', 'V');
        std::replace(upper.begin(), upper.end(), 'f', 'F');
        return upper;
      }(),
      k_malformed, 1, "\"V\"");
  files.at_line("page_of_errors_behind", plain + "v <html>\n", ErrorCode::bad_number, 58);
}

/// A grid of quads, whose diagonals are chosen by their form; and polygons.
void add_polygons(Collection& files) {
  const std::string plain = sound_obj().lines.text();
  std::string quads = plain.substr(0, plain.find('f'));
  for (int j = 0; j < 4; ++j) {
    for (int i = 1; i <= 4; ++i) {
      const int a = 5 * j + i;
      quads += "f " + std::to_string(a) + " " + std::to_string(a + 1) + " " +
               std::to_string(a + 6) + " " + std::to_string(a + 5) + "\n";
    }
  }
  files.accept("quads", quads);
  const std::string ring = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\n";
  files.accept("polygon_concave", ring + "f 1 2 3 4 5\n");
  files.accept("polygon_concave_from_its_bay", ring + "f 4 5 1 2 3\n");
  files.accept("polygon_not_plane", "v 0 0 0\nv 2 0 1\nv 2 2 0\nv 0 2 1\nv 1 1 3\nf 1 2 3 4\n",
               ErrorCode::unreferenced_vertex);
  files.accept("polygon_of_no_area", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 2 3 4\n",
               ErrorCode::zero_area);
  files.as_mesh("polygon_at_one_place", "v 1 1 1\nv 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3 4\n",
                ErrorCode::zero_length_edge, 0);
}

}  // namespace

BadMeshes bad_obj() {
  Collection files("obj_", ".obj");
  add_faces(files);
  add_vertices(files);
  add_statements(files);
  add_lines(files);
  add_polygons(files);
  return files.take();
}

}  // namespace planish::bad
