#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <new>
#include <span>
#include <type_traits>

namespace planish {

/// Uninitialised memory, in large pages where the system has them: with small ones, first touching
/// it takes longer than many a loop over it.
/// @throws std::bad_alloc
void* allocate_pages(std::size_t bytes, std::size_t alignment);
/// @param bytes,alignment as it was asked for by
void free_pages(void* memory, std::size_t bytes, std::size_t alignment) noexcept;

/// Gives memory that was freed back to the system: for where much of another kind comes next.
/// Elsewhere it costs time, as pages that are used again are cleared again.
void return_freed_memory() noexcept;

/// A fixed number of uninitialised elements: for large arrays that several threads fill, where
/// clearing by one thread would take as long as the work of all.
template <class T>
class Buffer {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  Buffer() = default;
  explicit Buffer(std::size_t size) : elements_(allocate(size), Free{size}), size_(size) {}

  std::size_t size() const { return size_; }
  T* data() { return elements_.get(); }
  const T* data() const { return elements_.get(); }
  T& operator[](std::size_t i) { return elements_[i]; }
  const T& operator[](std::size_t i) const { return elements_[i]; }
  T* begin() { return data(); }
  T* end() { return data() + size_; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }

 private:
  struct Free {
    std::size_t size = 0;
    void operator()(T* elements) const noexcept {
      free_pages(elements, size * sizeof(T), alignof(T));
    }
  };

  static T* allocate(std::size_t size) {
    if (size > std::numeric_limits<std::size_t>::max() / sizeof(T))
      throw std::bad_array_new_length();
    return static_cast<T*>(allocate_pages(size * sizeof(T), alignof(T)));
  }

  std::unique_ptr<T[], Free> elements_;
  std::size_t size_ = 0;
};

}  // namespace planish
