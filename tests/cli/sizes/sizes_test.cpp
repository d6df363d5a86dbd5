// Sizes that a later step would refuse are refused before the first sweep.

#include <set>
#include <utility>

#include <planish/flatten/flatten.h>

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "support/meshes.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

/// On a terminal, which shows the stages of the work.
CliResult flatten_on_terminal(const Names& more) {
  Names args = {"flatten", "panel.obj", "-o", "out"};
  args.insert(args.end(), more.begin(), more.end());
  return planish(args, {.err_is_terminal = true});
}

class RefusedSizes : public CliTest {};

TEST_F(RefusedSizes, DoNotBeginToEvolve) {
  const std::vector<std::pair<Names, std::string>> cases = {
      {{"--paper", "a4", "--unit", "m"}, "more than 10,000 pages"},
      {{"--sheet", "10mm"}, "fits on no place of a roll of width 10 mm"},
      {{"--sheet", "10mmx10mm", "--turn", "free"}, "fits on no place of sheets of 10 x 10 mm"},
      {{"--sheet", "10mm", "--grain", "0,0,1"}, "fits on no place"},
      {{"--sheet", "9000mm", "--quantity", "10001"}, "more than 10000 pieces"}};
  for (const auto& [flags, message] : cases) {
    const CliResult result = flatten_on_terminal(flags);
    EXPECT_EQ(result.exit_code, k_exit_failed);
    EXPECT_THAT(result.err, HasSubstr(message));
    EXPECT_THAT(result.err, Not(HasSubstr("evolving")));
    EXPECT_THAT(result.err, HasSubstr("panel.obj"));
  }
  EXPECT_FALSE(std::filesystem::exists("out"));
}

TEST_F(RefusedSizes, OfCopiesOfSeveralPatches) {
  std::filesystem::create_directory("coat");
  write_mesh("coat/front.obj", make_shape("dome", 100));
  write_mesh("coat/back.obj", make_shape("saddle", 100));
  const CliResult result =
      planish({"flatten", "coat", "-o", "out", "--sheet", "9000mm", "--quantity", "5001"});
  EXPECT_EQ(result.exit_code, k_exit_failed);
  EXPECT_THAT(result.err, HasSubstr("more than 10000 pieces"));
  EXPECT_FALSE(std::filesystem::exists("out"));
}

TEST_F(RefusedSizes, AreNoneThatMayStillFit) {
  const CliResult result = flatten_on_terminal(
      {"--sheet", "2000mm", "--paper", "a4", "--method", "controllable", "--sweeps", "1"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
}

/// The stages of flatten() on a patch, and the code of the error it ends with.
std::pair<std::set<std::string>, ErrorCode> stages_until_error(const Patch& patch,
                                                               const FlattenOptions& options) {
  std::set<std::string> stages;
  try {
    flatten(patch, "patch", options, {.on_progress = [&](const Progress& progress) {
              stages.insert(std::string(progress.stage));
            }});
  } catch (const Error& error) {
    return {stages, error.code()};
  }
  ADD_FAILURE() << "not refused";
  return {stages, {}};
}

TEST(RefusedPatches, AreNotWorkedOn) {
  TriMesh many = meshes::flat_grid(4, 4);
  many.positions.resize(2'000'001);  // in no triangle, but numbered
  const auto only = std::set<std::string>{"measuring"};
  EXPECT_EQ(stages_until_error(Patch(many), {.method = ControllableLaplacian{}}),
            (std::pair{only, ErrorCode::too_large}));
  // A pattern could be made of this one, and would be first.
  EXPECT_EQ(stages_until_error(Patch(meshes::fan(4001, 0.5)), {.method = Auto{}}),
            (std::pair{only, ErrorCode::too_large}));
}

}  // namespace
}  // namespace planish::cli
