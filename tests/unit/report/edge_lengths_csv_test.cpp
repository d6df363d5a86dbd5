#include <vector>

#include <planish/mesh/patch.h>
#include <planish/report/json_report.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

TEST(EdgeLengthsCsv, HasALineFromCornerToCorner) {
  const Patch patch(meshes::flat_grid(4, 2));
  std::vector<Vec2> pattern;
  for (const Vec3 p : patch.positions())
    pattern.push_back({1.5 * p.x, p.y});  // longer than on the model
  EXPECT_EQ(edge_lengths_csv(patch, pattern, Unit::cm),
            "loop,from_vertex,to_vertex,length,length_on_model\n"
            "0,0,4,60,40\n"
            "0,4,14,20,20\n"
            "0,14,10,60,40\n"
            "0,10,0,20,20\n");
}

}  // namespace
}  // namespace planish
