#include "core/buffer.h"

#include <algorithm>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace planish {

namespace {

constexpr std::size_t k_large_page = std::size_t{1} << 21;

bool is_large(std::size_t bytes) {
  return bytes >= 2 * k_large_page;
}

std::align_val_t alignment_of(std::size_t bytes, std::size_t alignment) {
  return std::align_val_t{is_large(bytes) ? std::max(alignment, k_large_page) : alignment};
}

}  // namespace

void* allocate_pages(std::size_t bytes, std::size_t alignment) {
  void* memory = ::operator new(bytes, alignment_of(bytes, alignment));
#ifdef __linux__
  // Whole pages within: who refuses costs time alone.
  if (is_large(bytes)) madvise(memory, bytes / k_large_page * k_large_page, MADV_HUGEPAGE);
#endif
  return memory;
}

void free_pages(void* memory, std::size_t bytes, std::size_t alignment) noexcept {
  ::operator delete(memory, alignment_of(bytes, alignment));
}

}  // namespace planish
