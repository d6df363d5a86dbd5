#include <string>

#include "platform/windows/handle.h"

namespace planish {

namespace {

enum class Cause { in_use = 1, device };

/// Causes that the C library has no words for.
class OfWindows : public std::error_category {
 public:
  const char* name() const noexcept override { return "windows"; }
  std::string message(int cause) const override {
    return cause == static_cast<int>(Cause::in_use)
               ? "another program has it open; close it there and try again"
               : "Windows keeps this name for a device; choose another one";
  }
  std::error_condition default_error_condition(int cause) const noexcept override {
    return cause == static_cast<int>(Cause::in_use) ? std::errc::text_file_busy
                                                    : std::errc::invalid_argument;
  }
};

std::error_code fault_of(Cause cause) noexcept {
  static const OfWindows category;
  return {static_cast<int>(cause), category};
}

std::errc generic_cause(DWORD error) noexcept {
  switch (error) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_NAME:
    case ERROR_BAD_PATHNAME:
    case ERROR_BAD_NETPATH:
    case ERROR_BAD_NET_NAME:
    case ERROR_INVALID_DRIVE:
      return std::errc::no_such_file_or_directory;
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS:
      return std::errc::file_exists;
    case ERROR_ACCESS_DENIED:
      return std::errc::permission_denied;
    case ERROR_WRITE_PROTECT:
      return std::errc::read_only_file_system;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL:
      return std::errc::no_space_on_device;
    case ERROR_FILENAME_EXCED_RANGE:
      return std::errc::filename_too_long;
    case ERROR_NOT_ENOUGH_MEMORY:
    case ERROR_OUTOFMEMORY:
      return std::errc::not_enough_memory;
    case ERROR_TOO_MANY_OPEN_FILES:
      return std::errc::too_many_files_open;
    case ERROR_DIRECTORY:
      return std::errc::not_a_directory;
    case ERROR_CANT_RESOLVE_FILENAME:
      return std::errc::too_many_symbolic_link_levels;
    case ERROR_NOT_SAME_DEVICE:
      return std::errc::cross_device_link;
    default:
      return std::errc::io_error;
  }
}

}  // namespace

std::error_code fault_of(DWORD error) noexcept {
  const bool is_held = error == ERROR_SHARING_VIOLATION || error == ERROR_LOCK_VIOLATION ||
                       error == ERROR_USER_MAPPED_FILE;
  return is_held ? fault_of(Cause::in_use) : std::make_error_code(generic_cause(error));
}

std::error_code fault_of_device_name() noexcept {
  return fault_of(Cause::device);
}

}  // namespace planish
