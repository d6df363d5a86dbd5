#include "platform/file.h"

#include <cstdio>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include "platform/posix/descriptor.h"

namespace planish {

namespace {

struct ReadBytes {
  std::string bytes;
  std::error_code fault = {};
};

ReadBytes read_all(const Descriptor& file) {
  constexpr std::size_t k_piece = 1 << 16;
  ReadBytes read;
  for (;;) {
    const std::size_t size = read.bytes.size();
    read.bytes.resize(size + k_piece);
    const ssize_t got = ::read(file.number(), read.bytes.data() + size, k_piece);
    if (got < 0 && errno != EINTR) return {{}, last_fault()};
    read.bytes.resize(size + (got > 0 ? static_cast<std::size_t>(got) : 0));
    if (got == 0) return read;
  }
}

/// Writes all and closes.
std::error_code write_all(Descriptor file, std::string_view content) {
  if (file.number() < 0) return last_fault();
  while (!content.empty()) {
    const ssize_t written = ::write(file.number(), content.data(), content.size());
    if (written < 0 && errno != EINTR) return last_fault();
    if (written > 0) content.remove_prefix(static_cast<std::size_t>(written));
  }
  return file.close() ? std::error_code() : last_fault();
}

}  // namespace

FileContent::FileContent(const std::filesystem::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status = {};
  if (file.number() < 0 || ::fstat(file.number(), &status) != 0) {
    fault_ = last_fault();
    return;
  }
  if (S_ISDIR(status.st_mode)) {
    fault_ = std::make_error_code(std::errc::is_a_directory);
    return;
  }
  is_device_ = S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode);
  if (is_device_) return;
  if (S_ISREG(status.st_mode) && status.st_size > 0) {
    map_size_ = static_cast<std::size_t>(status.st_size);
    map_ = ::mmap(nullptr, map_size_, PROT_READ, MAP_PRIVATE, file.number(), 0);
    if (map_ != MAP_FAILED) return;
    map_ = nullptr;  // some file systems cannot map
  }
  ReadBytes read = read_all(file);
  read_ = std::move(read.bytes);
  fault_ = read.fault;
}

FileContent::~FileContent() {
  if (map_ != nullptr) ::munmap(map_, map_size_);
}

std::error_code write_new_file(const std::filesystem::path& path, std::string_view content) {
  constexpr mode_t k_mode = 0666;  // the user's mask takes away what it should
  return write_all(
      Descriptor(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, k_mode)), content);
}

std::error_code write_into(const std::filesystem::path& path, std::string_view content) {
  return write_all(Descriptor(::open(path.c_str(), O_WRONLY | O_CLOEXEC)), content);
}

std::error_code replace_file(const std::filesystem::path& from,
                             const std::filesystem::path& to) noexcept {
  return std::rename(from.c_str(), to.c_str()) == 0 ? std::error_code() : last_fault();
}

std::error_code hold_on(const std::filesystem::path&) noexcept {
  return {};
}

long process_number() noexcept {
  return ::getpid();
}

}  // namespace planish
