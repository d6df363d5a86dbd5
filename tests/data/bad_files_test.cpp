// What is promised of files that are wrong or odd, on a collection of them beside the patches with
// a table of verdicts. The kinds of fault themselves are tested in tests/bad/bad_meshes_test.cpp.

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "cli/verb_runs.h"
#include "support/test_patches.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;

struct BadFile {
  std::string name, expected;  ///< "accept", "refuse" or "either"
};

/// The lines of the table; none where there is no folder of data.
std::vector<BadFile> table() {
  std::vector<BadFile> files;
  const auto paths = bad_files();
  if (paths.empty()) return files;
  std::ifstream table(paths.front().parent_path() / "expect.tsv");
  std::string line;
  std::getline(table, line);  // the heads of the columns
  while (std::getline(table, line)) {
    std::istringstream cells(line);
    BadFile file;
    std::getline(std::getline(cells, file.name, '\t'), file.expected, '\t');
    files.push_back(file);
  }
  return files;
}

/// Files that hold the patch of ply_ascii.ply, with how exactly.
const std::map<std::string, double>& same_patch() {
  constexpr double exact = 1e-11, floats = 1e-6, digits = 1e-6;
  static const std::map<std::string, double> tolerance = {{"top_isolated_vertices.obj", exact},
                                                          {"top_all_flipped.obj", exact},
                                                          {"num_huge_1e30.obj", exact},
                                                          {"num_huge_1e200.obj", exact},
                                                          {"num_tiny_1e-30.obj", exact},
                                                          {"num_offset_1e8.obj", digits},
                                                          {"num_index_negative_ok.obj", exact},
                                                          {"obj_crlf.obj", exact},
                                                          {"obj_tabs_spaces.obj", exact},
                                                          {"obj_no_final_newline.obj", exact},
                                                          {"obj_materials_groups.obj", exact},
                                                          {"obj_v_slash_slash_n.obj", exact},
                                                          {"obj_vertex_colours.obj", exact},
                                                          {"obj_line_continuation.obj", exact},
                                                          {"obj_bom.obj", exact},
                                                          {"obj_latin1_names.obj", exact},
                                                          {"obj_lines_points_curves.obj", exact},
                                                          {"obj_faces_first.obj", exact},
                                                          {"long_line_comment.obj", exact},
                                                          {"ply_binary_le.ply", exact},
                                                          {"ply_binary_be.ply", floats},
                                                          {"ply_extra_properties.ply", floats},
                                                          {"ply_uint_short_lists.ply", floats},
                                                          {"stl_binary.stl", floats},
                                                          {"stl_ascii.stl", exact},
                                                          {"stl_binary_solid_header.stl", floats},
                                                          {"off_ascii.off", exact}};
  return tolerance;
}

class BadFiles : public CliFolder {
 protected:
  /// A copy in the folder of the test.
  void SetUp() override {
    CliFolder::SetUp();
    for (const auto& path : bad_files())
      std::filesystem::copy_file(path, path.filename());
  }
};

/// Where the message says the fault is: a line, a byte, or a number of a vertex or triangle; a file
/// without anything in it has no such place.
void expect_place(const VerbRun& run) {
  const nlohmann::json error = run.json.value("error", nlohmann::json::object());
  const std::string message = error.value("message", "");
  EXPECT_TRUE(error.contains("line") || error.contains("byte") || error.contains("first") ||
              error.value("code", "") == "no_triangles")
      << message;
  EXPECT_GT(message.size(), 15U);
}

TEST_F(BadFiles, EndAsTheirTableSays) {
  for (const BadFile& file : table()) {
    if (file.name.ends_with(".gz")) continue;  // no format: below
    bool all_done = true, product = false;
    for (const Verb& verb : verbs_of_one_mesh()) {
      SCOPED_TRACE(verb.args.front() + " " + file.name);
      const VerbRun run = run_verb(verb, file.name);
      // Parts that share no edge are a product, and each of them has its own verdict.
      if (run.json.contains("nesting")) {
        product = true;
        std::filesystem::remove_all(verb.output);
        continue;
      }
      expect_orderly(run, file.name);
      if (!run.done()) expect_place(run);
      all_done = all_done && run.done();
      if (!verb.output.empty()) std::filesystem::remove_all(verb.output);
    }
    if (file.expected == "accept") {
      EXPECT_TRUE(all_done || product) << file.name;
    }
    if (file.expected == "refuse") {
      EXPECT_FALSE(all_done) << file.name;
    }
  }
}

TEST_F(BadFiles, MeasureAsTheSoundOriginal) {
  if (bad_files().empty()) return;
  const Verb measure = verbs_of_one_mesh().front();
  const nlohmann::json sound = run_verb(measure, "ply_ascii.ply").json;
  for (const auto& [name, tolerance] : same_patch()) {
    SCOPED_TRACE(name);
    expect_same_figures(run_verb(measure, name).json, sound, tolerance);
  }
}

TEST_F(BadFiles, EvolveAsTheSoundOriginal) {
  if (bad_files().empty()) return;
  const Verb evolve = verbs_of_one_mesh()[2];
  ASSERT_EQ(evolve.args.front(), "evolve");
  const nlohmann::json sound = run_verb(evolve, "ply_ascii.ply").json["after"];
  for (const auto& [name, tolerance] : same_patch()) {
    // An offset, or floats, can turn a decision on a single vertex.
    if (tolerance > 1e-11) continue;
    SCOPED_TRACE(name);
    std::filesystem::remove("out.obj");
    expect_same_figures(run_verb(evolve, name).json["after"], sound, 1e-6);
  }
}

TEST_F(BadFiles, OfNoFormatAreRefusedByTheirExtension) {
  if (bad_files().empty()) return;
  const CliResult result = planish({"measure", "compressed.obj.gz", "--json"});
  EXPECT_EQ(result.exit_code, k_exit_failed);
  EXPECT_EQ(result.json()["error"]["code"], "unsupported_format");
  EXPECT_THAT(result.err, HasSubstr(".gz"));
}

}  // namespace
}  // namespace planish::cli
