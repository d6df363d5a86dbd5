#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <planish/core/error.h>
#include <planish/io/mesh_format.h>
#include <planish/io/read_features.h>
#include <planish/io/read_mesh.h>

#include <gtest/gtest.h>

#include "property/property.h"

namespace planish {
namespace {

/// Reads and checks that a mesh comes out as promised, or an Error with a short message.
void check_reading(const std::string& bytes, MeshFormat format) {
  // A copy of exactly this size, so that a sanitizer sees a step outside.
  const std::vector<char> copy(bytes.begin(), bytes.end());
  try {
    const TriMesh mesh = parse_mesh({copy.data(), copy.size()}, format).mesh;
    RC_ASSERT(!mesh.triangles.empty());
    for (const Vec3& p : mesh.positions) {
      RC_ASSERT(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    }
    for (const Triangle& triangle : mesh.triangles) {
      for (const Index v : triangle)
        RC_ASSERT(v < mesh.positions.size());
    }
  } catch (const Error& error) {
    RC_ASSERT(error.message().size() < 400U);
  }
}

TriMesh fan() {
  return {.positions = {{0, 0, 0.5}, {1, 0, 0}, {0.25, 1, 0}, {-1, 0.125, 0}, {0, -1e-3, 0}},
          .triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}}};
}

const std::string k_ascii_ply =
    "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n"
    "element vertex 4\nproperty float x\nproperty uchar red\nproperty float y\nproperty float z\n"
    "end_header\n4 0 1 2 3\n0 9 0 0\n1 9 0 0\n1 9 1 0\n0 9 1 0\n";

const std::string k_ascii_stl =
    "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid\n";

std::pair<MeshFormat, std::string> any_sample() {
  const int number = *rc::gen::inRange(0, 6);
  if (number == 4) return {MeshFormat::ply, k_ascii_ply};
  if (number == 5) return {MeshFormat::stl, k_ascii_stl};
  const MeshFormat format = k_mesh_formats[static_cast<std::size_t>(number)];
  return {format, format_mesh(fan(), format)};
}

PLANISH_PROPERTY(IoDamage, BytesThatFlipAreReadOrRefused, 40'000) {
  auto [format, bytes] = any_sample();
  for (int flips = *rc::gen::inRange(1, 8); flips > 0; --flips) {
    bytes[*rc::gen::inRange<std::size_t>(0, bytes.size())] = *rc::gen::arbitrary<char>();
  }
  check_reading(bytes, format);
}

PLANISH_PROPERTY(IoDamage, PiecesThatGoOrComeTwiceAreReadOrRefused, 40'000) {
  auto [format, bytes] = any_sample();
  const auto begin = *rc::gen::inRange<std::size_t>(0, bytes.size());
  const auto piece = bytes.substr(begin, *rc::gen::inRange<std::size_t>(1, 40));
  if (*rc::gen::arbitrary<bool>()) {
    bytes.erase(begin, piece.size());
  } else {
    bytes.insert(*rc::gen::inRange<std::size_t>(0, bytes.size()), piece);
  }
  check_reading(bytes, format);
}

PLANISH_PROPERTY(IoDamage, WordsOfAnyKindAreReadOrRefused, 1'000) {
  const std::vector<std::string> words = {
      "v",     "f",       "1",       "-1",     "2/3",      "4294967296", "nan",    "1e999",
      "0,5",   "#",       "\\\n",    "\n",     "\r",       " ",          "OFF",    "solid",
      "facet", "normal",  "outer",   "loop",   "endsolid", "ply\n",      "format", "ascii",
      "list",  "element", "vertex",  "face",   "x",        "property",   "uchar",  "end_header\n",
      "0 0 0", "3 0 1 2", "f 1 2 3", "v 0 0 0"};
  std::string text =
      *rc::gen::elementOf<std::vector<std::string>>({"", "OFF\n", "ply\n", "solid\n"});
  for (const std::string& word :
       *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(words))) {
    text += word;
    text += *rc::gen::element(' ', '\n');
  }
  for (const MeshFormat format : k_mesh_formats)
    check_reading(text, format);
}

PLANISH_PROPERTY(IoDamage, FeaturesOfAnyKindAreReadOrRefused, 1'000) {
  const std::vector<std::string> words = {
      "v",   "l",          "p",         "f",       "0",      "1",      "4",    "-1",
      "2/3", "4294967296", "nan",       "0.5",     ",",      "#",      "\\\n", "\n",
      "\r",  "v 0 0 0\n",  "v 1 2 3\n", "l 1 2\n", "p -1\n", "3 0.5\n"};
  std::string text;
  for (const std::string& word :
       *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(words))) {
    text += word;
    text += *rc::gen::element(' ', '\n');
  }
  const std::vector<char> copy(text.begin(), text.end());
  const std::string_view bytes(copy.data(), copy.size());
  const auto check = [](const auto& read) {
    try {
      read();
    } catch (const Error& error) {
      RC_ASSERT(error.message().size() < 400U);
      RC_ASSERT(error.place().line.has_value());
    }
  };
  for (const char* name : {"fixed.txt", "fixed.obj"}) {
    check([&] {
      for (const Index v : parse_fixed_vertices(bytes, Patch(fan()), name).vertices)
        RC_ASSERT(v < 5U);
    });
  }
  check([&] {
    for (const double weight : weights_in(parse_rows(bytes, "weights"), fan().positions.size()))
      RC_ASSERT(weight > 0.0 && std::isfinite(weight));
  });
}

}  // namespace
}  // namespace planish
