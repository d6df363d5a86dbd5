#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

// Files of about a given size that are as hard on a reader as we could think of.

namespace planish::fault {

struct HardFile {
  std::string name;  ///< with the extension
  std::string content;
};

/// Lines put together until there are so many bytes.
class Text {
 public:
  explicit Text(std::size_t bytes) : bytes_(bytes) {}

  bool is_full() const { return text_.size() >= bytes_; }
  template <class... Parts>
  void add(const Parts&... parts) {
    (append(parts), ...);
  }
  std::string take() { return std::move(text_); }

 private:
  void append(const std::string& part) { text_ += part; }
  void append(const char* part) { text_ += part; }
  void append(char part) { text_ += part; }
  template <class Number>
  void append(Number number) {
    text_ += std::to_string(number);
  }

  std::size_t bytes_;
  std::string text_;
};

/// As many lines as fit, the k-th from 0 by `add_line`.
inline std::string lines(std::size_t bytes, const std::string& head,
                         const std::function<void(Text&, std::size_t)>& add_line) {
  Text text(bytes);
  text.add(head);
  for (std::size_t k = 0; !text.is_full(); ++k)
    add_line(text, k);
  return text.take();
}

/// Vertices around a circle, from number 1 on, and what is made of them.
inline std::string circle(std::size_t count, bool hub) {
  Text text(0);
  if (hub) text.add("v 0 0 1\n");
  for (std::size_t i = 0; i < count; ++i) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    text.add("v ", 100.0 * std::cos(angle), ' ', 100.0 * std::sin(angle), " 0\n");
  }
  return text.take();
}

