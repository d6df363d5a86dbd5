#include "flatten/product/twin_groups.h"

#include <gmock/gmock.h>

namespace planish {
namespace {

using testing::ElementsAre;

TEST(TwinGroups, ComeInTheOrderOfTheirFirstOnes) {
  std::vector<std::optional<MeshTwin>> twins(5);
  twins[2] = MeshTwin{0, {}};
  twins[3] = MeshTwin{1, {}};
  twins[4] = MeshTwin{0, {}};
  EXPECT_THAT(groups_of(std::vector<std::size_t>{4, 1, 2, 0, 3}, twins),
              ElementsAre(ElementsAre(1, 3), ElementsAre(0, 4, 2)));
  EXPECT_THAT(groups_of(std::vector<std::size_t>{4, 3, 1}, twins),
              ElementsAre(ElementsAre(4), ElementsAre(1, 3)));
}

}  // namespace
}  // namespace planish
