// What the meshes of real patches cannot show, and those of files that were made to hide something.

#include <filesystem>
#include <set>
#include <string>

#include <planish/io/read_mesh.h>
#include <planish/measure/cautions.h>

#include <gtest/gtest.h>

#include "support/test_files.h"
#include "support/test_patches.h"

namespace planish {
namespace {

std::string found_in(const std::filesystem::path& path) {
  return words_of(find_cautions(Patch(read_mesh(path).mesh)));
}

TEST(Cautions, OfRealPatchesAreCoarseFacetsOnly) {
  // Round heads of few triangles, a brim, folds of cloth and a rough terrain: there facets turn by
  // 10 to 13 degrees on a tenth of the area.
  const std::set<std::string> coarse = {"cowhead_15k.obj",   "goathead_4k.obj",
                                        "hat_fedora_2k.obj", "jumpsuit_front_3k.obj",
                                        "mountain_26k.obj",  "spothead_4k.obj"};
  for (const PatchFacts& patch : patches())
    EXPECT_EQ(found_in(patch.path), coarse.contains(patch.name) ? "coarse facets" : "")
        << patch.name;
}

class CautionsOfOddFiles : public WithOddFiles<> {};

TEST_F(CautionsOfOddFiles, AreWhatTheyWereMadeFor) {
  const std::filesystem::path odd = file("odd");
  EXPECT_EQ(found_in(odd / "scan_noise.stl"), "looks like a noisy scan");
  EXPECT_EQ(found_in(odd / "coarse_facets.obj"), "coarse facets");
  EXPECT_EQ(found_in(odd / "half_cylinder_one_row.obj"), "coarse facets")
      << "its edges are rulings";
  EXPECT_EQ(found_in(odd / "tube_lowpoly_one_row.obj"), "coarse facets") << "likewise";
  EXPECT_EQ(found_in(odd / "far_origin_reference.obj"), "");
}

}  // namespace
}  // namespace planish
