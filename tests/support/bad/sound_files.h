#pragma once

// The sound patch of the bad files as text, so that its lines can be changed one by one.

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "support/bad/bad_mesh.h"
#include "support/meshes.h"

namespace planish::bad {

inline constexpr auto k_malformed = ErrorCode::malformed_file;
inline constexpr auto k_truncated = ErrorCode::truncated_file;

/// 25 vertices, 9 of them inside, 32 triangles. Its coordinates are floats, so that every format
/// can hold it exactly.
inline TriMesh sound() {
  TriMesh mesh = meshes::rough_grid(4, 4, 7);
  const auto rounded = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  for (Vec3& p : mesh.positions)
    p = {rounded(p.x), rounded(p.y), rounded(p.z)};
  return mesh;
}

/// A text as lines, counted from 1 as errors count them.
class Lines {
 public:
  void add(std::string line) { lines_.push_back(std::move(line)); }
  std::size_t count() const { return lines_.size(); }
  const std::string& at(std::size_t line) const { return lines_[line - 1]; }

  Lines with(std::size_t line, std::string text) const {
    Lines changed = *this;
    changed.lines_[line - 1] = std::move(text);
    return changed;
  }
  /// With a line before this one; behind the last for count() + 1.
  Lines before(std::size_t line, std::string text) const {
    Lines changed = *this;
    changed.lines_.insert(changed.lines_.begin() + static_cast<std::ptrdiff_t>(line - 1),
                          std::move(text));
    return changed;
  }
  Lines without(std::size_t line) const {
    Lines changed = *this;
    changed.lines_.erase(changed.lines_.begin() + static_cast<std::ptrdiff_t>(line - 1));
    return changed;
  }
  Lines first(std::size_t count) const {
    Lines changed = *this;
    changed.lines_.resize(count);
    return changed;
  }

  std::string text(const std::string& end = "\n") const {
    std::string text;
    for (const std::string& line : lines_)
      text += line + end;
    return text;
  }

 private:
  std::vector<std::string> lines_;
};

/// A text format: how it names itself, and where vertices and triangles stand.
struct SoundText {
  std::string format;  ///< "obj"
  Lines lines;
  std::size_t first_vertex, vertex_step;  ///< lines
  std::size_t first_face, face_step;
  std::string before_vertex, before_face;  ///< the words on the line before the numbers
  std::size_t index_base;

