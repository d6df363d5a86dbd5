#pragma once

#include <system_error>

#include <windows.h>

namespace planish {

/// The cause that an error of the system has in the words of errno, whose messages are in English
/// and in UTF-8. A file that another program holds open is std::errc::text_file_busy.
std::error_code fault_of(DWORD error) noexcept;

/// A name like NUL or COM1.txt, which stands for a device: no file can have it.
std::error_code fault_of_device_name() noexcept;

/// The cause that the last call of the system left.
inline std::error_code last_fault() noexcept {
  return fault_of(GetLastError());
}

/// A handle that closes itself. Children do not inherit it.
class Handle {
 public:
  explicit Handle(HANDLE handle) : handle_(handle == INVALID_HANDLE_VALUE ? nullptr : handle) {}
  ~Handle() {
    if (handle_ != nullptr) CloseHandle(handle_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  explicit operator bool() const { return handle_ != nullptr; }
  HANDLE get() const { return handle_; }

 private:
  HANDLE handle_;
};

}  // namespace planish
