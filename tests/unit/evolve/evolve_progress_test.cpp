#include "evolve/evolve_progress.h"

#include <gtest/gtest.h>

namespace planish {
namespace {

SweepRecord sweep(int number) {
  SweepRecord record;
  record.sweep = number;
  return record;
}

SweepRecord sweep_on_level(int number, std::size_t inner_vertices) {
  SweepRecord record = sweep(number);
  record.level = LevelRecord{inner_vertices, 0.0, 0.0, 0.0};
  return record;
}

TEST(EvolveProgress, IsTheShareOfSweepsWhereThereAreNoLevels) {
  EvolveProgress progress({.max_sweeps = 4}, 1000);
  for (int i = 1; i <= 4; ++i)
    EXPECT_EQ(progress.after(sweep(i)), 0.25 * i);
}

TEST(EvolveProgress, GoesByTheVerticesOfLevels) {
  EvolveProgress progress({.max_sweeps = 400}, 1000);
  double share = 0.0;
  for (int i = 1; i <= 20; ++i)
    share = progress.after(sweep_on_level(i, 100));
  EXPECT_GT(share, 0.08);
  EXPECT_LE(share, 0.1);
  share = progress.after(sweep_on_level(21, 900));
  EXPECT_GE(share, 0.1) << "the coarse level is done";
  for (int i = 22; i <= 60; ++i)
    share = progress.after(sweep_on_level(i, 900));
  EXPECT_GT(share, 0.85);
  EXPECT_LE(share, 0.9);
  EXPECT_GT(progress.after(sweep(61)), 0.9) << "the last digits";
}

TEST(EvolveProgress, MovesWhileALevelIsOpened) {
  EvolveProgress progress({.max_sweeps = 400}, 1000);
  const double begun = progress.while_opening(0.0);
  EXPECT_GT(progress.while_opening(1.0), begun);
  for (int i = 1; i <= 5; ++i)
    progress.after(sweep_on_level(i, 250));
  double share = progress.while_opening(0.0);
  EXPECT_EQ(share, 0.25) << "the level before is done";
  for (const double opened : {0.2, 0.5, 1.0}) {
    const double next = progress.while_opening(opened);
    EXPECT_GT(next, share);
    share = next;
  }
  EXPECT_LT(share, 0.6) << "the steps are to come";
  EXPECT_GT(progress.after(sweep_on_level(6, 1000)), share);
}

TEST(EvolveProgress, NeverGoesBackAndNeverPastTheEnd) {
  EvolveProgress progress({.max_sweeps = 30}, 1000);
  double before = 0.0;
  for (int i = 1; i <= 40; ++i) {
    if (i % 7 == 0) {
      const double opening = progress.while_opening(0.1 * (i % 11));
      EXPECT_GE(opening, before) << i;
      before = opening;
    }
    // A level that has more vertices than the patch, and finer ones before coarser, as none should.
    const double share = progress.after(i % 3 == 0 ? sweep(i) : sweep_on_level(i, 1200 - 37 * i));
    EXPECT_GE(share, before) << i;
    EXPECT_LE(share, 1.0) << i;
    before = share;
  }
}

}  // namespace
}  // namespace planish
