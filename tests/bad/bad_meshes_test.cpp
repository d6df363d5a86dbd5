// What is promised of files that are wrong or odd: of each kind that the generator knows.

#include <filesystem>
#include <fstream>
#include <set>

#include "cli/verb_runs.h"
#include "support/bad/bad_mesh.h"
#include "support/bad/sound_files.h"

namespace planish::cli {
namespace {

using bad::BadMesh;
using bad::Verdict;
using testing::HasSubstr;

const bad::BadMeshes& all_bad_meshes() {
  static const bad::BadMeshes meshes = bad::bad_meshes();
  return meshes;
}

class BadMeshFiles : public CliFolder, public testing::WithParamInterface<std::size_t> {
 protected:
  void SetUp() override {
    CliFolder::SetUp();
    std::ofstream(input(), std::ios::binary) << mesh().bytes;
  }
  const BadMesh& mesh() const { return all_bad_meshes()[GetParam()]; }
  std::string input() const { return "in" + mesh().extension; }

  bool tells_more(const Verb& verb) const;
  void expect_refused(const VerbRun& run) const;
  void expect_processed(const VerbRun& run) const;
};

INSTANTIATE_TEST_SUITE_P(Generated, BadMeshFiles,
                         testing::Range(std::size_t{0}, all_bad_meshes().size()),
                         [](const auto& test) { return all_bad_meshes()[test.param].name; });

/// What cannot be read is so to every verb, and what is read as the sound patch is that.
bool BadMeshFiles::tells_more(const Verb& verb) const {
  const std::string& name = verb.args.front();
  if (mesh().unreadable) return name == "measure" || name == "evolve";
  return mesh().verdict != Verdict::same || name != "flatten";
}

void BadMeshFiles::expect_refused(const VerbRun& run) const {
  ASSERT_EQ(run.result.exit_code, k_exit_failed) << run.result.out;
  const nlohmann::json error = run.json.value("error", nlohmann::json::object());
  const std::string message = error.value("message", "");
  if (mesh().code) {
    EXPECT_EQ(error.value("code", ""), to_string(*mesh().code)) << message;
  }
  if (mesh().line) {
    EXPECT_EQ(error.value("line", 0U), *mesh().line) << message;
    EXPECT_THAT(run.result.err, HasSubstr(input() + ":" + std::to_string(*mesh().line) + ": "));
  }
  if (mesh().byte) {
    EXPECT_EQ(error.value("byte", 0U), *mesh().byte) << message;
    EXPECT_THAT(run.result.err, HasSubstr("at byte " + std::to_string(*mesh().byte) + ": "));
  }
  if (mesh().first) {
    EXPECT_EQ(error.value("first", ~0U), *mesh().first) << message;
    EXPECT_THAT(message, HasSubstr(" " + std::to_string(*mesh().first)));
  }
  EXPECT_THAT(message, HasSubstr(mesh().part));
}

void BadMeshFiles::expect_processed(const VerbRun& run) const {
  ASSERT_TRUE(run.done()) << run.result.err;
  if (run.verb.args.front() != "measure") return;
  if (mesh().code) {
    EXPECT_THAT(run.json["problems"].dump(), HasSubstr(std::string(to_string(*mesh().code))));
  }
  if (mesh().verdict != Verdict::same) return;
  write_mesh("sound.ply", bad::sound());
  const nlohmann::json sound = planish({"measure", "sound.ply", "--json"}).json();
  expect_same_figures(run.json, sound, 1e-9);
  EXPECT_THAT(run.result.err, HasSubstr(mesh().part));
}

/// The verb with --strict: what a file is, not what is made of it.
Verb strictly(Verb verb) {
  verb.args.emplace_back("--strict");
  return verb;
}

/// Whether a verb divides what cannot be laid flat as it is.
bool is_divided(const Verb& verb, const BadMesh& mesh) {
  const auto code = mesh.code;
  return verb.args.front() == "flatten" &&
         (code == ErrorCode::closed_surface || code == ErrorCode::handles ||
          code == ErrorCode::several_border_loops);
}

/// Whether a verb that takes one piece says that the file holds several, as by its groups.
bool names_pieces(const VerbRun& run) {
  return run.result.exit_code == k_exit_failed && run.json.contains("error") &&
         run.json["error"].value("code", "") == "several_components";
}

TEST_P(BadMeshFiles, AreReadOrRefusedAsPromised) {
  for (const Verb& verb : verbs_of_one_mesh()) {
    if (!tells_more(verb)) continue;
    SCOPED_TRACE(verb.args.front());
    const VerbRun run = run_verb(strictly(verb), input());
    // Pieces of a file are a product, and each of them has its own verdict.
    if (run.json.contains("nesting") && mesh().code != ErrorCode::no_inner_vertex) continue;
    if (mesh().verdict == Verdict::same && names_pieces(run)) continue;
    expect_orderly(run, input());
    if (mesh().verdict == Verdict::either) continue;
    const bool refused = mesh().verdict == Verdict::refuse && !is_divided(verb, mesh()) &&
                         (mesh().unreadable || is_blocked(verb, mesh().blocks));
    if (refused) {
      expect_refused(run);
    } else {
      expect_processed(run);
    }
  }
}

/// Kinds that are mended: a whole output comes of them, or an error.
TEST_P(BadMeshFiles, EndInAnOrderlyWayWhereTheyAreMended) {
  const bool is_sound = mesh().verdict == Verdict::same || mesh().verdict == Verdict::accept;
  if (is_sound || mesh().unreadable) return;
  for (const Verb& verb : verbs_of_one_mesh()) {
    SCOPED_TRACE(verb.args.front());
    const VerbRun run = run_verb(verb, input());
    if (run.json.contains("nesting")) continue;  // a product
    expect_orderly(run, input());
  }
}

TEST(BadMeshes, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const BadMesh& mesh : all_bad_meshes())
    EXPECT_TRUE(names.insert(mesh.name).second) << mesh.name;
}

}  // namespace
}  // namespace planish::cli
