#pragma once

// What a fuzz target may not get: anything else than a result that holds, or an Error.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <planish/core/error.h>
#include <planish/core/vec.h>

namespace planish::fuzz {

/// Ends the process, which is a finding, where a promise does not hold.
inline void check(bool holds, const char* promise) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n", promise);
  std::abort();
}

inline bool is_finite(Vec2 p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}
inline bool is_finite(Vec3 p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

inline void check_message(const Error& error) {
  check(!error.message().empty() && error.message().size() < 400,
        "messages are neither empty nor long");
}

/// Does work that may be refused.
template <class Work>
void allow_refusal(Work&& work) {
  try {
    work();
  } catch (const Error& error) {
    check_message(error);
  }
}

/// Reads what may be refused: then the error says where it is in what is called `name`, or is
/// about the mesh as a whole.
template <class Read>
void allow_refusal_of(const std::string& name, Read&& read) {
  try {
    read();
  } catch (const Error& error) {
    check_message(error);
    const SourceLocation& place = error.place();
    check(place.path == name, "errors of files name the file");
    check(place.line.has_value() || place.byte.has_value() ||
              error.code() == ErrorCode::too_large || error.code() == ErrorCode::no_triangles,
          "errors of files tell the place");
  }
}

}  // namespace planish::fuzz

/// What libFuzzer and replay.cpp call.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
