#include <cerrno>
#include <string_view>
#include <system_error>
#include <vector>

#include <planish/core/error.h>
#include <planish/io/write_file.h>

#include <fcntl.h>
#include <unistd.h>

#include "io/descriptor.h"

namespace planish {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& cause) {
  throw Error(ErrorCode::file_unwritable, "cannot be written: " + cause, {.path = path.string()});
}

[[noreturn]] void fail(const fs::path& path, int cause) {
  fail(path, std::generic_category().message(cause));
}

/// Writes all and closes. @param path for errors
void write_all(Descriptor& file, std::string_view content, const fs::path& path) {
  while (!content.empty()) {
    const ssize_t written = ::write(file.number(), content.data(), content.size());
    if (written < 0 && errno != EINTR) fail(path, errno);
    if (written > 0) content.remove_prefix(static_cast<std::size_t>(written));
  }
  if (!file.close()) fail(path, errno);
}

/// Where renaming has to put the file: a symbolic link stays, what it points to is replaced.
fs::path place_of(const fs::path& path) {
  std::error_code none;
  if (!fs::is_symlink(path, none)) return path;
  const fs::path place = fs::canonical(path, none);
  return none ? path : place;
}

/// Writes beside the places, renames, and takes everything back unless commit() went through.
class Transaction {
 public:
  Transaction() = default;
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction() {
    if (!committed_) take_back();
  }

  void prepare(const OutputFile& file);
  void commit();

 private:
  struct Pending {
    fs::path path;      ///< as asked for
    fs::path place;     ///< where it goes
    fs::path partial;   ///< holds the new content until it is renamed
    fs::path previous;  ///< a second name of the old content; empty where there is none
    bool placed = false;
  };

  void make_folders(const fs::path& folder, const fs::path& path);
  fs::path free_name(const fs::path& place);
  void keep_previous(Pending& pending);
  void take_back() noexcept;

  std::vector<Pending> pending_;
  std::vector<const OutputFile*> direct_;
  std::vector<fs::path> folders_;  ///< that were made, outer ones first
  std::size_t names_ = 0;
  bool committed_ = false;
};

void Transaction::prepare(const OutputFile& file) {
  std::error_code none;
  const fs::file_status status = fs::status(file.path, none);
  if (!file.path.has_filename()) fail(file.path, "the path names no file");
  if (fs::is_directory(status)) fail(file.path, EISDIR);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    direct_.push_back(&file);  // a device or pipe: nothing can be renamed over it
    return;
  }
  const fs::path place = place_of(file.path);
  make_folders(place.parent_path(), file.path);
  const fs::path partial = free_name(place);
  constexpr mode_t k_mode = 0666;  // the user's mask takes away what it should
  Descriptor out(::open(partial.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, k_mode));
  if (out.number() < 0) fail(file.path, errno);
  pending_.push_back({.path = file.path, .place = place, .partial = partial, .previous = {}});
  write_all(out, file.content, file.path);
}

/// @param path for errors
void Transaction::make_folders(const fs::path& folder, const fs::path& path) {
  std::vector<fs::path> missing;
  std::error_code fault;
  for (fs::path at = folder; !at.empty() && !fs::exists(at, fault); at = at.parent_path()) {
    if (fault) fail(path, fault.message());
    if (at.has_filename()) missing.push_back(at);
  }
  for (; !missing.empty(); missing.pop_back()) {
    if (fs::create_directory(missing.back(), fault)) {
      folders_.push_back(missing.back());
    } else if (fault) {
      fail(path, fault.message());
    }
  }
}

fs::path Transaction::free_name(const fs::path& place) {
  fs::path name;
  std::error_code none;
  do {
    name = place;
    name += ".planish-partial-" + std::to_string(::getpid()) + "-" + std::to_string(names_++);
  } while (fs::exists(fs::symlink_status(name, none)));
  return name;
}

/// Gives the old content a second name, so that it can be put back should a later file fail.
void Transaction::keep_previous(Pending& pending) {
  std::error_code fault;
  if (!fs::exists(fs::symlink_status(pending.place, fault))) return;
  const fs::path previous = free_name(pending.place);
  fs::create_hard_link(pending.place, previous, fault);
  if (!fault) pending.previous = previous;  // some file systems cannot: then all or some
}

void Transaction::commit() {
  for (const OutputFile* const file : direct_) {
    Descriptor out(::open(file->path.c_str(), O_WRONLY | O_CLOEXEC));
    if (out.number() < 0) fail(file->path, errno);
    write_all(out, file->content, file->path);
  }
  for (Pending& pending : pending_) {
    if (pending_.size() > 1) keep_previous(pending);
    std::error_code fault;
    fs::rename(pending.partial, pending.place, fault);
    if (fault) fail(pending.path, fault.message());
    pending.placed = true;
  }
  committed_ = true;
  std::error_code none;
  for (const Pending& pending : pending_) {
    if (!pending.previous.empty()) fs::remove(pending.previous, none);
  }
}

void Transaction::take_back() noexcept {
  std::error_code none;
  for (; !pending_.empty(); pending_.pop_back()) {
    const Pending& pending = pending_.back();
    if (!pending.previous.empty()) {
      fs::rename(pending.previous, pending.place, none);
      // Two names of one file: renaming does nothing and leaves both.
      fs::remove(pending.previous, none);
    } else if (pending.placed) {
      fs::remove(pending.place, none);
    }
    fs::remove(pending.partial, none);
  }
  for (; !folders_.empty(); folders_.pop_back()) {
    fs::remove(folders_.back(), none);  // only where it is empty
  }
}

}  // namespace

void write_files(std::span<const OutputFile> files) {
  Transaction transaction;
  for (const OutputFile& file : files)
    transaction.prepare(file);
  transaction.commit();
}

}  // namespace planish
