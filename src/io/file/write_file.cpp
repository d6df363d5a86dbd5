#include <new>
#include <system_error>
#include <utility>
#include <vector>

#include <planish/core/error.h>
#include <planish/io/write_file.h>

#include "platform/file.h"
#include "platform/path.h"

namespace planish {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& cause) {
  throw Error(ErrorCode::file_unwritable, "cannot be written: " + cause, {.path = utf8_of(path)});
}

[[noreturn]] void fail(const fs::path& path, std::error_code cause) {
  fail(path, cause.message());
}

/// Where renaming has to put a file that the caller named: a symbolic link stays, what it points to
/// is replaced.
fs::path place_of(const fs::path& path) {
  std::error_code fault;
  if (!fs::is_symlink(fs::symlink_status(path, fault))) return path;
  const fs::path place = fs::canonical(path, fault);
  if (fault == std::errc::not_enough_memory) throw std::bad_alloc();
  return fault ? path : place;  // one that leads nowhere is replaced itself
}

/// What is left of the path below the folder; empty where it is elsewhere.
fs::path below(const fs::path& folder, const fs::path& path) {
  if (folder.empty()) return {};
  fs::path rest = fs::absolute(path).lexically_normal().lexically_relative(
      (fs::absolute(folder) / fs::path()).lexically_normal());
  return rest.empty() || *rest.begin() == path_of("..") ? fs::path() : rest;
}

/// Nothing below the output folder may lead out of it.
/// @param rest of the path, below the folder
void refuse_links(const fs::path& folder, const fs::path& rest, const fs::path& path) {
  std::error_code none;
  fs::path at = folder;
  for (const fs::path& name : rest.parent_path()) {
    at /= name;
    if (fs::is_symlink(fs::symlink_status(at, none))) {
      fail(path, utf8_of(at) + " is a symbolic link, which might lead out of the output folder");
    }
  }
  const fs::file_status last = fs::symlink_status(path, none);
  if (fs::is_other(last)) fail(path, "is no file");
}

/// Writes beside the places, renames, and takes everything back unless commit() went through.
class Transaction {
 public:
  /// @param folder below which no symbolic link is followed; empty for none
  explicit Transaction(const fs::path& folder) : folder_(folder) {}
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

  const fs::path& folder_;
  std::vector<Pending> pending_;
  std::vector<const OutputFile*> direct_;
  std::vector<fs::path> folders_;  ///< that were made, outer ones first
  std::size_t names_ = 0;
  bool committed_ = false;
};

void Transaction::prepare(const OutputFile& file) {
  std::error_code none;
  const fs::path rest = below(folder_, file.path);
  const bool inside = !rest.empty();
  if (inside) refuse_links(folder_, rest, file.path);
  const fs::file_status status =
      inside ? fs::symlink_status(file.path, none) : fs::status(file.path, none);
  if (!file.path.has_filename()) fail(file.path, "the path names no file");
  if (fs::is_directory(status)) fail(file.path, std::make_error_code(std::errc::is_a_directory));
  if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_symlink(status)) {
    direct_.push_back(&file);  // a device or pipe: nothing can be renamed over it
    return;
  }
  const fs::path place = inside ? file.path : place_of(file.path);
  make_folders(place.parent_path(), file.path);
  // Known before it is there: whatever fails from here on, it is taken back.
  pending_.push_back(
      {.path = file.path, .place = place, .partial = free_name(place), .previous = {}});
  const std::error_code fault = write_new_file(pending_.back().partial, file.content);
  if (fault) fail(file.path, fault);
}

/// @param path for errors
void Transaction::make_folders(const fs::path& folder, const fs::path& path) {
  std::vector<fs::path> missing;
  std::error_code fault;
  // The parent of a drive is the drive itself, also where there is none.
  for (fs::path at = folder; at.has_relative_path() && !fs::exists(at, fault);
       at = at.parent_path()) {
    if (fault) fail(path, fault);
    if (at.has_filename()) missing.push_back(at);
  }
  folders_.reserve(folders_.size() + missing.size());
  for (; !missing.empty(); missing.pop_back()) {
    if (fs::create_directory(missing.back(), fault)) {
      folders_.push_back(std::move(missing.back()));
    } else if (fault) {
      fail(path, fault);
    }
  }
}

fs::path Transaction::free_name(const fs::path& place) {
  fs::path name;
  std::error_code none;
  do {
    name = place;
    name += path_of(".planish-partial-" + std::to_string(process_number()) + "-" +
                    std::to_string(names_++));
  } while (fs::exists(fs::symlink_status(name, none)));
  return name;
}

/// Gives the old content a second name, so that it can be put back should a later file fail.
void Transaction::keep_previous(Pending& pending) {
  std::error_code fault;
  const fs::file_status status = fs::symlink_status(pending.place, fault);
  if (!fs::is_regular_file(status) && !fs::is_symlink(status)) return;
  const std::error_code hold = hold_on(pending.place);
  if (hold) fail(pending.path, hold);
  fs::path previous = free_name(pending.place);
  fs::create_hard_link(pending.place, previous, fault);
  // Some file systems have no second names: there the first one goes.
  if (fault) fs::rename(pending.place, previous, fault);
  if (fault) fail(pending.path, fault);
  pending.previous = std::move(previous);
}

void Transaction::commit() {
  for (const OutputFile* const file : direct_) {
    const std::error_code fault = write_into(file->path, file->content);
    if (fault) fail(file->path, fault);
  }
  for (Pending& pending : pending_) {
    if (pending_.size() > 1) keep_previous(pending);
    const std::error_code fault = replace_file(pending.partial, pending.place);
    if (fault) fail(pending.path, fault);
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
      replace_file(pending.previous, pending.place);
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

void write_files(std::span<const OutputFile> files, const std::filesystem::path& folder) {
  Transaction transaction(folder);
  for (const OutputFile& file : files)
    transaction.prepare(file);
  transaction.commit();
}

}  // namespace planish
