#include "io/file_bytes.h"

#include <cerrno>
#include <system_error>

#include <planish/core/error.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/descriptor.h"

namespace planish {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int cause) {
  const bool missing = cause == ENOENT || cause == ENOTDIR;
  throw Error(missing ? ErrorCode::file_not_found : ErrorCode::file_unreadable,
              "cannot be read: " + std::generic_category().message(cause), {.path = path.string()});
}

std::string read_all(int descriptor, const std::filesystem::path& path) {
  constexpr std::size_t k_piece = 1 << 16;
  std::string bytes;
  for (;;) {
    const std::size_t size = bytes.size();
    bytes.resize(size + k_piece);
    const ssize_t got = ::read(descriptor, bytes.data() + size, k_piece);
    if (got < 0 && errno != EINTR) fail(path, errno);
    bytes.resize(size + (got > 0 ? static_cast<std::size_t>(got) : 0));
    if (got == 0) return bytes;
  }
}

}  // namespace

FileBytes::FileBytes(const std::filesystem::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status = {};
  if (file.number() < 0 || ::fstat(file.number(), &status) != 0) fail(path, errno);
  if (S_ISDIR(status.st_mode)) fail(path, EISDIR);
  if (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)) {
    // A device may have no end.
    throw Error(ErrorCode::file_unreadable, "is a device", {.path = path.string()});
  }
  const bool regular = S_ISREG(status.st_mode) && status.st_size > 0;
  if (regular) {
    map_size_ = static_cast<std::size_t>(status.st_size);
    map_ = ::mmap(nullptr, map_size_, PROT_READ, MAP_PRIVATE, file.number(), 0);
    if (map_ != MAP_FAILED) return;
    map_ = nullptr;  // some file systems cannot map
  }
  read_ = read_all(file.number(), path);
}

FileBytes::~FileBytes() {
  if (map_ != nullptr) ::munmap(map_, map_size_);
}

}  // namespace planish
