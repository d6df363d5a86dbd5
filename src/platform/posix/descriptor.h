#pragma once

#include <cerrno>
#include <system_error>
#include <utility>

#include <unistd.h>

namespace planish {

/// The cause that the last call of the system left.
inline std::error_code last_fault() {
  return {errno, std::generic_category()};
}

/// A file descriptor that closes itself. Negative where opening failed.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }

  /// Closes now; false, with errno set, where the system could not keep what was written.
  bool close() { return ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

}  // namespace planish
