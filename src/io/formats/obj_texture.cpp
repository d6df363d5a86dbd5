#include "io/formats/obj_texture.h"

#include <algorithm>
#include <charconv>

#include <planish/core/error.h>

#include "io/file/text_cursor.h"
#include "io/formats/obj_references.h"

namespace planish {

namespace {

class TextureParser {
 public:
  TextureParser(std::string_view bytes, const std::string& name)
      : name_(name), cursor_(bytes, name, {.comments = true, .continuation = true}) {}

  ObjTexture parse() {
    for (; !cursor_.at_end(); cursor_.next_line()) {
      const std::string_view keyword = cursor_.token();
      if (keyword == "v") vertex();
      if (keyword == "vt") place();
      if (keyword == "f") face();
    }
    references_.check(texture_.positions.size(), cursor_);
    if (places_.empty()) {
      throw Error(ErrorCode::misplaced_cut, "the file has no texture coordinates (vt)",
                  {.path = name_});
    }
    // Faces may come before the coordinates that they name.
    auto number = numbers_.begin();
    for (TexturedFace& face : texture_.faces) {
      for (TexturedCorner& corner : face.corners)
        corner.place = place_of(*number++);
    }
    return std::move(texture_);
  }

 private:
  void vertex() {
    const double x = cursor_.number(), y = cursor_.number(), z = cursor_.number();
    texture_.positions.push_back({x, y, z});
  }

  void place() {
    const double u = cursor_.number();
    places_.push_back({u, cursor_.at_line_end() ? 0.0 : cursor_.number()});
  }

  void face() {
    TexturedFace& face = texture_.faces.emplace_back(TexturedFace{{}, cursor_.line()});
    while (!cursor_.at_line_end()) {
      const std::string_view word = cursor_.token();
      face.corners.push_back(
          {references_.vertex(word, "face", texture_.positions.size(), cursor_)});
      numbers_.push_back(number_in(word));
    }
  }

  /// From 1 on; 0: none.
  long long number_in(std::string_view word) const {
    const std::size_t slash = std::min(word.find('/'), word.size());
    const std::string_view behind = word.substr(std::min(slash + 1, word.size()));
    long long number = 0;
    std::from_chars(behind.data(), behind.data() + behind.size(), number);
    return number < 0 ? static_cast<long long>(places_.size()) + number + 1 : number;
  }

  std::optional<Vec2> place_of(long long number) const {
    if (number < 1 || number > static_cast<long long>(places_.size())) return std::nullopt;
    return places_[static_cast<std::size_t>(number - 1)];
  }

  const std::string& name_;
  TextCursor cursor_;
  ObjReferences references_;
  ObjTexture texture_;
  std::vector<Vec2> places_;
  std::vector<long long> numbers_;  // of each corner
};

}  // namespace

ObjTexture parse_obj_texture(std::string_view bytes, const std::string& name) {
  return TextureParser(bytes, name).parse();
}

}  // namespace planish
