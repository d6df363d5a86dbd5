#include <gtest/gtest.h>
#include <planish_json/json.h>

#include "cli/cli_run.h"
#include "product/figures.h"
#include "product/state.h"

namespace planish::cli {
namespace {

const std::string k_triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// Figures that all differ.
FinishedPatch results() {
  FinishedPatch patch;
  Pattern& pattern = patch.unfold.pattern;
  pattern.width = 12.5;
  pattern.height = 0.1 + 0.2;
  pattern.area_ratio = 1.0 / 3.0;
  pattern.flipped_triangles = 3;
  pattern.overlaps = true;
  pattern.opened = OpenedCrossings{4, 0.0625, 2};
  patch.unfold.overlap = Overlap{{1.0, 2.5}, {3.0, 4.5}, 5};
  pattern.iterations = 17;
  pattern.converged = true;
  patch.unfold.unit = Unit::cm;
  patch.unfold.strain = {0.03, 1e-17, 0.02, {7, 9}};
  patch.unfold.border_strain = 0.004;
  patch.unfold.unmatched_strain = EdgeStrain{0.05, 0.006, 0.04, {1, 2}};
  patch.unfold.limits = {{Criterion::p99_strain, 0.08, 0.09, false, 0.01, {3, 4}, {1.5, -2.5, 3.5}},
                         {Criterion::rms_strain, 0.01, 0.02, false, 0.5, {5, 6}, {}}};
  patch.deviation = {0.7, 1.9, 1e-4};
  patch.stop = StopReason::angle_limit;
  patch.twin_of = TwinOf{"left \u00FC", true};
  patch.rejected = EdgeStrain{0.5, 0.25, 0.4, {8, 9}};
  patch.limits = {{Criterion::p99_strain, 0.08, 0.09, false}, {Criterion::angle, 10.0, 9.0, false}};
  patch.form_faults = {{Criterion::crumpled, "is crumpled"}, {Criterion::form, "is lost"}};
  return patch;
}

/// A folder that some earlier run, or somebody else, left.
class ProductState : public CliTest {
 protected:
  /// Writes the files and a job.json that says that they are as they were written.
  void write(const std::string& processed, const std::string& flat) {
    std::vector<OutputFile> files = {
        {"report.json", "{}"}, {"processed.obj", processed}, {"flat.obj", flat}};
    files.push_back(job_file(job_, results(), files, ""));
    write_files(files);
  }
  void write_job(const Json& json) { std::ofstream("job.json") << json.dump(); }
  Json read_job() const { return Json::parse(content_of("job.json")); }
  bool is_kept() const { return finished_results(job_, ".").has_value(); }

  const PatchJob job_ = job_of({.name = "piece", .mesh = {}}, MeshFormat::obj, {}, {}, {});
};

TEST_F(ProductState, KeepsWhatIsWhole) {
  write(k_triangle, k_triangle);
  const auto kept = finished_results(job_, ".");
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->processed.positions.size(), 3U);
  EXPECT_EQ(kept->unfold.pattern.positions.size(), 3U);
  EXPECT_EQ(figures_json(*kept), figures_json(results()));
  EXPECT_EQ(kept->unfold.pattern.height, 0.1 + 0.2) << "to the bit";
  EXPECT_EQ(kept->twin_of->name, "left \u00FC");
  ASSERT_EQ(kept->form_faults.size(), 2U);
  EXPECT_EQ(kept->form_faults[1].text, "is lost");
  EXPECT_EQ(kept->outcome().missed, results().outcome().missed);
  EXPECT_FALSE(kept->unfold.unlimited_strain);
}

TEST_F(ProductState, IsOfAnotherJobWhereOtherEdgesAreSewn) {
  write(k_triangle, k_triangle);
  const auto is_kept_for = [](const SewnBorder& border) {
    const PatchJob job = job_of({.name = "piece", .mesh = {}}, MeshFormat::obj, {}, border, {});
    return finished_results(job, ".").has_value();
  };
  EXPECT_TRUE(is_kept_for({}));
  EXPECT_FALSE(is_kept_for({.has_seams = true}));
  EXPECT_FALSE(is_kept_for({.has_seams = true, .free_edges = {{0, 1}}}));
}

TEST_F(ProductState, KeepsThatABorderCannotKeepItsLengths) {
  FinishedPatch patch = results();
  for (const bool is_unmatchable : {false, true}) {
    patch.unfold.pattern.is_unmatchable = is_unmatchable;
    const auto read = patch_of_figures(Json::parse(figures_json(patch).dump()));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->unfold.pattern.is_unmatchable, is_unmatchable);
  }
}

