#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/number_text.h"
#include "io/file/append.h"
#include "io/formats/face_list.h"
#include "io/formats/formats.h"
#include "io/formats/group_runs.h"
#include "io/formats/ply_header.h"
#include "io/formats/ply_values.h"

namespace planish {
namespace {

/// Reads what follows the header. `Values` is where its numbers come from.
template <class Values>
class PlyBody {
 public:
  PlyBody(const PlyHeader& header, const Values& values, const ReadOptions& options)
      : header_(header), values_(values), keeps_colors_(options.colors), faces_(options.strict) {}

  ReadResult read() {
    const PlyElement* const vertices = header_.find("vertex");
    if (vertices == nullptr) fail(ErrorCode::malformed_file, "the header has no element vertex");
    vertex_count_ = std::min(vertices->count, k_most_items);
    for (const PlyElement& element : header_.elements) {
      check_count(element);
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face") {
        read_faces(element);
      } else {
        skip_element(element);
      }
    }
    values_.begin_item({}, 0);
    if (faces_.size() == 0) fail_without_faces();
    std::vector<std::string> notes = faces_.notes();
    std::string rest = values_.rest_note(header_.find("face")->count);
    if (!rest.empty()) notes.push_back(std::move(rest));
    FaceGroups groups = groups_.spread(group_kind_, faces_.size());
    std::vector<Triangle> triangles = faces_.take(positions_, values_.cursor());
    return {.mesh = {std::move(positions_), std::move(triangles)},
            .format = MeshFormat::ply,
            .notes = std::move(notes),
            .groups = std::move(groups),
            .colors = std::move(colors_)};
  }

 private:
  [[noreturn]] void fail(ErrorCode code, const std::string& message) const {
    values_.cursor().fail(code, message);
  }

  [[noreturn]] void fail_without_faces() const {
    if (header_.find("tristrips") == nullptr) {
      fail(ErrorCode::no_triangles,
           "the file has " + std::to_string(positions_.size()) +
               " points but no faces: make a surface of them in the program that made the file, "
               "or in MeshLab or CloudCompare");
    }
    fail(ErrorCode::unsupported_format,
         "the faces are strips of triangles (tristrips); export single faces");
  }

  static bool is_color(const PlyProperty* property) {
    return property != nullptr && !property->count_type;
  }

  static bool is_corner_list(const PlyProperty& property) {
    return property.count_type &&
           (property.name == "vertex_indices" || property.name == "vertex_index");
  }

  /// Refuses counts that the rest of the file cannot hold, before anything is allocated for them.
  void check_count(const PlyElement& element) {
    values_.begin_item({}, 0);
    std::uint64_t item_bytes = 0;
    for (const PlyProperty& property : element.properties) {
      item_bytes += values_.fewest_bytes(property.count_type.value_or(property.type));
      const bool corners = element.name == "face" && is_corner_list(property);
      if (corners) item_bytes += 3 * values_.fewest_bytes(property.type);
    }
    if (element.count == 0 || element.count <= values_.remaining() / item_bytes) return;
    fail(ErrorCode::truncated_file, "the header announces " + std::to_string(element.count) +
                                        " items of element " + in_quotes(element.name) +
                                        ", but the file ends before");
  }

  void read_vertices(const PlyElement& element);
  void read_faces(const PlyElement& element);
  void read_corners(const PlyProperty& property);
  void begin_group(double number, std::size_t first);
  void skip_element(const PlyElement& element);
  void skip_property(const PlyProperty& property);
  std::uint64_t list_length(PlyType type);

