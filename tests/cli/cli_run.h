#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <planish/io/write_mesh.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "run.h"

namespace planish::cli {

/// What one run of the program did.
struct CliResult {
  int exit_code = 0;
  std::string out, err;

  /// The one JSON object on standard output; anything else there fails the test.
  nlohmann::json json() const {
    nlohmann::json object = nlohmann::json::parse(out, nullptr, false);
    EXPECT_TRUE(object.is_object()) << "not one JSON object: " << out;
    return object;
  }
};

inline CliResult planish(const std::vector<std::string>& args, const RunContext& context = {}) {
  std::ostringstream out, err;
  const int exit_code = run(args, out, err, context);
  return {exit_code, out.str(), err.str()};
}

inline std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Gives every test an empty folder of its own, and of the process, made the current one.
class CliFolder : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    std::string name =
        std::to_string(getpid()) + "." + std::string(info->test_suite_name()) + "." + info->name();
    for (char& c : name) {
      if (c == '/') c = '_';
    }
    before_ = std::filesystem::current_path();
    folder_ = std::filesystem::path(testing::TempDir()) / ("planish_cli_" + name);
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    std::filesystem::current_path(folder_);
  }
  void TearDown() override {
    std::filesystem::current_path(before_);
    std::filesystem::remove_all(folder_);
  }

  /// Names of all that lies in the test's folder, sorted.
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) {
      names.push_back(std::filesystem::relative(entry.path(), folder_).string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

 private:
  std::filesystem::path before_, folder_;
};

/// And a small patch in it.
class CliTest : public CliFolder {
 protected:
  void SetUp() override {
    CliFolder::SetUp();
    write_mesh("panel.obj", make_shape("panel", 300));
  }
};

using Names = std::vector<std::string>;

}  // namespace planish::cli
