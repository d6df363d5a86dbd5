#include <algorithm>
#include <array>
#include <cstdint>

#include "core/number_text.h"
#include "io/file/append.h"
#include "io/file/text_cursor.h"
#include "io/formats/face_list.h"
#include "io/formats/formats.h"
#include "io/formats/group_runs.h"
#include "io/formats/obj_references.h"

namespace planish {
namespace {

/// Statements that say nothing about the surface: passed over without a word.
constexpr std::array<std::string_view, 13> k_attributes = {
    "vn",  "vt",     "s",      "mtllib",     "mg",        "c_interp", "d_interp",
    "lod", "usemap", "maplib", "shadow_obj", "trace_obj", "bevel"};

/// Statements of points, lines, curves and free-form surfaces: passed over with a note.
constexpr std::array<std::string_view, 26> k_skipped = {
    "l",    "p",  "vp",  "curv",   "curv2", "surf", "parm", "trim",  "hole",
    "scrv", "sp", "end", "cstype", "deg",   "bmat", "step", "ctech", "stech",
    "con",  "fo", "bzp", "bsp",    "cdc",   "cdp",  "res",  "call"};

/// Whether a word must have been meant for "v" or "f", which none may lose without a sound: "V", a
/// word without its blank ("v1"), one behind a byte order mark.
bool is_garbled(std::string_view keyword) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto letter = std::find_if(keyword.begin(), keyword.end(), is_letter);
  return std::count_if(keyword.begin(), keyword.end(), is_letter) == 1 &&
         std::string_view("vVfF").find(*letter) != std::string_view::npos;
}

/// Whether the next word says that there is no number, as colours of points that were not seen do.
bool is_no_number(TextCursor ahead) {
  std::string_view word = ahead.token();
  if (word.starts_with('-') || word.starts_with('+')) word.remove_prefix(1);
  return word.size() == 3 && (word[0] == 'n' || word[0] == 'N') &&
         (word[1] == 'a' || word[1] == 'A') && (word[2] == 'n' || word[2] == 'N');
}

class ObjParser {
 public:
  ObjParser(std::string_view bytes, std::string_view name, const ReadOptions& options)
      : cursor_(bytes, name, {.comments = true, .continuation = true}),
        strict_(options.strict),
        keeps_colors_(options.colors),
        faces_(options.strict) {}

  ReadResult parse() {
    for (; !cursor_.at_end(); cursor_.next_line())
      statement();
    check();
    std::vector<std::string> read_notes = notes();
    FaceGroups groups = this->groups();
    const std::size_t faces = faces_.size();  // before they are taken
    std::vector<Triangle> triangles = faces_.take(positions_, cursor_);
    std::vector<std::array<float, 3>> colors = this->colors();
    return {.mesh = {std::move(positions_), std::move(triangles)},
            .format = MeshFormat::obj,
            .notes = std::move(read_notes),
            .groups = std::move(groups),
            .materials = materials_.spread("usemtl", faces),
            .colors = std::move(colors)};
  }

 private:
  void statement() {
    const std::string_view keyword = cursor_.token();
    if (keyword.empty()) return;
    if (keyword == "v") return vertex();
    if (keyword == "f") return face();
    if (keyword == "o") return begin_group(objects_);
    if (keyword == "g") return begin_group(groups_);
    if (keyword == "usemtl") return begin_group(materials_);
    skip(keyword);
  }

  void vertex();
  void face();
  void begin_group(GroupRuns& runs);
  FaceGroups groups() const;
  std::vector<std::array<float, 3>> colors();
  void skip(std::string_view keyword);
  void check() const;
  std::vector<std::string> notes() const;

