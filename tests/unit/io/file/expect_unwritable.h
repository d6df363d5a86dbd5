#pragma once

#include <filesystem>
#include <vector>

#include <planish/io/write_file.h>

#include "platform/path.h"
#include "unit/io/io_testing.h"

namespace planish {

/// Writes and checks that it is refused with the path of the file at fault.
inline void expect_unwritable(const std::vector<OutputFile>& files,
                              const std::filesystem::path& at_fault) {
  const Error error = error_of([&] { write_files(files); });
  EXPECT_EQ(error.code(), ErrorCode::file_unwritable) << error.what();
  EXPECT_EQ(error.place().path, utf8_of(at_fault));
  EXPECT_TRUE(error.message().starts_with("cannot be written: ")) << error.what();
}

}  // namespace planish
