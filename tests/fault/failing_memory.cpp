#include "fault/failing_memory.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <new>

#include <execinfo.h>

namespace {

std::atomic<bool> counting = false;
std::atomic<std::size_t> counted = 0;
std::atomic<std::size_t> failing = 0;
std::atomic<bool> for_good = false;

std::span<std::size_t> places;
std::size_t noted = 0;
std::array<std::uint64_t, std::size_t{1} << 16> known = {};  // hash table, 0 for free
std::mutex noting;

constexpr int k_own_frames = 3, k_callers = 4;

std::uint64_t hash_of_callers() {
  std::array<void*, k_own_frames + k_callers> frames = {};
  const int count = backtrace(frames.data(), static_cast<int>(frames.size()));
  std::uint64_t hash = 1469598103934665603U;
  for (int i = std::min(k_own_frames, count); i < count; ++i)
    hash = (hash ^ reinterpret_cast<std::uintptr_t>(frames[static_cast<std::size_t>(i)])) *
           1099511628211U;
  return hash | 1;
}

void note_place(std::size_t n) {
  const std::uint64_t hash = hash_of_callers();
  const std::lock_guard lock(noting);
  std::size_t at = (hash >> 40) % known.size();
  while (known[at] != 0 && known[at] != hash)
    at = (at + 1) % known.size();
  if (known[at] == hash || noted == places.size()) return;
  known[at] = hash;
  places[noted++] = n;
}

[[gnu::noinline]] bool fails() {
  if (!counting.load(std::memory_order_relaxed)) return false;
  const std::size_t n = ++counted;
  if (!places.empty()) note_place(n);
  return n == failing || (for_good && failing != 0 && n > failing);
}

}  // namespace

namespace planish::fault {

void let_memory_end(std::size_t n, Ending ending) {
  counted = 0;
  failing = n;
  for_good = ending == Ending::for_good;
  counting = true;
}

void note_places(std::span<std::size_t> numbers) {
  std::array<void*, 1> frame = {};
  backtrace(frame.data(), 1);  // allocates the first time
  places = numbers;
  noted = 0;
  known = {};
  let_memory_end(0);
}

std::size_t places_noted() {
  return noted;
}

std::size_t let_memory_last() {
  counting = false;
  return counted;
}

}  // namespace planish::fault

// The linker's --wrap makes malloc() a call of __wrap_malloc(), and __real_malloc() the one of the
// C library.
extern "C" {

void* __real_malloc(std::size_t size);
void* __real_calloc(std::size_t count, std::size_t size);
void* __real_realloc(void* old, std::size_t size);
void* __real_aligned_alloc(std::size_t alignment, std::size_t size);
int __real_posix_memalign(void** memory, std::size_t alignment, std::size_t size);

void* __wrap_malloc(std::size_t size) {
  return fails() ? nullptr : __real_malloc(size);
}

void* __wrap_calloc(std::size_t count, std::size_t size) {
  return fails() ? nullptr : __real_calloc(count, size);
}

void* __wrap_realloc(void* old, std::size_t size) {
  return fails() ? nullptr : __real_realloc(old, size);
}

void* __wrap_aligned_alloc(std::size_t alignment, std::size_t size) {
  return fails() ? nullptr : __real_aligned_alloc(alignment, size);
}

int __wrap_posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  return fails() ? ENOMEM : __real_posix_memalign(memory, alignment, size);
}

}  // extern "C"

namespace {

void* allocated(std::size_t size) {
  return fails() ? nullptr : __real_malloc(size > 0 ? size : 1);
}

void* allocated(std::size_t size, std::align_val_t alignment) {
  const auto bytes = static_cast<std::size_t>(alignment);
  return fails() ? nullptr : __real_aligned_alloc(bytes, (size + bytes - 1) / bytes * bytes);
}

void* or_throw(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

// clang-format off
void* operator new(std::size_t n) { return or_throw(allocated(n)); }
void* operator new[](std::size_t n) { return or_throw(allocated(n)); }
void* operator new(std::size_t n, const std::nothrow_t&) noexcept { return allocated(n); }
void* operator new[](std::size_t n, const std::nothrow_t&) noexcept { return allocated(n); }
void* operator new(std::size_t n, std::align_val_t a) { return or_throw(allocated(n, a)); }
void* operator new[](std::size_t n, std::align_val_t a) { return or_throw(allocated(n, a)); }
void* operator new(std::size_t n, std::align_val_t a, const std::nothrow_t&) noexcept { return allocated(n, a); }
void* operator new[](std::size_t n, std::align_val_t a, const std::nothrow_t&) noexcept { return allocated(n, a); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, const std::nothrow_t&) noexcept { std::free(p); }
void operator delete[](void* p, const std::nothrow_t&) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete[](void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t, const std::nothrow_t&) noexcept { std::free(p); }
void operator delete[](void* p, std::align_val_t, const std::nothrow_t&) noexcept { std::free(p); }
// clang-format on
