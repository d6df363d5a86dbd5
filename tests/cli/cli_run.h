#pragma once

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <planish/io/mesh_format.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "run.h"
#include "support/own_folder.h"

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

/// Gives every test an empty folder of its own and makes it the current one.
class CliFolder : public OwnFolder {
 protected:
  void SetUp() override {
    OwnFolder::SetUp();
    before_ = std::filesystem::current_path();
    std::filesystem::current_path(folder_);
  }
  void TearDown() override {
    std::filesystem::current_path(before_);
    OwnFolder::TearDown();
  }

 private:
  std::filesystem::path before_;
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
