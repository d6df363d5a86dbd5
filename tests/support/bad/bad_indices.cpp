#include "support/bad/sound_files.h"

namespace planish::bad {
namespace {

struct IndexWord {
  std::string name, text;
  ErrorCode code;
};

constexpr auto k_range = ErrorCode::index_out_of_range;
constexpr auto k_number = ErrorCode::bad_number;

std::vector<IndexWord> words_for(const SoundText& text) {
  const std::size_t last = sound().positions.size() - 1 + text.index_base;
  std::vector<IndexWord> words = {{"one_too_large", std::to_string(last + 1), k_range},
                                  {"2_31", "2147483648", k_range},
                                  {"largest_32_bit", "4294967295", k_range},
                                  {"2_32", "4294967296", k_range},
                                  {"2_32_and_1", "4294967297", k_range},
                                  {"2_64_and_1", "18446744073709551617", k_range},
                                  {"20_digits", "99999999999999999999", k_range},
                                  {"negative_2_31", "-2147483648", k_range},
                                  {"fraction", "1.5", k_number},
                                  {"letter", "x", k_number},
                                  {"hexadecimal", "0x1", k_number},
                                  {"comma", "1,2", k_number},
                                  {"comma_behind", "1,", k_number},
                                  {"two_signs", "--1", k_number},
                                  {"nul_behind", std::string("1\0", 2), k_number}};
  if (text.format == "obj") {
    words.push_back({"zero", "0", k_range});
    words.push_back({"minus_zero", "-0", k_range});
    words.push_back({"back_too_far", "-26", k_range});
    words.push_back({"four_parts", "1/2/3/4", k_number});
    words.push_back({"no_vertex", "/1", k_number});
    words.push_back({"slashes_only", "//", k_number});
    words.push_back({"letter_of_texture", "1/a", k_number});
    words.push_back({"backslash", "1\\2", k_number});
    words.push_back({"comment_behind", "1#2", k_number});
    words.push_back({"nan", "nan", k_number});
  } else {
    words.push_back({"minus_one", "-1", k_range});
    words.push_back({"count_and_half", "25.5", k_range});
    words.push_back({"huge", "1e300", k_range});
    words.push_back({"slash", "1/1", k_number});
  }
  return words;
}

BadMeshes indices_in(const SoundText& text) {
  Collection collection(text.format + "_index_", text.extension());
  const TriMesh mesh = sound();
  for (const NamedPlace& place : places_in(mesh.triangles.size())) {
    const std::size_t line = text.face_line(place.number);
    std::size_t corner = 0;
    for (const IndexWord& word : words_for(text)) {
      std::array<std::string, 3> words;
      for (std::size_t k = 0; k < 3; ++k)
        words[k] = std::to_string(mesh.triangles[place.number][k] + text.index_base);
      words[corner++ % 3] = word.text;
      collection.at_line(
          word.name + "_" + place.name,
          text.lines.with(line, text.before_face + three(words[0], words[1], words[2])).text(),
          word.code, line);
    }
  }
  return collection.take();
}

}  // namespace

BadMeshes bad_indices() {
  BadMeshes all;
  for (const SoundText& text : {sound_obj(), sound_off(), sound_ply()})
    append(all, indices_in(text));
  return all;
}

}  // namespace planish::bad
