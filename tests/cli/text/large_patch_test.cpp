#include "text/large_patch.h"

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "support/meshes.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;

TEST(MemoryText, SaysNothingOfSmallPatchesAndOtherMethods) {
  EXPECT_EQ(memory_text(Auto{}, 99'999, 1), "");
  EXPECT_EQ(memory_text(ControllableLaplacian{}, 5'000'000, 1), "");
}

TEST(MemoryText, OffersRemeshWhereMemoryWouldNotDo) {
  EXPECT_EQ(memory_text(Auto{}, 1'000'000, 16'000'000'000),
            "1000000 vertices take about 7.5 GB of memory");
  EXPECT_EQ(memory_text(Auto{}, 1'000'000, 0), "1000000 vertices take about 7.5 GB of memory");
  EXPECT_EQ(memory_text(Auto{}, 1'000'000, 7'000'000'000),
            "1000000 vertices take about 7.5 GB of memory, and 7.0 GB are free: --remesh works on "
            "fewer vertices, keeps the border and takes about 0.50 GB");
}

TEST(RemeshOffer, IsMadeForLongRunsWithBothTimes) {
  const auto offer = remesh_offer(10.0, 0.05, 60000, 5000);
  ASSERT_TRUE(offer);
  EXPECT_THAT(*offer, HasSubstr("will take about 3 min; with --remesh"));
  EXPECT_THAT(*offer, HasSubstr("5000 of the 60000 vertices, about 9 s"));
  EXPECT_THAT(*remesh_offer(10.0, 0.125, 60000, 6000), HasSubstr("will take about 80 s;"));
}

TEST(RemeshOffer, IsNotMadeWhereARunIsShortOrItIsTooEarlyToTell) {
  EXPECT_FALSE(remesh_offer(10.0, 0.2, 60000, 5000)) << "50 s in all";
  EXPECT_FALSE(remesh_offer(2.0, 0.02, 60000, 5000)) << "after 2 s";
  EXPECT_FALSE(remesh_offer(10.0, 0.005, 60000, 5000)) << "of half a per cent";
}

TEST(RemeshOffer, IsNotMadeWhereItWouldGainLittle) {
  EXPECT_FALSE(remesh_offer(10.0, 0.02, 10000, 5000));
  EXPECT_FALSE(remesh_offer(10.0, 0.02, 5000, 5000));
}

TEST_F(CliTest, ARunThatOffersToRemeshPassesItsProgressOn) {
  RunContext run;
  std::vector<double> shares;
  run.on_progress = [&](const Progress& progress) { shares.push_back(progress.share); };
  std::ostringstream err;
  Session session({}, err, run);
  const Patch patch(meshes::flat_grid(5, 5));
  const Context context = offering_remesh(session.job_context(""), patch, session);
  context.on_progress({"evolving", 0.25});
  context.on_progress({"evolving", 0.5});
  EXPECT_THAT(shares, testing::ElementsAre(0.25, 0.5));
  EXPECT_EQ(err.str(), "") << "of a run that is short";
}

}  // namespace
}  // namespace planish::cli
