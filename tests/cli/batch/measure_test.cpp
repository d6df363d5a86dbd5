// Measuring several files, and --fields of measure and flatten.

#include <algorithm>
#include <sstream>

#include <planish/io/read_mesh.h>

#include <gmock/gmock.h>

#include "cli/batch/csv_table.h"
#include "cli/cli_run.h"
#include "support/meshes.h"
#include "support/products.h"

namespace planish::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class FieldsFlag : public CliTest {};

Names quick_flatten(const Names& more) {
  Names args = {"flatten",      "panel.obj", "-o", "out",       "--method",
                "controllable", "--sweeps",  "2",  "--formats", "svg"};
  args.insert(args.end(), more.begin(), more.end());
  return args;
}

TEST_F(FieldsFlag, OfMeasureWritesTheInput) {
  const CliResult result = planish({"measure", "panel.obj", "--fields", "f.PLY"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.out, HasSubstr("f.PLY"));
  EXPECT_THAT(names(), ElementsAre("f.PLY", "panel.obj"));
  const TriMesh mesh = read_mesh("panel.obj").mesh, with_fields = read_mesh("f.PLY").mesh;
  EXPECT_TRUE(with_fields.positions == mesh.positions);
  EXPECT_EQ(with_fields.triangles, mesh.triangles);
  EXPECT_THAT(content_of("f.PLY"), HasSubstr("\nproperty double strain_max\n"));
  EXPECT_THAT(content_of("f.PLY"), Not(HasSubstr("offset")));
}

TEST_F(FieldsFlag, OfMeasureLeaveOutStrainOfWhatCannotBeLaidFlat) {
  write_mesh("tube.obj", meshes::tube(12, 5));
  EXPECT_EQ(planish({"measure", "tube.obj", "--fields", "tube.csv"}).exit_code, k_exit_done);
  EXPECT_THAT(content_of("tube-vertices.csv"),
              StartsWith("vertex,x,y,z,inner,defect,mean_curvature\n0,"));
  EXPECT_THAT(content_of("tube-triangles.csv"), StartsWith("triangle,a,b,c\n0,"));
}

TEST_F(FieldsFlag, OfMeasureGoWithTheMapAndThePicture) {
  const CliResult result = planish({"measure", "panel.obj", "--map", "m.csv", "--picture", "m.svg",
                                    "--fields", "f.vtu", "--json"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(names(), ElementsAre("f.vtu", "m.csv", "m.svg", "panel.obj"));
  EXPECT_THAT(content_of("m.csv"), StartsWith("vertex,class,"));
  EXPECT_THAT(content_of("m.svg"), HasSubstr("<svg"));
  EXPECT_THAT(content_of("f.vtu"), HasSubstr("UnstructuredGrid"));
}

TEST_F(FieldsFlag, OfFlattenAreNamedInTheReport) {
  const auto vtp = planish(quick_flatten({"--fields", "f.vtp", "--json"})).json();
  EXPECT_EQ(vtp["files"]["fields"], "f.vtp");
  EXPECT_THAT(content_of("f.vtp"), HasSubstr("Name=\"offset\""));
  const auto csv = planish(quick_flatten({"--fields", "new/f.csv", "--json"})).json();
  EXPECT_EQ(csv["files"]["fields_vertices"], "new/f-vertices.csv");
  EXPECT_EQ(csv["files"]["fields_triangles"], "new/f-triangles.csv");
  const std::string table = content_of("new/f-vertices.csv");
  EXPECT_EQ(static_cast<std::size_t>(std::count(table.begin(), table.end(), '\n')),
            read_mesh("panel.obj").mesh.positions.size() + 1);
}

TEST_F(FieldsFlag, RefusesOtherFormatsAndSharedPlaces) {
  for (const Names& args :
       {Names{"measure", "panel.obj", "--fields", "f.obj"}, quick_flatten({"--fields", "f"})}) {
    Names with_json = args;
    with_json.push_back("--json");
    const CliResult result = planish(with_json);
    EXPECT_EQ(result.exit_code, k_exit_failed);
    EXPECT_EQ(result.json()["error"]["code"], "unsupported_format");
  }
  EXPECT_EQ(
      planish({"measure", "panel.obj", "--fields", "m.csv", "--map", "m-vertices.csv"}).exit_code,
      k_exit_usage);
  EXPECT_EQ(planish(quick_flatten({"--fields", "f.ply", "--history", "./f.ply"})).exit_code,
            k_exit_usage);
  EXPECT_THAT(names(), ElementsAre("panel.obj"));
}

TEST_F(FieldsFlag, GoesWithOnePatchOnly) {
  write_product("coat.obj",
                {{"front", make_shape("dome", 100), {}}, {"back", make_shape("saddle", 100), {}}});
  const CliResult result = planish({"flatten", "coat.obj", "-o", "out", "--fields", "f.ply"});
  EXPECT_EQ(result.exit_code, k_exit_usage);
  EXPECT_THAT(result.err, HasSubstr("--fields goes with one patch only"));
}

class MeasureSeveral : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    std::filesystem::create_directory("more");
    write_mesh("more/dome.ply", make_shape("dome", 150));
    write_mesh("more/saddle.off", make_shape("saddle", 150));
    std::ofstream("more/notes.txt") << "no mesh\n";
    std::ofstream("bad.obj") << "v 0 0\n";
  }
};

TEST_F(MeasureSeveral, WritesALineAFileOfFilesAndFolders) {
  const CliResult result = planish({"measure", "panel.obj", "more", "--csv", "out/figures.csv"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  const auto rows = table_in(content_of("out/figures.csv"));
  ASSERT_EQ(rows.size(), 4U);
  const Names files = {"panel.obj", "more/dome.ply", "more/saddle.off"};
  for (std::size_t f = 0; f < files.size(); ++f) {
    const Names& row = rows[f + 1];
    ASSERT_EQ(row.size(), rows[0].size());
    EXPECT_EQ(row[0], files[f]);
    const auto json = planish({"measure", files[f], "--json"}).json();
    const auto strain = json["strain"];
    for (std::size_t c = 1; c < row.size(); ++c) {
      const std::string& column = rows[0][c];
      if (column == "error" || column == "message" || column == "limits_kept") {
        EXPECT_EQ(row[c], "") << column;
      } else if (column == "flattenable") {
        EXPECT_EQ(row[c], json[column].get<bool>() ? "1" : "0");
      } else if (column.starts_with("strain_")) {
        EXPECT_EQ(std::stod(row[c]), strain[column.substr(7)].get<double>()) << column;
      } else {
        const auto& figure = column == "smallest_limit" ? strain[column] : json[column];
        EXPECT_EQ(std::stod(row[c]), figure.get<double>()) << column;
      }
    }
    EXPECT_THAT(result.out, HasSubstr(files[f]));
  }
}

TEST_F(MeasureSeveral, GoesOnBehindABadFileAndEndsWithItsCode) {
  const CliResult result = planish(
      {"measure", "bad.obj", "panel.obj", "no/such,file.ply", "--csv", "figures.csv", "--json"});
  EXPECT_EQ(result.exit_code, k_exit_failed);
  EXPECT_THAT(result.err, HasSubstr("2 of 3 files failed"));
  const std::string csv = content_of("figures.csv");
  EXPECT_THAT(csv, HasSubstr("\n\"no/such,file.ply\",,,"));
  const auto rows = table_in(csv);
  EXPECT_EQ(rows.size(), 4U);
  const auto json = result.json();
  EXPECT_EQ(json["schema"], 2);
  EXPECT_EQ(json["csv"], "figures.csv");
  ASSERT_EQ(json["files"].size(), 3U);
  EXPECT_EQ(json["files"][0]["error"]["code"],
            planish({"measure", "bad.obj", "--json"}).json()["error"]["code"]);
  EXPECT_FALSE(json["files"][0].contains("e_max"));
  EXPECT_EQ(json["files"][2]["error"]["code"], "file_not_found");
  auto one = json["files"][1];
  EXPECT_EQ(one["path"], "panel.obj");
  EXPECT_TRUE(one["error"].is_null());
  one.erase("path");
  one.erase("error");
  auto alone = planish({"measure", "panel.obj", "--json"}).json();
  alone.erase("schema");
  EXPECT_EQ(one, alone);
}

TEST_F(MeasureSeveral, NeedsNoTable) {
  const auto json = planish({"measure", "more", "--json"}).json();
  EXPECT_EQ(json["files"].size(), 2U);
  EXPECT_TRUE(json["csv"].is_null());
  const CliResult text = planish({"measure", "more", "panel.obj"});
  std::istringstream lines(text.out);
  for (std::string line; std::getline(lines, line);)
    EXPECT_LE(line.size(), 80U) << line;
}

TEST_F(MeasureSeveral, TakesAFolderWithoutMeshesForAFileThatFailed) {
  std::filesystem::create_directory("empty");
  const CliResult result = planish({"measure", "empty", "panel.obj", "--json"});
  EXPECT_EQ(result.exit_code, k_exit_failed);
  EXPECT_EQ(result.json()["files"][0]["error"]["code"], "file_unreadable");
  EXPECT_TRUE(result.json()["files"][1]["error"].is_null());
}

TEST_F(MeasureSeveral, SaysWhichPatternsKeepALimit) {
  write_mesh("flat.obj", meshes::flat_grid(4, 4));
  const CliResult result =
      planish({"measure", "flat.obj", "more/dome.ply", "--csv", "f.csv", "--max-strain", "0.01%"});
  EXPECT_EQ(result.exit_code, k_exit_target_missed) << result.err;
  const auto rows = table_in(content_of("f.csv"));
  const auto at = std::find(rows[0].begin(), rows[0].end(), "limits_kept") - rows[0].begin();
  EXPECT_EQ(rows[1].at(static_cast<std::size_t>(at)), "1");
  EXPECT_EQ(rows[2].at(static_cast<std::size_t>(at)), "0");
}

TEST_F(MeasureSeveral, RefusesWhatGoesWithOneFile) {
  for (const char* flag : {"--map", "--picture", "--fields"}) {
    const CliResult result = planish({"measure", "panel.obj", "more", flag, "f.svg"});
    EXPECT_EQ(result.exit_code, k_exit_usage);
    EXPECT_THAT(result.err, HasSubstr(std::string(flag) + " goes with one file only"));
  }
  EXPECT_EQ(planish({"convert", "panel.obj", "a.ply", "b.ply"}).exit_code, k_exit_usage);
}

}  // namespace
}  // namespace planish::cli
