#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include <planish/flatten/flatten.h>
#include <planish/measure/fairness.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "support/bent_sheets.h"
#include "support/meshes.h"

namespace planish {
namespace {

using std::numbers::pi;

FormChange change_of(const TriMesh& design, const TriMesh& after) {
  return *measure_fairness(Patch(design), after.positions).form_change;
}

/// Over [0, 1] x [0, 0.7]: height(x, y).
template <class Height>
TriMesh sheet(std::size_t cells, const Height& height) {
  TriMesh mesh = meshes::flat_grid(cells, cells * 7 / 10);
  for (Vec3& p : mesh.positions) {
    p.x /= static_cast<double>(cells);
    p.y /= static_cast<double>(cells);
    p.z = height(p.x, p.y);
  }
  return mesh;
}

double panel(double x, double y) {
  return 0.2 * std::sin(pi * x) * (1.0 - 0.3 * y) + 0.08 * std::sin(2.0 * pi * y);
}

double dent(double x, double y, double radius) {
  const double dx = (x - 0.5) / radius, dy = (y - 0.35) / radius;
  return std::exp(-dx * dx - dy * dy);
}

TEST(FormChange, OfTheDesignItselfIsNothing) {
  const FormChange same = change_of(sheet(40, panel), sheet(40, panel));
  EXPECT_EQ(same.ripple, 0.0);
  EXPECT_EQ(same.fold, 0.0);
  EXPECT_EQ(same.dent, 0.0);
  EXPECT_EQ(same.uneven_turn, 0.0);
  EXPECT_EQ(same.relief_lost, 0.0);
  EXPECT_EQ(same.edge_lost, 0.0);
}

TEST(FormChange, FindsASmallDentAtAnyDensityAndItsPlace) {
  for (const std::size_t cells : {40U, 80U, 160U}) {
    const TriMesh after =
        sheet(cells, [](double x, double y) { return panel(x, y) - 0.01 * dent(x, y, 0.03); });
    const FormChange found = change_of(sheet(cells, panel), after);
    EXPECT_TRUE(found.is_folded()) << cells;
    EXPECT_NEAR(found.fold_at.x, 0.5, 0.05) << cells;
    EXPECT_NEAR(found.fold_at.y, 0.35, 0.05) << cells;
    EXPECT_FALSE(found.is_dented()) << "nor wide: " << cells;
  }
}

TEST(FormChange, FindsAWideBulgeAtAnyDensity) {
  for (const std::size_t cells : {20U, 40U, 80U, 160U}) {
    const auto bulged = [&](double height) {
      return change_of(sheet(cells, panel), sheet(cells, [&](double x, double y) {
                         return panel(x, y) + height * dent(x, y, 0.15);
                       }));
    };
    EXPECT_TRUE(bulged(0.08).is_dented()) << cells;
    EXPECT_NEAR(bulged(0.08).dent_at.x, 0.5, 0.1) << cells;
    EXPECT_FALSE(bulged(0.01).is_dented()) << cells;
    EXPECT_FALSE(bulged(0.01).is_rippled()) << cells;
    EXPECT_FALSE(bulged(0.01).is_folded()) << cells;
  }
}

TEST(FormChange, TakesAPartThatTiltsForNoDent) {
  // A brim that turns as a whole about a line across the sheet.
  const auto turned = [](double slope) {
    return [slope](double x, double y) { return panel(x, y) + slope * std::max(0.0, x - 0.5); };
  };
  for (const std::size_t cells : {40U, 80U}) {
    const TriMesh design = sheet(cells, panel);
    const auto tilted =
        sheet(cells, [](double x, double y) { return panel(x, y) + 0.1 * (x - 0.5); });
    EXPECT_LT(change_of(design, tilted).dent, 0.2 * k_seen_dent) << cells;
    EXPECT_GT(change_of(design, sheet(cells, turned(0.5))).dent, k_seen_dent) << "bent: " << cells;
  }
}

TEST(FormChange, FindsSmallFeaturesThatWereBlurredOrAreNew) {
  // Beads across a bent sheet, 3 % of it wide.
  const auto beads = [](double height) {
    return [height](double x, double y) {
      double z = 0.1 * x * x;
      for (const double middle : {0.25, 0.5, 0.75}) {
        const double off = (x - middle) / 0.03;
        z += height * std::exp(-off * off) * (1.0 - y);
      }
      return z;
    };
  };
  for (const std::size_t cells : {60U, 120U}) {
    const auto uneven = [&](double before, double after) {
      return change_of(sheet(cells, beads(before)), sheet(cells, beads(after))).is_uneven();
    };
    EXPECT_TRUE(uneven(0.02, 0.002)) << cells;
    EXPECT_TRUE(uneven(0.0, 0.02)) << cells;
    EXPECT_FALSE(uneven(0.02, 0.018)) << "a little lower: " << cells;
    EXPECT_FALSE(uneven(0.0, 0.001)) << cells;
  }
}

TEST(FormChange, TakesAnEvenChangeOfTheWholeForNoUnevenTurn) {
  for (const std::size_t cells : {40U, 80U}) {
    const auto rolled =
        sheet(cells, [](double x, double y) { return panel(x, y) + 0.15 * x * x + 0.1 * x * y; });
    EXPECT_LT(change_of(sheet(cells, panel), rolled).uneven_turn, 0.3 * k_seen_uneven_turn)
        << cells;
  }
}

TEST(FormChange, RipplesAlongTheBorderCountLess) {
  // The same waves in the middle and along a side, in a strip that is as wide.
  const auto waves = [](double middle) {
    return [middle](double x, double y) {
      const double off = (y - middle) / 0.012;
      return panel(x, y) + 0.0006 * std::sin(60.0 * x) * std::exp(-off * off);
    };
  };
  const TriMesh design = sheet(160, panel);
  const double inside = change_of(design, sheet(160, waves(0.35))).ripple;
  const double along = change_of(design, sheet(160, waves(0.015))).ripple;
  EXPECT_GT(inside, 0.1);
  EXPECT_LT(along, 0.85 * inside);
}

TEST(FormChange, FindsRipplesAtAnyDensity) {
  for (const std::size_t cells : {60U, 120U}) {
    const auto rippled = [&](double height) {
      return change_of(sheet(cells, panel), sheet(cells, [&](double x, double y) {
                         return panel(x, y) + height * std::sin(60.0 * x);
                       }));
    };
    EXPECT_TRUE(rippled(0.004).is_rippled()) << cells;
    EXPECT_FALSE(rippled(0.0005).is_rippled()) << cells;
    EXPECT_FALSE(rippled(0.0005).is_folded()) << cells;
  }
}

TEST(FormChange, FindsAnEdgeThatWasRoundedOff) {
  const auto chine = [](double width) {
    return [width](double x, double y) {
      return 0.3 - 0.45 * std::sqrt((y - 0.35) * (y - 0.35) + width * width) -
             0.1 * (x - 0.5) * (x - 0.5);
    };
  };
  for (const std::size_t cells : {60U, 100U, 200U}) {
    const TriMesh design = sheet(cells, chine(0.0));
    EXPECT_TRUE(change_of(design, sheet(cells, chine(0.04))).has_lost_edge()) << cells;
    EXPECT_FALSE(change_of(design, sheet(cells, chine(0.005))).has_lost_edge()) << cells;
    EXPECT_EQ(change_of(sheet(cells, panel), sheet(cells, panel)).edge_lost, 0.0) << "has none";
  }
}

TEST(FormChange, FindsAnEdgeThatWasRoundedOffOnAPartOfItsLength) {
  const auto chine = [](double until) {
    return [until](double x, double y) {
      const double width = x < until ? 0.04 : 0.0;
      return 0.3 - 0.45 * std::sqrt((y - 0.35) * (y - 0.35) + width * width);
    };
  };
  for (const std::size_t cells : {60U, 100U, 200U}) {
    const TriMesh design = sheet(cells, chine(0.0));
    EXPECT_TRUE(change_of(design, sheet(cells, chine(0.45))).has_lost_edge()) << cells;
    EXPECT_FALSE(change_of(design, sheet(cells, chine(0.15))).has_lost_edge()) << cells;
  }
}

TEST(FormChange, FindsWavesBesideASharpBead) {
  const auto bead = [](double wave) {
    return [wave](double x, double y) {
      const double across = (y - 0.35) / 0.02;
      return 0.1 * x * x + 0.05 * std::exp(-across * across) +
             (y > 0.5 ? wave * std::sin(60.0 * x) * std::sin(5.0 * pi * (y - 0.5)) : 0.0);
    };
  };
  for (const std::size_t cells : {80U, 160U}) {
    const TriMesh design = sheet(cells, bead(0.0));
    EXPECT_TRUE(change_of(design, sheet(cells, bead(0.002))).is_rippled()) << cells;
    EXPECT_FALSE(change_of(design, sheet(cells, bead(0.0003))).is_rippled()) << cells;
  }
}

TEST(FormChange, FindsAHillThatSank) {
  const auto hill = [](double height) {
    return [height](double x, double y) { return 0.1 * x * x + height * dent(x, y, 0.12); };
  };
  for (const std::size_t cells : {30U, 60U, 120U}) {
    const TriMesh design = sheet(cells, hill(0.1));
    EXPECT_TRUE(change_of(design, sheet(cells, hill(0.05))).has_lost_relief()) << cells;
    EXPECT_TRUE(change_of(design, sheet(cells, hill(-0.1))).relief_lost > 1.0) << "a hollow";
    EXPECT_FALSE(change_of(design, sheet(cells, hill(0.09))).has_lost_relief()) << cells;
    EXPECT_FALSE(change_of(design, sheet(cells, hill(0.12))).has_lost_relief()) << "higher";
  }
}

TEST(FormChange, LeavesAGentleChangeAlone) {
  for (const std::size_t cells : {30U, 60U, 120U}) {
    const TriMesh after = sheet(cells, [](double x, double y) {
      return 0.93 * panel(x, y) + 0.01 * std::sin(pi * x) * std::sin(pi * y / 0.7);
    });
    const Fairness gentle = measure_fairness(Patch(sheet(cells, panel)), after.positions);
    EXPECT_TRUE(gentle.is_smooth()) << cells;
    EXPECT_TRUE(gentle.keeps_form()) << cells;
  }
}

/// As height, and that much higher or lower at random, the same every time.
template <class Height>
TriMesh noisy_sheet(const Height& height, double noise) {
  std::uint64_t state = 5;
  return sheet(60, [&](double x, double y) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    const double random = static_cast<double>(state >> 33U) / 2147483648.0 - 0.5;
    return height(x, y) + noise * random;
  });
}

TEST(FormChange, DoesNotMindNoiseOfTheDesign) {
  const auto noisy = [](double part) { return noisy_sheet(panel, 0.006 * part); };
  const TriMesh design = noisy(1.0);
  for (const double part : {0.0, 0.5, 1.1}) {
    const Fairness found = measure_fairness(Patch(design), noisy(part).positions);
    EXPECT_TRUE(found.is_smooth()) << part;
    EXPECT_TRUE(found.keeps_form()) << part;
  }
  EXPECT_FALSE(measure_fairness(Patch(design), noisy(3.0).positions).is_smooth()) << "much more";
}

TEST(FormChange, FindsRufflesThatNoiseOfTheDesignHid) {
  const auto dome = [](double x, double y) {
    return 0.25 - 0.4 * (x - 0.5) * (x - 0.5) - 0.5 * (y - 0.35) * (y - 0.35);
  };
  // Waves of six edges that run from the lower border a sixth of the way up.
  const auto ruffled = [&dome](double height) {
    return [&dome, height](double x, double y) {
      return dome(x, y) + height * std::sin(63.0 * x) * std::max(0.0, 1.0 - y / 0.12);
    };
  };
  const TriMesh design = noisy_sheet(dome, 0.004);
  const FormChange calm = change_of(design, noisy_sheet(dome, 0.0));
  EXPECT_LT(calm.ripple, 0.5 * k_seen_ripple) << "noise that is taken out is no fault";
  EXPECT_FALSE(calm.is_folded());
  const FormChange faulty = change_of(design, noisy_sheet(ruffled(0.005), 0.0));
  EXPECT_TRUE(faulty.is_rippled()) << faulty.ripple;
  EXPECT_LT(faulty.fold_at.y, 0.15);
  EXPECT_FALSE(change_of(design, noisy_sheet(ruffled(0.001), 0.0)).is_rippled());
}

TEST(FormChange, DoesNotDependOnSizeOrPlace) {
  const TriMesh design =
      sheet(50, [](double x, double y) { return panel(x, y) + 0.1 * dent(x, y, 0.12); });
  const TriMesh after = sheet(50, [](double x, double y) {
    return 0.8 * panel(x, y) + 0.05 * dent(x, y, 0.12) - 0.01 * dent(x, y, 0.04);
  });
  const auto moved = [](TriMesh mesh) {
    for (Vec3& p : mesh.positions)
      p = {1000.0 * (0.6 * p.x - 0.8 * p.y) + 5e4, 1000.0 * (0.8 * p.x + 0.6 * p.y) - 7.0,
           1000.0 * p.z};
    return mesh;
  };
  const FormChange here = change_of(design, after), there = change_of(moved(design), moved(after));
  EXPECT_NEAR(there.ripple, here.ripple, 1e-6);
  EXPECT_NEAR(there.fold, here.fold, 1e-6);
  EXPECT_NEAR(there.dent, here.dent, 1e-6);
  EXPECT_NEAR(there.uneven_turn, here.uneven_turn, 1e-6);
  EXPECT_NEAR(there.relief_lost, here.relief_lost, 1e-6);
  EXPECT_GT(here.relief_lost, 0.05);
  EXPECT_GT(here.fold, 0.2);
}

TEST(FormChange, SeesWhatIsAboveItsBounds) {
  const auto above = [](double bound) {
    return std::nextafter(bound, std::numeric_limits<double>::infinity());
  };
  EXPECT_FALSE(FormChange{.ripple = k_seen_ripple}.is_rippled());
  EXPECT_TRUE(FormChange{.ripple = above(k_seen_ripple)}.is_rippled());
  EXPECT_FALSE(FormChange{.fold = k_seen_new_fold}.is_folded());
  EXPECT_TRUE(FormChange{.fold = above(k_seen_new_fold)}.is_folded());
  EXPECT_FALSE(FormChange{.dent = k_seen_dent}.is_dented());
  EXPECT_TRUE(FormChange{.dent = above(k_seen_dent)}.is_dented());
  EXPECT_FALSE(FormChange{.uneven_turn = k_seen_uneven_turn}.is_uneven());
  EXPECT_TRUE(FormChange{.uneven_turn = above(k_seen_uneven_turn)}.is_uneven());
  EXPECT_FALSE(FormChange{.relief_lost = k_seen_relief_lost}.has_lost_relief());
  EXPECT_TRUE(FormChange{.relief_lost = above(k_seen_relief_lost)}.has_lost_relief());
  EXPECT_FALSE(FormChange{.edge_lost = k_seen_edge_lost}.has_lost_edge());
  EXPECT_TRUE(FormChange{.edge_lost = above(k_seen_edge_lost)}.has_lost_edge());
}

TEST(FormChange, DecidesTheMarks) {
  Fairness fairness = {.bending_ratio = 1.0, .form_change = FormChange{}};
  const auto with = [&fairness](const FormChange& change) {
    fairness.form_change = change;
    return fairness;
  };
  EXPECT_TRUE(with({}).is_smooth() && with({}).keeps_form());
  for (const FormChange& bad : {FormChange{.ripple = 1.2}, FormChange{.fold = 3.0}}) {
    EXPECT_FALSE(with(bad).is_smooth());
    EXPECT_TRUE(with(bad).keeps_form());
    EXPECT_TRUE(with(bad).is_smooth_within(0.0)) << "searches go by bending alone";
  }
  for (const FormChange& bad : {FormChange{.dent = 0.05}, FormChange{.uneven_turn = 3.0},
                                FormChange{.relief_lost = 0.4}, FormChange{.edge_lost = 0.5}}) {
    EXPECT_TRUE(with(bad).is_smooth());
    EXPECT_FALSE(with(bad).keeps_form());
  }
  fairness = {.bending_ratio = 1.0, .sharp_share = 0.2};
  EXPECT_FALSE(fairness.is_smooth()) << "other triangles: by bending alone";
}

TEST(FormChange, IsTheSameOnAllThreads) {
  const Patch patch(make_shape("panel", 600));
  const auto found = [&](unsigned threads) {
    const FlattenReport report =
        flatten(patch, "panel", {.method = Auto{.limits = {.rms = 0.005}}}, {.threads = threads});
    return *report.evolve.fairness.form_change;
  };
  const FormChange one = found(1U), four = found(4U);
  EXPECT_EQ(one.ripple, four.ripple);
  EXPECT_EQ(one.fold, four.fold);
  EXPECT_EQ(one.dent, four.dent);
  EXPECT_EQ(one.uneven_turn, four.uneven_turn);
  EXPECT_EQ(one.relief_lost, four.relief_lost);
  EXPECT_EQ(one.edge_lost, four.edge_lost);
  EXPECT_GT(one.relief_lost, 0.0);
}

TEST(FormChange, OfNothingIsNothing) {
  EXPECT_EQ(change_of({}, {}).ripple, 0.0);
  const TriMesh flat = meshes::flat_grid(1, 1);
  EXPECT_EQ(change_of(flat, flat).dent, 0.0);
}

}  // namespace
}  // namespace planish