  std::string extension() const { return "." + format.substr(0, 3); }
  std::size_t vertex_line(std::size_t v) const { return first_vertex + v * vertex_step; }
  std::size_t face_line(std::size_t t) const { return first_face + t * face_step; }
};

/// The shortest digits that read back to the same number.
inline std::string shortest(double value) {
  char digits[40];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

inline std::string three(const std::string& a, const std::string& b, const std::string& c) {
  return a + " " + b + " " + c;
}

inline std::string numbers(Vec3 p) {
  return three(shortest(p.x), shortest(p.y), shortest(p.z));
}

inline std::string corners(const Triangle& t, std::size_t base) {
  return three(std::to_string(t[0] + base), std::to_string(t[1] + base),
               std::to_string(t[2] + base));
}

inline SoundText sound_obj(const TriMesh& mesh = sound()) {
  SoundText text{"obj", {}, 1, 1, mesh.positions.size() + 1, 1, "v ", "f ", 1};
  for (const Vec3& p : mesh.positions)
    text.lines.add("v " + numbers(p));
  for (const Triangle& t : mesh.triangles)
    text.lines.add("f " + corners(t, 1));
  return text;
}

/// Vertices and faces of a text in which faces are counted and indices begin at 0.
inline void add_counted_faces(Lines& lines, const TriMesh& mesh) {
  for (const Vec3& p : mesh.positions)
    lines.add(numbers(p));
  for (const Triangle& t : mesh.triangles)
    lines.add("3 " + corners(t, 0));
}

inline SoundText sound_off(const TriMesh& mesh = sound()) {
  SoundText text{"off", {}, 3, 1, mesh.positions.size() + 3, 1, "", "3 ", 0};
  text.lines.add("OFF");
  text.lines.add(std::to_string(mesh.positions.size()) + " " +
                 std::to_string(mesh.triangles.size()) + " 0");
  add_counted_faces(text.lines, mesh);
  return text;
}

/// The header is lines 1 to 9: the format on 2, the element vertex on 3, x y z on 4 to 6, the
/// element face on 7, its list on 8.
inline SoundText sound_ply(const TriMesh& mesh = sound()) {
  SoundText text{"ply", {}, 10, 1, mesh.positions.size() + 10, 1, "", "3 ", 0};
  text.lines.add("ply");
  text.lines.add("format ascii 1.0");
  text.lines.add("element vertex " + std::to_string(mesh.positions.size()));
  for (const std::string axis : {"x", "y", "z"})
    text.lines.add("property float " + axis);
  text.lines.add("element face " + std::to_string(mesh.triangles.size()));
  text.lines.add("property list uchar int vertex_indices");
  text.lines.add("end_header");
  add_counted_faces(text.lines, mesh);
  return text;
}

/// Seven lines a facet; "vertices" here are the first corners of facets.
inline SoundText sound_stl(const TriMesh& mesh = sound()) {
  SoundText text{"stl", {}, 4, 7, 2, 7, "vertex ", "", 0};
  text.lines.add("solid patch");
  for (const Triangle& t : mesh.triangles) {
    text.lines.add("facet normal 0 0 1");
    text.lines.add("outer loop");
    for (const Index v : t)
      text.lines.add("vertex " + numbers(mesh.positions[v]));
    text.lines.add("endloop");
    text.lines.add("endfacet");
  }
  text.lines.add("endsolid patch");
  return text;
}

/// The bytes of a number, the lowest first.
template <class T>
std::string bytes_of(T value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

/// A number overwritten at a place.
template <class T>
std::string patched(std::string bytes, std::size_t at, T value) {
  return bytes.replace(at, sizeof value, bytes_of(value));
}

/// Little-endian floats behind a header of the usual kind: 12 bytes a vertex, 13 a face.
inline std::string binary_ply(const TriMesh& mesh = sound()) {
  std::string bytes =
      sound_ply(mesh).lines.with(2, "format binary_little_endian 1.0").first(9).text();
  for (const Vec3& p : mesh.positions) {
    for (const double c : {p.x, p.y, p.z})
      bytes += bytes_of(static_cast<float>(c));
  }
  for (const Triangle& t : mesh.triangles) {
    bytes += '\3';
    for (const Index v : t)
      bytes += bytes_of(static_cast<std::int32_t>(v));
  }
  return bytes;
}
inline std::size_t binary_ply_body(const std::string& bytes) {
  return bytes.find("end_header\n") + 11;
}

/// 84 bytes and 50 a facet.
inline std::string binary_stl(const TriMesh& mesh = sound(), std::string header = "made by hand") {
  header.resize(80, ' ');
  std::string bytes = header + bytes_of(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Triangle& t : mesh.triangles) {
    for (const float n : {0.0F, 0.0F, 1.0F})
      bytes += bytes_of(n);
    for (const Index v : t) {
      const Vec3 p = mesh.positions[v];
      for (const double c : {p.x, p.y, p.z})
        bytes += bytes_of(static_cast<float>(c));
    }
    bytes += bytes_of(std::uint16_t{0});
  }
  return bytes;
}

/// Collects the files of one source.
class Collection {
 public:
  Collection(std::string prefix, std::string extension)
      : prefix_(std::move(prefix)), extension_(std::move(extension)) {}

  void same(const std::string& name, std::string bytes, std::string part = {}) {
    meshes_.push_back({.name = prefix_ + name,
                       .extension = extension_,
                       .bytes = std::move(bytes),
                       .verdict = Verdict::same,
                       .part = std::move(part)});
  }
  void accept(const std::string& name, std::string bytes, std::optional<ErrorCode> told = {}) {
    meshes_.push_back({.name = prefix_ + name,
                       .extension = extension_,
                       .bytes = std::move(bytes),
                       .verdict = Verdict::accept,
                       .code = told});
  }
  void either(const std::string& name, std::string bytes) {
    meshes_.push_back({.name = prefix_ + name,
                       .extension = extension_,
                       .bytes = std::move(bytes),
                       .verdict = Verdict::either});
  }
  /// Refused by the reader, for what is on a line.
  void at_line(const std::string& name, std::string bytes, ErrorCode code, std::size_t line,
               std::string part = {}) {
    BadMesh mesh = refused(name, std::move(bytes), code, std::move(part));
    mesh.line = line;
    mesh.unreadable = true;
    meshes_.push_back(std::move(mesh));
  }
  /// Refused by the reader, for what is at a byte.
  void at_byte(const std::string& name, std::string bytes, ErrorCode code, std::size_t byte,
               std::string part = {}) {
    BadMesh mesh = refused(name, std::move(bytes), code, std::move(part));
    mesh.byte = byte;
    mesh.unreadable = true;
    meshes_.push_back(std::move(mesh));
  }
  /// Refused by the reader as a whole.
  void as_a_whole(const std::string& name, std::string bytes, ErrorCode code,
                  std::string part = {}) {
    BadMesh mesh = refused(name, std::move(bytes), code, std::move(part));
    mesh.unreadable = true;
    meshes_.push_back(std::move(mesh));
  }
  /// Read, and refused from a step on for what the mesh is.
  void as_mesh(const std::string& name, std::string bytes, ErrorCode code,
               std::optional<std::size_t> first, Purpose blocks = Purpose::measure,
               std::string part = {}) {
    BadMesh mesh = refused(name, std::move(bytes), code, std::move(part));
    mesh.first = first;
    mesh.blocks = blocks;
    meshes_.push_back(std::move(mesh));
  }

  void add(BadMesh mesh) { meshes_.push_back(std::move(mesh)); }

  BadMeshes take() { return std::move(meshes_); }

 private:
  BadMesh refused(const std::string& name, std::string bytes, ErrorCode code,
                  std::string part) const {
    return {.name = prefix_ + name,
            .extension = extension_,
            .bytes = std::move(bytes),
            .verdict = Verdict::refuse,
            .code = code,
            .part = std::move(part)};
  }

  std::string prefix_, extension_;
  BadMeshes meshes_;
};

inline void append(BadMeshes& all, BadMeshes more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// An element of a list, with the name of its place.
struct NamedPlace {
  std::string name;
  std::size_t number;
};

inline std::array<NamedPlace, 3> places_in(std::size_t count) {
  return {{{"first", 0}, {"middle", count / 2}, {"last", count - 1}}};
}

}  // namespace planish::bad
