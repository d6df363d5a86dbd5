// --fields of measure and flatten.

#include <algorithm>

#include <planish/io/read_mesh.h>

#include <gmock/gmock.h>

#include "cli_run.h"
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

}  // namespace
}  // namespace planish::cli
