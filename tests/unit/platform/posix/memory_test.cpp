#include "platform/memory.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <new>
#include <string>

#include <gtest/gtest.h>

namespace planish {
namespace {

/// What the system says of the mapping that holds an address: "rd wr mr mw me ac sd hg".
std::string flags_at(const void* memory) {
  const auto address = reinterpret_cast<std::uintptr_t>(memory);
  std::ifstream smaps("/proc/self/smaps");
  bool inside = false;
  for (std::string line; std::getline(smaps, line);) {
    const std::size_t dash = line.find('-');
    if (dash != std::string::npos && line.find_first_not_of("0123456789abcdef") == dash) {
      const std::uintptr_t begin = std::stoull(line, nullptr, 16);
      inside = address >= begin && address < std::stoull(line.substr(dash + 1), nullptr, 16);
    }
    if (inside && line.starts_with("VmFlags:")) return line.substr(8) + " ";
  }
  return {};
}

TEST(PosixLargePages, AreAskedForExactlyWhereTheKernelHasThem) {
  const bool has_them = std::filesystem::exists("/sys/kernel/mm/transparent_hugepage/enabled");
  constexpr std::align_val_t aligned{k_large_page};
  constexpr std::size_t bytes = 4 * k_large_page;
  const auto free = [&](char* memory) { ::operator delete(memory, aligned); };
  const std::unique_ptr<char, decltype(free)> memory(
      static_cast<char*>(::operator new(bytes, aligned)), free);
  prefer_large_pages(memory.get(), bytes);
  const std::string flags = flags_at(memory.get());
  ASSERT_NE(flags.find(" rd wr "), std::string::npos) << flags;
  EXPECT_EQ(flags.find(" hg ") != std::string::npos, has_them) << flags;
}

}  // namespace
}  // namespace planish