  TextCursor cursor_;
  bool strict_, keeps_colors_;
  std::vector<Vec3> positions_;
  FaceList faces_;
  std::vector<Index> corners_;
  ObjReferences references_;
  GroupRuns objects_, groups_, materials_;
  std::size_t coloured_ = 0;
  std::vector<std::array<float, 3>> colors_;
  std::array<std::size_t, k_skipped.size()> skipped_ = {};
  std::size_t unknown_ = 0;
  std::string first_unknown_;
};

void ObjParser::vertex() {
  const double x = cursor_.number();
  const double y = cursor_.number();
  const double z = cursor_.number();
  std::array<float, 3> color = {};
  std::size_t extras = 0, missing = 0;
  for (; !cursor_.at_line_end(); ++extras) {
    if (!strict_ && is_no_number(cursor_)) {
      cursor_.token();
      ++missing;
    } else {
      const double number = cursor_.number();
      if (extras < color.size()) color[extras] = static_cast<float>(number);
    }
  }
  // One more number is a weight, three are a colour, four a colour and a weight or opacity.
  if (extras == 2 || extras > 4) {
    cursor_.fail(ErrorCode::malformed_file,
                 "a vertex cannot have " + std::to_string(3 + extras) + " numbers");
  }
  if (missing > 0 && extras < 3) {
    cursor_.fail(ErrorCode::non_finite_coordinate, "the weight of the vertex is no finite number");
  }
  coloured_ += extras >= 3;
  if (keeps_colors_ && extras == 3 && missing == 0) colors_.push_back(color);
  positions_.push_back({x, y, z});
  check_size(positions_.size(), "vertices", cursor_);
}

/// Some programs write whole numbers up to 255.
std::vector<std::array<float, 3>> ObjParser::colors() {
  if (colors_.size() != positions_.size()) return {};
  float most = 0.0F;
  for (const auto& color : colors_)
    most = std::max({most, color[0], color[1], color[2]});
  for (auto& color : colors_) {
    for (float& channel : color)
      channel = most > 1.0F ? channel / 255.0F : channel;
  }
  return std::move(colors_);
}

void ObjParser::face() {
  corners_.clear();
  while (!cursor_.at_line_end()) {
    corners_.push_back(references_.vertex(cursor_.token(), "face", positions_.size(), cursor_));
  }
  faces_.add(corners_, cursor_);
}

void ObjParser::begin_group(GroupRuns& runs) {
  std::string name;
  while (!cursor_.at_line_end()) {
    if (!name.empty()) name += ' ';
    name += cursor_.token();
  }
  runs.begin(name, faces_.size());
}

/// Objects say more about what belongs together than groups.
FaceGroups ObjParser::groups() const {
  FaceGroups found = objects_.spread("o", faces_.size());
  if (found.names.empty()) found = groups_.spread("g", faces_.size());
  return found;
}

void ObjParser::skip(std::string_view keyword) {
  if (std::find(k_attributes.begin(), k_attributes.end(), keyword) != k_attributes.end()) return;
  const auto kind = std::find(k_skipped.begin(), k_skipped.end(), keyword);
  if (kind != k_skipped.end()) {
    ++skipped_[static_cast<std::size_t>(kind - k_skipped.begin())];
    return;
  }
  if (is_garbled(keyword)) {
    cursor_.fail(ErrorCode::malformed_file,
                 in_quotes(keyword) + " is no statement; vertices begin with v, faces with f");
  }
  if (unknown_++ == 0) {
    first_unknown_ = in_quotes(keyword) + " on line " + std::to_string(cursor_.line());
  }
}

void ObjParser::check() const {
  if (positions_.empty() && faces_.size() == 0 && unknown_ > 0) {
    cursor_.fail_at_line(1, ErrorCode::malformed_file,
                         "no OBJ statement found; the first word is " + first_unknown_);
  }
  references_.check(positions_.size(), cursor_);
  if (faces_.size() > 0) return;
  cursor_.fail(ErrorCode::no_triangles, positions_.empty()
                                            ? std::string("the file has no vertices and no faces")
                                            : "the file has " + std::to_string(positions_.size()) +
                                                  " vertices but no faces: make a surface of "
                                                  "them in the program that made the file");
}

std::vector<std::string> ObjParser::notes() const {
  std::vector<std::string> notes;
  for (std::string& note : faces_.notes())
    notes.push_back(std::move(note));
  if (coloured_ > 0) {
    notes.push_back("dropped the colours of " + std::to_string(coloured_) + " vertices");
  }
  std::size_t total = 0;
  std::string kinds;
  for (std::size_t i = 0; i < skipped_.size(); ++i) {
    if (skipped_[i] == 0) continue;
    total += skipped_[i];
    kinds += (kinds.empty() ? "" : ", ") + std::string(k_skipped[i]);
  }
  if (total > 0) {
    notes.push_back("skipped " + std::to_string(total) + " statements of kinds " + kinds);
  }
  if (unknown_ > 0) {
    notes.push_back("skipped " + std::to_string(unknown_) + " unknown statements, the first " +
                    first_unknown_);
  }
  return notes;
}

}  // namespace

ReadResult parse_obj(std::string_view bytes, std::string_view name, const ReadOptions& options) {
  return ObjParser(bytes, name, options).parse();
}

std::string format_obj(const TriMesh& mesh, std::span<const Vec2> texture) {
  std::string text;
  text.reserve(60 * mesh.positions.size() + 40 * texture.size() + 24 * mesh.triangles.size());
  for (const Vec3& p : mesh.positions) {
    text += 'v';
    for (const double c : {p.x, p.y, p.z})
      append_number(text += ' ', c);
    text += '\n';
  }
  for (const Vec2 p : texture) {
    append_number(text += "vt ", p.x);
    append_number(text += ' ', p.y);
    text += '\n';
  }
  for (const Triangle& triangle : mesh.triangles) {
    text += 'f';
    // A wider type: from 1 on the largest Index has no successor.
    for (const std::uint64_t v : triangle) {
      append_integer(text += ' ', v + 1);
      if (!texture.empty()) append_integer(text += '/', v + 1);
    }
    text += '\n';
  }
  return text;
}

}  // namespace planish
