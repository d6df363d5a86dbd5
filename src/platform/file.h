#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

// What std::filesystem leaves open: reading a whole file, writing a whole one, and putting one in
// the place of another. A failure comes back as the system's cause; who calls makes an Error of it.

namespace planish {

/// The content of a file for as long as the object lives: mapped if it is a regular file, read to
/// its end if it is a pipe. Symbolic links are followed. While a file is mapped, what others write
/// into it may show. On Windows nobody can replace a mapped file: destroy the object soon.
class FileContent {
 public:
  /// @throws std::bad_alloc
  explicit FileContent(const std::filesystem::path& path);
  ~FileContent();
  FileContent(const FileContent&) = delete;
  FileContent& operator=(const FileContent&) = delete;

  /// Why there is no content; no error if there is. A folder is std::errc::is_a_directory.
  std::error_code fault() const { return fault_; }
  /// A device is not read, as it may have no end: no content and no fault.
  bool is_device() const { return is_device_; }
  std::string_view bytes() const {
    return map_ == nullptr ? std::string_view(read_)
                           : std::string_view(static_cast<const char*>(map_), map_size_);
  }

 private:
  std::error_code fault_;
  bool is_device_ = false;
  void* map_ = nullptr;
  std::size_t map_size_ = 0;
  std::string read_;
};

/// Makes a file and writes all of it. The user's mask says who else may read it. It does not wait
/// until a disk has it. What a failure leaves of the file, the caller removes.
/// @return std::errc::file_exists where something stands there, also a link that leads nowhere
[[nodiscard]] std::error_code write_new_file(const std::filesystem::path& path,
                                             std::string_view content);

/// Writes all into a device or a pipe that is there; waits for a pipe's reader.
[[nodiscard]] std::error_code write_into(const std::filesystem::path& path,
                                         std::string_view content);

/// Gives a file the name of another one in the same folder, in one step: whoever opens that name
/// finds the old content or the new one. The old file loses the name; its permissions do not pass
/// on. A symbolic link there is replaced, not followed. Where a failure comes back, nothing has
/// changed.
///
/// Windows does not replace a file that another program has open. Virus scanners hold new files
/// open for a moment, so it tries again for a second.
std::error_code replace_file(const std::filesystem::path& from,
                             const std::filesystem::path& to) noexcept;

/// Why a file that is there cannot lose its name now: on Windows another program may have it open,
/// which is std::errc::text_file_busy, or it is read-only. No error where it can, or where nothing
/// is there. Ask before it gets a second name, which could not be removed then.
std::error_code hold_on(const std::filesystem::path& path) noexcept;

/// A number that no other running process has.
long process_number() noexcept;

}  // namespace planish