inline std::vector<HardFile> hard_obj_files(std::size_t bytes) {
  std::vector<HardFile> files;
  const auto add = [&](const std::string& name, std::string content) {
    files.push_back({name + ".obj", std::move(content)});
  };
  const std::string corner = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  {
    const std::size_t n = bytes / 34;
    std::string text = circle(n, false) + "f";
    for (std::size_t i = 1; i <= n; ++i)
      text += ' ' + std::to_string(i);
    add("one_polygon", text + "\n");
  }
  {
    const std::size_t n = bytes / 46;
    std::string text = circle(n, true);
    for (std::size_t i = 0; i < n; ++i)
      text += "f 1 " + std::to_string(2 + i) + ' ' + std::to_string(2 + (i + 1) % n) + '\n';
    add("hub", text);
  }
  add("equal_faces", lines(bytes, corner, [](Text& t, std::size_t) { t.add("f 1 2 3\n"); }));
  add("equal_faces_turned", lines(bytes, corner, [](Text& t, std::size_t k) {
        t.add(k % 2 == 0 ? "f 1 2 3\n" : "f 1 3 2\n");
      }));
  add("one_edge", lines(bytes, "v 0 0 0\nv 1 0 0\n",
                        [](Text& t, std::size_t k) { t.add("v 0 1 ", k, "\nf 1 2 -1\n"); }));
  add("one_edge_both_ways", lines(bytes, "v 0 0 0\nv 1 0 0\n", [](Text& t, std::size_t k) {
        t.add("v 0 1 ", k, k % 2 == 0 ? "\nf 1 2 -1\n" : "\nf 2 1 -1\n");
      }));
  add("many_fans", lines(bytes, "v 0 0 0\n", [](Text& t, std::size_t k) {
        t.add("v 1 0 ", k, "\nv 1 1 ", k, "\nf 1 -2 -1\n");
      }));
  add("many_pieces", lines(bytes, "", [](Text& t, std::size_t k) {
        t.add("v ", k, " 0 0\nv ", k, " 1 0\nv ", k, " 0 1\nf -3 -2 -1\n");
      }));
  add("chain_of_pieces", lines(bytes, "v 0 0 0\n", [](Text& t, std::size_t k) {
        t.add("v ", k, ".5 1 0\nv ", k + 1, " 0 0\nf -3 -2 -1\n");
      }));
  add("strip", lines(bytes, "v 0 0 0\nv 0 1 0\n", [](Text& t, std::size_t k) {
        t.add("v ", k + 1, ' ', k % 2, " 0\n", k % 2 == 0 ? "f -3 -1 -2\n" : "f -3 -2 -1\n");
      }));
  add("many_holes", lines(bytes, "", [](Text& t, std::size_t k) {
        // Squares beside each other, every second one of them open.
        t.add("v ", k, " 0 0\nv ", k, " 1 0\nv ", k, " 2 0\nv ", k, " 3 0\n");
        if (k == 0) return;
        t.add("f -8 -4 -3 -7\nf -6 -2 -1 -5\n");
        if (k % 2 == 0) t.add("f -7 -3 -2 -6\n");
      }));
  add("one_place", lines(bytes, "", [](Text& t, std::size_t) {
        t.add("v 1 1 1\nv 1 1 1\nv 1 1 1\nf -1 -2 -3\n");
      }));
  add("no_faces", lines(bytes, "", [](Text& t, std::size_t k) { t.add("v ", k, " 0 0\n"); }));
  add("polygons_that_cross", lines(bytes, circle(400, false), [](Text& t, std::size_t k) {
        t.add("f");
        for (std::size_t i = 0; i < 200; ++i)
          t.add(' ', 1 + (i * (2 * k + 1)) % 400);
        t.add('\n');
      }));
  add("groups",
      lines(bytes, corner, [](Text& t, std::size_t k) { t.add("g ", k, "\nf 1 2 3\n"); }));
  add("groups_by_turns", lines(bytes, corner, [](Text& t, std::size_t k) {
        t.add(k % 2 == 0 ? "o a\nf 1 2 3\n" : "o b\nf 1 2 3\n");
      }));
  add("materials", lines(bytes, corner, [](Text& t, std::size_t k) {
        t.add("usemtl ", std::string(1 + k % 60, '!'), k, "\nf 1 2 3\n");
      }));
  add("lines_that_go_on",
      lines(bytes, corner + "f 1 2 3", [](Text& t, std::size_t) { t.add("\\\n"); }));
  add("long_number", "v 0." + std::string(bytes, '1') + " 0 0\n");
  add("long_exponent", "v 1e" + std::string(bytes, '9') + " 0 0\n");
  add("long_index", corner + "f 1 2 " + std::string(bytes, '9') + "\n");
  add("long_word", std::string(bytes, 'x'));
  add("long_name", corner + "g " + std::string(bytes, 'x') + "\nf 1 2 3\n");
  add("long_comment", "#" + std::string(bytes, 'x') + "\n" + corner + "f 1 2 3\n");
  add("blanks", std::string(bytes, ' '));
  add("line_ends", std::string(bytes, '\n'));
  add("zeros", std::string(bytes, '\0'));
  add("unknown_words", lines(bytes, corner, [](Text& t, std::size_t k) { t.add('x', k, '\n'); }));
  add("far_indices",
      lines(bytes, corner, [](Text& t, std::size_t) { t.add("f -1 -2 -999999999\n"); }));
  add("later_vertices",
      lines(bytes, "", [](Text& t, std::size_t k) { t.add("f ", 900'000 + k, " 2 3\n"); }));
  return files;
}

inline void append_float(std::string& bytes, float value) {
  char piece[4];
  std::memcpy(piece, &value, 4);
  bytes.append(piece, 4);
}

/// Binary STL of so many bytes, the corners by number of triangle and corner.
inline std::string stl(std::size_t bytes,
                       const std::function<std::array<float, 3>(std::size_t, int)>& corner) {
  const auto count = static_cast<std::uint32_t>(bytes / 50);
  std::string content(80, ' ');
  char piece[4];
  std::memcpy(piece, &count, 4);
  content.append(piece, 4);
  for (std::size_t k = 0; k < count; ++k) {
    content.append(12, '\0');
    for (int c = 0; c < 3; ++c) {
      for (const float x : corner(k, c))
        append_float(content, x);
    }
    content.append(2, '\0');
  }
  return content;
}

inline std::vector<HardFile> hard_stl_files(std::size_t bytes) {
  using Corner = std::array<float, 3>;
  std::vector<HardFile> files;
  const auto add = [&](const std::string& name, std::string content) {
    files.push_back({name + ".stl", std::move(content)});
  };
  add("stl_one_place", stl(bytes, [](std::size_t, int) { return Corner{1, 2, 3}; }));
  add("stl_nearly_one_place", stl(bytes, [](std::size_t k, int c) {
        // Neighbours among floats: their bits differ in the last places only.
        const std::uint32_t bits =
            0x3f800000U + static_cast<std::uint32_t>(3 * k) + static_cast<std::uint32_t>(c);
        float x = 0;
        std::memcpy(&x, &bits, 4);
        return Corner{x, x, x};
      }));
  add("stl_grid", stl(bytes, [](std::size_t k, int c) {
        const auto at = static_cast<float>(1U << (k % 20));
        return Corner{at * static_cast<float>(c == 1), at * static_cast<float>(c == 2),
                      static_cast<float>(k / 20) * 1024.0F};
      }));
  add("stl_powers_of_two", stl(bytes, [](std::size_t k, int c) {
        // Only exponents differ: the low bits of all are 0.
        return Corner{std::ldexp(1.0F, static_cast<int>(k % 120)),
                      std::ldexp(1.0F, static_cast<int>(k / 120 % 120)),
                      std::ldexp(1.0F, c + static_cast<int>(k / 14400))};
      }));
  add("stl_ascii_names", "solid " + std::string(bytes, 'x'));
  add("stl_ascii_solids",
      lines(bytes, "", [](Text& t, std::size_t) { t.add("solid\nendsolid\n"); }));
  std::string lying = stl(50, [](std::size_t, int) { return Corner{}; });
  lying.replace(80, 4, "\xff\xff\xff\xff");
  add("stl_count_that_lies", lying + std::string(bytes, '\0'));
  return files;
}

inline std::vector<HardFile> hard_ply_and_off_files(std::size_t bytes) {
  std::vector<HardFile> files;
  const auto add = [&](const std::string& name, std::string content) {
    files.push_back({name, std::move(content)});
  };
  const std::string head = "ply\nformat ascii 1.0\n";
  const std::string vertices =
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";
  const std::string body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  add("properties.ply", lines(bytes, head + vertices,
                              [](Text& t, std::size_t k) { t.add("property float p", k, '\n'); }) +
                            faces + "end_header\n" + body);
  add("equal_properties.ply",
      lines(bytes, head + vertices, [](Text& t, std::size_t) { t.add("property float p\n"); }) +
          faces + "end_header\n" + body);
  add("elements.ply",
      lines(bytes, head,
            [](Text& t, std::size_t k) { t.add("element e", k, " 0\nproperty float x\n"); }) +
          vertices + faces + "end_header\n" + body);
  add("elements_without_properties.ply",
      lines(bytes, head, [](Text& t, std::size_t k) { t.add("element e", k, " 4000000000\n"); }) +
          vertices + faces + "end_header\n" + body);
  add("comments.ply", lines(bytes, head, [](Text& t, std::size_t) { t.add("comment\n"); }) +
                          vertices + faces + "end_header\n" + body);
  add("no_end.ply", head + std::string(bytes, 'x'));
  add("lists.ply", head + vertices +
                       "element face 1000000\nproperty list uchar int vertex_indices\nend_header\n"
                       "0 0 0\n1 0 0\n0 1 0\n" +
                       lines(bytes, "", [](Text& t, std::size_t) { t.add("0\n"); }));
  add("long_list.ply", head + vertices +
                           "element face 1\nproperty list uint int vertex_indices\nend_header\n"
                           "0 0 0\n1 0 0\n0 1 0\n4000000000" +
                           lines(bytes, "", [](Text& t, std::size_t k) { t.add(' ', k % 3); }));
  add("vertices_that_are_not_there.ply",
      "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty "
      "float y\nproperty float z\n" +
          faces + "end_header\n" + std::string(bytes, '\0'));
  add("vertices_of_no_size.ply",
      "ply\nformat binary_little_endian 1.0\nelement thing 18446744073709551615\nproperty list "
      "uchar char a\n" +
          vertices + faces + "end_header\n" + std::string(bytes, '\0'));
  add("empty_lists.ply",
      "ply\nformat binary_big_endian 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
      "property float z\nelement face " +
          std::to_string(bytes) + "\nproperty list uchar int vertex_indices\nend_header\n" +
          std::string(bytes, '\0'));
  add("counts.off", "OFF\n4000000000 4000000000 4000000000\n" + std::string(bytes, '0'));
  add("long_polygon.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n" + std::to_string(bytes / 2) +
                              lines(bytes, "", [](Text& t, std::size_t k) { t.add(' ', k % 3); }));
  add("comments.off", lines(bytes, "OFF\n", [](Text& t, std::size_t) { t.add("#\n"); }));
  return files;
}

}  // namespace planish::fault
