#include "platform/file.h"

#include <algorithm>
#include <array>
#include <utility>

#include <windows.h>

#include "platform/windows/handle.h"

namespace planish {

namespace {

namespace fs = std::filesystem;

/// Others may do with an open file what they like, as far as the system lets them.
constexpr DWORD k_share_all = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;

struct ReadBytes {
  std::string bytes;
  std::error_code fault = {};
};

/// To the end of a file, or of a pipe whose writers have gone.
ReadBytes read_all(const Handle& file) {
  constexpr std::size_t k_piece = 1 << 16;
  ReadBytes read;
  for (;;) {
    const std::size_t size = read.bytes.size();
    read.bytes.resize(size + k_piece);
    DWORD got = 0;
    if (ReadFile(file.get(), read.bytes.data() + size, k_piece, &got, nullptr) == 0 &&
        GetLastError() != ERROR_BROKEN_PIPE) {
      return {{}, last_fault()};
    }
    read.bytes.resize(size + got);
    if (got == 0) return read;
  }
}

/// A view of a whole file that is not empty; null where the file system has none.
void* map_of(const Handle& file) {
  const Handle mapping(CreateFileMappingW(file.get(), nullptr, PAGE_READONLY, 0, 0, nullptr));
  return mapping ? MapViewOfFile(mapping.get(), FILE_MAP_READ, 0, 0, 0) : nullptr;
}

std::error_code write_all(const Handle& file, std::string_view content) {
  constexpr std::size_t k_most = std::size_t{1} << 30;  // of one call
  if (!file) return last_fault();
  while (!content.empty()) {
    const DWORD size = static_cast<DWORD>(std::min(content.size(), k_most));
    DWORD written = 0;
    if (WriteFile(file.get(), content.data(), size, &written, nullptr) == 0) return last_fault();
    content.remove_prefix(written);
  }
  return {};
}

bool is_read_only(const fs::path& path) noexcept {
  const DWORD attributes = GetFileAttributesW(path.c_str());
  return attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_READONLY) != 0;
}

/// Whether the system puts a device for the name, whatever its folder and extension.
bool is_device_name(const fs::path& path) {
  std::array<wchar_t, MAX_PATH> full = {};
  const fs::path name = path.filename();
  const DWORD size = GetFullPathNameW(name.c_str(), MAX_PATH, full.data(), nullptr);
  return size < MAX_PATH && std::wstring_view(full.data(), size).starts_with(L"\\\\.\\");
}

/// One try. Some systems say that access is refused where another program has a file open.
std::error_code try_to_replace(const fs::path& from, const fs::path& to) noexcept {
  if (is_read_only(to)) return std::make_error_code(std::errc::permission_denied);
  if (MoveFileExW(from.c_str(), to.c_str(), MOVEFILE_REPLACE_EXISTING) != 0) return {};
  const std::error_code fault = last_fault();
  if (fault != std::errc::permission_denied) return fault;
  for (const fs::path* const path : {&to, &from}) {
    const std::error_code hold = hold_on(*path);
    if (hold) return hold;
  }
  return fault;
}

}  // namespace

FileContent::FileContent(const fs::path& path) {
  // With this flag a folder opens too, and is not mistaken for a file that may not be read.
  const Handle file(CreateFileW(path.c_str(), GENERIC_READ, k_share_all, nullptr, OPEN_EXISTING,
                                FILE_FLAG_BACKUP_SEMANTICS, nullptr));
  if (!file) {
    fault_ = last_fault();
    return;
  }
  const DWORD type = GetFileType(file.get());
  is_device_ = type == FILE_TYPE_CHAR;
  if (is_device_) return;
  BY_HANDLE_FILE_INFORMATION status = {};
  if (type == FILE_TYPE_DISK && GetFileInformationByHandle(file.get(), &status) != 0) {
    if ((status.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0) {
      fault_ = std::make_error_code(std::errc::is_a_directory);
      return;
    }
    map_size_ = (std::size_t{status.nFileSizeHigh} << 32) + status.nFileSizeLow;
    map_ = map_size_ > 0 ? map_of(file) : nullptr;
    if (map_ != nullptr) return;
  }
  ReadBytes read = read_all(file);
  read_ = std::move(read.bytes);
  fault_ = read.fault;
}

FileContent::~FileContent() {
  if (map_ != nullptr) UnmapViewOfFile(map_);
}

std::error_code write_new_file(const fs::path& path, std::string_view content) {
  if (is_device_name(path)) return fault_of_device_name();
  return write_all(Handle(CreateFileW(path.c_str(), GENERIC_WRITE, FILE_SHARE_READ, nullptr,
                                      CREATE_NEW, FILE_ATTRIBUTE_NORMAL, nullptr)),
                   content);
}

std::error_code write_into(const fs::path& path, std::string_view content) {
  return write_all(Handle(CreateFileW(path.c_str(), GENERIC_WRITE, k_share_all, nullptr,
                                      OPEN_EXISTING, 0, nullptr)),
                   content);
}

std::error_code replace_file(const fs::path& from, const fs::path& to) noexcept {
  constexpr DWORD k_longest_wait = 400;  // ms; scanners hold new files open for a moment
  std::error_code fault = try_to_replace(from, to);
  for (DWORD wait = 25; fault == std::errc::text_file_busy && wait <= k_longest_wait; wait *= 2) {
    Sleep(wait);
    fault = try_to_replace(from, to);
  }
  return fault;
}

std::error_code hold_on(const fs::path& path) noexcept {
  if (is_read_only(path)) return std::make_error_code(std::errc::permission_denied);
  const Handle file(CreateFileW(path.c_str(), DELETE, k_share_all, nullptr, OPEN_EXISTING,
                                FILE_FLAG_BACKUP_SEMANTICS | FILE_FLAG_OPEN_REPARSE_POINT,
                                nullptr));
  return file || GetLastError() == ERROR_FILE_NOT_FOUND ? std::error_code() : last_fault();
}

long process_number() noexcept {
  return static_cast<long>(GetCurrentProcessId());
}

}  // namespace planish
