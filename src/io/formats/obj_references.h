#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <planish/core/vec.h>

#include "io/file/text_cursor.h"

namespace planish {

/// Reads the numbers of vertices in the statements of an OBJ file, which may come before the
/// vertices that they name.
class ObjReferences {
 public:
  /// The vertex, from 0, that a word like 7, 7/1, 7//3, 7/1/3 or -1 names.
  /// @param element what it is a word of, as in "face"
  /// @param so_far how many vertices came before: negative numbers count back from the last
  Index vertex(std::string_view word, std::string_view element, std::size_t so_far,
               const TextCursor& cursor);

  /// Refuses the file if one of the vertices did not come: to be called at its end.
  void check(std::size_t vertex_count, const TextCursor& cursor) const;

 private:
  /// A vertex that is named before its statement.
  struct Forward {
    std::uint64_t number;  ///< from 1
    std::string_view element;
    std::size_t line;
  };

  std::vector<Forward> forward_;  ///< each larger than those before it
};

}  // namespace planish
