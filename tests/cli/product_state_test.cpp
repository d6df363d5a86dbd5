#include <gtest/gtest.h>

#include "cli_run.h"
#include "product/state.h"

namespace planish::cli {
namespace {

const std::string k_report =
    R"({"unfold": {"width": 1, "height": 1, "unit": "mm", "overlaps": false,)"
    R"( "strain": {"rms": 0, "max": 0}}, "evolve": {"stop": "stalled", "deviation": {}},)"
    R"( "limits": [], "files": {}})";

const std::string k_triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// A folder that some earlier run, or somebody else, left.
class ProductState : public CliTest {
 protected:
  /// Writes the files and a job.json that says that they are as they were written.
  void write(const std::string& report, const std::string& processed, const std::string& flat) {
    std::vector<OutputFile> files = {
        {"report.json", report}, {"processed.obj", processed}, {"flat.obj", flat}};
    files.push_back(job_file(job_, files, ""));
    write_files(files);
  }
  bool is_kept() const { return finished_results(job_, ".").has_value(); }

  const std::string job_ = job_of({.name = "piece", .folder = "piece", .mesh = {}}, {}, {});
};

TEST_F(ProductState, KeepsWhatIsWhole) {
  write(k_report, k_triangle, k_triangle);
  EXPECT_TRUE(is_kept());
}

TEST_F(ProductState, RefusesAPatternThatIsNotThatOfThePatch) {
  write(k_report, k_triangle, "v 2 2 2\n" + k_triangle);
  EXPECT_FALSE(is_kept());
  write(k_report, "v 2 2 2\n" + k_triangle, k_triangle);
  EXPECT_FALSE(is_kept());
}

TEST_F(ProductState, RefusesAReportThatLacksWhatIsToldOfIt) {
  for (const char* report :
       {"{}", "[]", "3", R"({"unfold": 1, "evolve": [], "files": {}})",
        R"({"unfold": {"width": "wide"}, "evolve": {"stop": 3}, "files": {}})"}) {
    write(report, k_triangle, k_triangle);
    EXPECT_FALSE(is_kept()) << report;
  }
  std::string endless = k_report;
  endless.replace(endless.find("\"mm\""), 4, "null");
  write(endless, k_triangle, k_triangle);
  EXPECT_FALSE(is_kept()) << endless;
}

TEST_F(ProductState, RefusesAJobOrReportThatIsNestedWithoutEnd) {
  constexpr std::size_t depth = 200'000;
  const std::string nested = std::string(depth, '[') + std::string(depth, ']');
  write(k_report, k_triangle, k_triangle);
  std::ofstream("job.json") << "{\"files\": {}, \"a\": " << nested << "}";
  EXPECT_FALSE(is_kept());
  std::string report = k_report;
  report.replace(report.find("\"deviation\": {}"), 15, "\"deviation\": " + nested);
  write(report, k_triangle, k_triangle);
  EXPECT_FALSE(is_kept());
}

}  // namespace
}  // namespace planish::cli