  const PlyHeader& header_;
  Values values_;
  bool keeps_colors_;
  std::uint64_t vertex_count_ = 0;
  std::vector<Vec3> positions_;
  std::vector<std::array<float, 3>> colors_;
  FaceList faces_;
  std::vector<Index> corners_;
  GroupRuns groups_;
  std::string group_kind_;
  std::string group_;  // of the last face
};

template <class Values>
void PlyBody<Values>::read_vertices(const PlyElement& element) {
  const std::array<const PlyProperty*, 3> xyz = {element.find("x"), element.find("y"),
                                                 element.find("z")};
  for (const PlyProperty* const coordinate : xyz) {
    if (coordinate == nullptr || coordinate->count_type) {
      fail(ErrorCode::malformed_file, "the vertices have no numbers x, y and z");
    }
  }
  std::array<const PlyProperty*, 3> rgb = {element.find("red"), element.find("green"),
                                           element.find("blue")};
  if (!keeps_colors_ || !std::all_of(rgb.begin(), rgb.end(), is_color)) rgb = {};
  check_size(element.count, "vertices", values_.cursor());
  positions_.reserve(element.count);
  for (std::uint64_t i = 0; i < element.count; ++i) {
    values_.begin_item("vertex", i);
    Vec3 p;
    std::array<float, 3> color = {};
    for (const PlyProperty& property : element.properties) {
      const auto channel = std::find(rgb.begin(), rgb.end(), &property);
      if (channel != rgb.end()) {
        const double most = property.type == PlyType::uint8 ? 255.0 : 1.0;
        color[static_cast<std::size_t>(channel - rgb.begin())] =
            static_cast<float>(values_.next(property.type) / most);
        continue;
      }
      double* const target = &property == xyz[0]   ? &p.x
                             : &property == xyz[1] ? &p.y
                             : &property == xyz[2] ? &p.z
                                                   : nullptr;
      if (target == nullptr) {
        skip_property(property);
        continue;
      }
      *target = values_.next(property.type);
      if (!std::isfinite(*target)) {
        fail(ErrorCode::non_finite_coordinate,
             std::string(property.name) + " is " + std::to_string(*target));
      }
    }
    positions_.push_back(p);
    if (rgb[0] != nullptr) colors_.push_back(color);
  }
}

template <class Values>
void PlyBody<Values>::read_faces(const PlyElement& element) {
  const PlyProperty* corners = element.find("vertex_indices");
  if (corners == nullptr) corners = element.find("vertex_index");
  if (element.count > 0 && (corners == nullptr || !is_corner_list(*corners))) {
    fail(ErrorCode::malformed_file, "the faces have no list vertex_indices or vertex_index");
  }
  check_size(element.count, "triangles", values_.cursor());
  const PlyProperty* const group = group_property(element);
  if (group != nullptr) group_kind_ = group->name;
  faces_.reserve(element.count);
  for (std::uint64_t i = 0; i < element.count; ++i) {
    values_.begin_item("face", i);
    const std::size_t first = faces_.size();
    for (const PlyProperty& property : element.properties) {
      if (&property == corners) {
        read_corners(property);
      } else if (&property == group) {
        begin_group(values_.next(property.type), first);
      } else {
        skip_property(property);
      }
    }
  }
}

template <class Values>
void PlyBody<Values>::read_corners(const PlyProperty& property) {
  const std::uint64_t length = list_length(*property.count_type);
  corners_.clear();
  for (std::uint64_t k = 0; k < length; ++k) {
    corners_.push_back(checked_index(values_.next(property.type), vertex_count_, values_.cursor()));
  }
  faces_.add(corners_, values_.cursor());
}

template <class Values>
void PlyBody<Values>::begin_group(double number, std::size_t first) {
  std::string name = group_kind_ + "-" + number_text(number);
  if (name == group_) return;
  groups_.begin(name, first);
  group_ = std::move(name);
}

template <class Values>
void PlyBody<Values>::skip_element(const PlyElement& element) {
  for (std::uint64_t i = 0; i < element.count; ++i) {
    values_.begin_item(element.name, i);
    for (const PlyProperty& property : element.properties)
      skip_property(property);
  }
}

template <class Values>
void PlyBody<Values>::skip_property(const PlyProperty& property) {
  values_.skip(property.type, property.count_type ? list_length(*property.count_type) : 1);
}

template <class Values>
std::uint64_t PlyBody<Values>::list_length(PlyType type) {
  const double length = values_.next(type);
  if (length >= 0.0 && length <= 4294967295.0 && std::floor(length) == length) {
    return static_cast<std::uint64_t>(length);
  }
  fail(ErrorCode::malformed_file, "a list cannot have " + number_text(length) + " items");
}

}  // namespace

ReadResult parse_ply(std::string_view bytes, std::string_view name, const ReadOptions& options) {
  TextCursor cursor(bytes, name);
  const PlyHeader header = read_ply_header(cursor);
  if (header.encoding == PlyEncoding::ascii)
    return PlyBody(header, TextValues(cursor), options).read();
  const bool little = header.encoding == PlyEncoding::little_endian;
  const BinaryValues values(ByteCursor(bytes, name, header.body),
                            little ? std::endian::little : std::endian::big);
  return PlyBody(header, values, options).read();
}

std::string format_ply(const TriMesh& mesh) {
  // Many readers know "int" only.
  const bool is_int = mesh.positions.size() <= std::numeric_limits<std::int32_t>::max();
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex ";
  bytes.reserve(256 + 24 * mesh.positions.size() + 13 * mesh.triangles.size());
  append_integer(bytes, mesh.positions.size());
  bytes += "\nproperty double x\nproperty double y\nproperty double z\nelement face ";
  append_integer(bytes, mesh.triangles.size());
  bytes += is_int ? "\nproperty list uchar int vertex_indices\nend_header\n"
                  : "\nproperty list uchar uint vertex_indices\nend_header\n";
  for (const Vec3& p : mesh.positions) {
    for (const double c : {p.x, p.y, p.z})
      append_little_endian(bytes, c);
  }
  for (const Triangle& triangle : mesh.triangles) {
    bytes += '\3';
    for (const Index v : triangle)
      append_little_endian(bytes, v);
  }
  return bytes;
}

}  // namespace planish
