#pragma once

#include <stdexcept>
#include <string>

#include <planish/core/error.h>

namespace planish::cli {

/// The command line is wrong: exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Whether the command line alone is at fault: what files and meshes hold has other codes.
inline bool is_of_usage(const Error& error) {
  return error.code() == ErrorCode::option_out_of_range ||
         error.code() == ErrorCode::unknown_name ||
         error.code() == ErrorCode::unsupported_constraint;
}

/// Runs work on the mesh of a file, so that what is wrong with the mesh names the file.
template <class Work>
auto about(const std::string& path, Work&& work) {
  try {
    return work();
  } catch (const Error& error) {
    if (is_of_usage(error) || !error.place().path.empty()) throw;
    SourceLocation place = error.place();
    place.path = path;
    throw Error(error.code(), error.message(), place);
  }
}

/// Runs work that a flag or a file asks for, so that errors begin with its name.
template <class Work>
auto asked_in(const std::string& where, Work&& work) {
  try {
    return work();
  } catch (const UsageError& error) {
    throw UsageError(where + ": " + error.what());
  } catch (const Error& error) {
    throw Error(error.code(), where + ": " + error.message(), error.place());
  }
}

}  // namespace planish::cli
