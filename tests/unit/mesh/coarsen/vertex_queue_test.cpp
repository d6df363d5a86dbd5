#include "mesh/coarsen/vertex_queue.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

TEST(VertexQueue, HasTheSmallestOnTopWhateverChanges) {
  constexpr double outside = std::numeric_limits<double>::infinity();
  meshes::Random random(11);
  std::vector<double> keys(40, outside);
  VertexQueue<double> queue(keys.size());
  for (int i = 0; i < 5000; ++i) {
    const auto v = static_cast<Index>(20.0 * (1.0 + random.number()));
    if (random.number() < 0.2) {
      keys[v] = outside;
      queue.remove(v);
    } else {
      keys[v] = static_cast<int>(10.0 * random.number());  // with ties
      queue.set(v, keys[v]);
    }
    const auto least = std::min_element(keys.begin(), keys.end());
    ASSERT_EQ(queue.empty(), *least == outside);
    if (queue.empty()) continue;
    EXPECT_EQ(queue.top_key(), *least);
    EXPECT_EQ(queue.top(), static_cast<Index>(least - keys.begin()));
  }
}

}  // namespace
}  // namespace planish
