// Divides a patch with fine detail, which takes tens of seconds.

#include <planish/panels/suggest_panels.h>

#include <gtest/gtest.h>

#include "support/test_files.h"

namespace planish {
namespace {

class PanelsOfPatches : public WithFolder<testing::Test> {
 protected:
  PanelsOfPatches() : WithFolder<testing::Test>("patches") {}
};

TEST_F(PanelsOfPatches, AreFewAndKeepTheLimitOnFineDetail) {
  const Patch hood(read_mesh(test_folder() / "patches" / "gc_hood_13k.obj").mesh);
  PanelOptions options{.limits = {.rms = 0.01}, .prefer = PanelPreference::shortest, .moves = 2};
  options.match_seams = false;
  const PanelSuggestion found = suggest_panels(hood, options, {.threads = 2});
  EXPECT_TRUE(found.met);
  EXPECT_LE(found.panels.size(), 3U);
}

}  // namespace
}  // namespace planish
