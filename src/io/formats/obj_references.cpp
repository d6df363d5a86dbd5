#include "io/formats/obj_references.h"

#include <algorithm>
#include <string>

#include "io/formats/face_list.h"

namespace planish {

namespace {

/// Whether a word goes on behind its vertex as numbers of texture and normal do.
bool are_references(std::string_view after_vertex) {
  return after_vertex.find_first_not_of("/+-0123456789") == std::string_view::npos &&
         std::count(after_vertex.begin(), after_vertex.end(), '/') <= 2;
}

}  // namespace

Index ObjReferences::vertex(std::string_view word, std::string_view element, std::size_t so_far,
                            const TextCursor& cursor) {
  const bool negative = word.front() == '-';
  std::size_t at = negative || word.front() == '+';
  const std::size_t first_digit = at;
  std::uint64_t number = 0;
  for (; at < word.size() && word[at] >= '0' && word[at] <= '9'; ++at) {
    // Large numbers stay large; they are out of range however large they are.
    if (number <= k_most_items) number = 10 * number + static_cast<std::uint64_t>(word[at] - '0');
  }
  const bool goes_on = at < word.size();
  if (at == first_digit || (goes_on && (word[at] != '/' || !are_references(word.substr(at))))) {
    cursor.fail(ErrorCode::bad_number,
                in_quotes(word) + " is not a corner of a " + std::string(element));
  }
  const auto fail = [&](const std::string& vertex_and_why) {
    cursor.fail(ErrorCode::index_out_of_range,
                "the " + std::string(element) + " refers to vertex " + vertex_and_why);
  };
  if (number == 0) fail("0, but OBJ counts from 1");
  if (negative && number > so_far) {
    fail(in_quotes(word) + " but only " + std::to_string(so_far) + " vertices come before it");
  }
  if (number > k_most_items) fail(in_quotes(word) + ", which cannot exist");
  if (negative) number = so_far + 1 - number;
  if (number > so_far && (forward_.empty() || number > forward_.back().number)) {
    forward_.push_back({number, element, cursor.line()});
  }
  return static_cast<Index>(number - 1);
}

void ObjReferences::check(std::size_t vertex_count, const TextCursor& cursor) const {
  for (const Forward& reference : forward_) {
    if (reference.number <= vertex_count) continue;
    cursor.fail_at_line(reference.line, ErrorCode::index_out_of_range,
                        "the " + std::string(reference.element) + " refers to vertex " +
                            std::to_string(reference.number) + " but the file has " +
                            std::to_string(vertex_count) + " vertices");
  }
}

}  // namespace planish
