#pragma once

#include <cstddef>

namespace planish {

/// Bytes of a large page. Where the system's are of another size, or where it has none, memory that
/// is aligned to this loses nothing.
inline constexpr std::size_t k_large_page = std::size_t{1} << 21;

/// Asks the system to hand this memory out in large pages when it is first touched. It is advice:
/// a refusal costs time alone. Windows gives large pages to privileged users only, so nothing is
/// done there.
/// @param memory aligned to k_large_page
/// @param bytes only whole large pages of them count
void prefer_large_pages(void* memory, std::size_t bytes) noexcept;

/// Gives memory that was freed back to the system, where the C library would keep it. On Windows
/// nothing is done.
void trim_heap() noexcept;

/// An estimate of the bytes that this process can still allocate without swapping; 0 if the system
/// gives none. On Windows use GlobalMemoryStatusEx().
std::size_t available_memory();

}  // namespace planish