TEST_F(ProductState, RefusesAPatternThatIsNotThatOfThePatch) {
  write(k_triangle, "v 2 2 2\n" + k_triangle);
  EXPECT_FALSE(is_kept());
  write("v 2 2 2\n" + k_triangle, k_triangle);
  EXPECT_FALSE(is_kept());
}

// Figures are the fields of structs by their numbers: 1 is `unfold`, 1/0 its pattern, 1/5 the
// limits.
TEST_F(ProductState, RefusesFiguresThatOneIsMissingFrom) {
  write(k_triangle, k_triangle);
  const Json whole = read_job();
  const auto refuses_without = [&](const Json::json_pointer& place) {
    Json less = whole;
    Json& parent = less[place.parent_pointer()];
    if (parent.is_array())
      parent.erase(std::stoul(place.back()));
    else
      parent.erase(place.back());
    write_job(less);
    return !is_kept();
  };
  write_job(whole);
  EXPECT_TRUE(is_kept());
  for (const char* figure : {"", "/1", "/2", "/3", "/7/0/1", "/4", "/1/0", "/1/5", "/1/0/1",
                             "/1/1/3", "/1/4/2", "/1/5/1/6/2", "/6/0/3", "/4/1"})
    EXPECT_TRUE(refuses_without(Json::json_pointer("/figures" + std::string(figure)))) << figure;
}

TEST_F(ProductState, RefusesFiguresThatCannotBe) {
  write(k_triangle, k_triangle);
  const Json whole = read_job();
  const auto refuses = [&](const char* figure, const Json& value) {
    Json other = whole;
    other[Json::json_pointer("/figures" + std::string(figure))] = value;
    write_job(other);
    return !is_kept();
  };
  EXPECT_FALSE(refuses("/1/0/1", 3));
  for (const Json& value : {Json(nullptr), Json("wide"), Json(true), Json::array({1.0})})
    EXPECT_TRUE(refuses("/1/0/1", value)) << value;
  for (const Json& value : {Json(-1), Json(0.5), Json(99), Json(nullptr), Json("angle_limit")})
    EXPECT_TRUE(refuses("/3", value)) << value;
  for (const Json& value : {Json(1), Json(nullptr), Json("true")})
    EXPECT_TRUE(refuses("/1/0/5", value)) << value;
  for (const Json& value : {Json::array(), Json::array({1}), Json::array({1, 2, 3}),
                            Json::array({1, -2}), Json::array({1, 1ULL << 40U}), Json(4)})
    EXPECT_TRUE(refuses("/1/1/3", value)) << value;
  for (const Json& value : {Json::object(), Json(nullptr), Json::array({Json::object()})})
    EXPECT_TRUE(refuses("/1/5", value)) << value;
  for (const char* unused : {"/1/0/8", "/1/0/9"})
    EXPECT_TRUE(refuses(unused, {{1.0, 2.0}})) << "a pattern that results do not have";
  for (const Json& value : {Json::object(), Json("left")})
    EXPECT_TRUE(refuses("/4", value)) << value;
  for (const Json& value : {Json::array(), Json(nullptr), Json(1)})
    EXPECT_TRUE(refuses("", value)) << value;
}

TEST_F(ProductState, RefusesAFolderWithoutAReport) {
  std::vector<OutputFile> files = {{"processed.obj", k_triangle}, {"flat.obj", k_triangle}};
  files.push_back(job_file(job_, results(), files, ""));
  write_files(files);
  EXPECT_FALSE(is_kept());
}

TEST_F(ProductState, RefusesAJobThatIsNestedWithoutEnd) {
  constexpr std::size_t depth = 200'000;
  const std::string nested = std::string(depth, '[') + std::string(depth, ']');
  write(k_triangle, k_triangle);
  std::ofstream("job.json") << "{\"files\": {}, \"a\": " << nested << "}";
  EXPECT_FALSE(is_kept());
}

}  // namespace
}  // namespace planish::cli
