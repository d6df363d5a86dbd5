#include "core/buffer.h"

#include <algorithm>

#include "platform/memory.h"

namespace planish {

namespace {

bool is_large(std::size_t bytes) {
  return bytes >= 2 * k_large_page;
}

std::align_val_t alignment_of(std::size_t bytes, std::size_t alignment) {
  return std::align_val_t{is_large(bytes) ? std::max(alignment, k_large_page) : alignment};
}

}  // namespace

void* allocate_pages(std::size_t bytes, std::size_t alignment) {
  void* memory = ::operator new(bytes, alignment_of(bytes, alignment));
  if (is_large(bytes)) prefer_large_pages(memory, bytes);
  return memory;
}

void free_pages(void* memory, std::size_t bytes, std::size_t alignment) noexcept {
  ::operator delete(memory, alignment_of(bytes, alignment));
}

void return_freed_memory() noexcept {
  trim_heap();
}

}  // namespace planish
