#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <planish/core/error.h>
#include <planish/io/read_mesh.h>

#include <gtest/gtest.h>

#include "support/own_folder.h"

namespace planish {

/// The error that a call throws; a failure of the test and an empty error if it throws none.
template <class Call>
Error error_of(Call call) {
  try {
    call();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "no error was thrown";
  return {ErrorCode::unknown_name, ""};
}

/// The error that reading `bytes` throws. Checks its code and that the message has `part`.
inline Error refusal(std::string_view bytes, MeshFormat format, ErrorCode code,
                     std::string_view part = {}) {
  const Error error = error_of([&] { parse_mesh(bytes, format, "mesh"); });
  EXPECT_EQ(to_string(error.code()), to_string(code)) << error.what();
  EXPECT_NE(error.message().find(part), std::string::npos) << error.what();
  EXPECT_EQ(error.place().path, "mesh");
  return error;
}

/// Checks that reading `text` is refused with this code on this line.
inline void expect_refused(std::string_view text, MeshFormat format, ErrorCode code,
                           std::size_t line, std::string_view part = {}) {
  const Error error = refusal(text, format, code, part);
  EXPECT_EQ(error.place().line, line) << error.what();
  EXPECT_FALSE(error.place().byte) << error.what();
}

/// Checks that reading `bytes` is refused with this code at this byte.
inline void expect_refused_at_byte(std::string_view bytes, MeshFormat format, ErrorCode code,
                                   std::size_t byte, std::string_view part = {}) {
  const Error error = refusal(bytes, format, code, part);
  EXPECT_EQ(error.place().byte, byte) << error.what();
  EXPECT_FALSE(error.place().line) << error.what();
}

/// Whether two meshes are the same bit for bit, so that -0.0 is not 0.0.
inline bool same_bits(const TriMesh& a, const TriMesh& b) {
  return a.triangles == b.triangles && a.positions.size() == b.positions.size() &&
         (a.positions.empty() || std::memcmp(a.positions.data(), b.positions.data(),
                                             a.positions.size() * sizeof(Vec3)) == 0);
}

/// Two triangles over the unit square.
inline TriMesh square() {
  return {.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
          .triangles = {{0, 1, 2}, {0, 2, 3}}};
}

/// Its vertices, a line each, as OFF and PLY have them.
inline const std::string k_square_positions = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

/// The bytes of numbers, each in its own type, in the given order.
template <class... Numbers>
std::string packed(std::endian order, Numbers... numbers) {
  std::string bytes;
  const auto add = [&](auto number) {
    auto piece = std::bit_cast<std::array<char, sizeof number>>(number);
    if (order == std::endian::native) {
      bytes.append(piece.begin(), piece.end());
    } else {
      bytes.append(piece.rbegin(), piece.rend());
    }
  };
  (add(numbers), ...);
  return bytes;
}

}  // namespace planish
