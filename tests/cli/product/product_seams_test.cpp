// Seams of whole products: equal on both sides, with notches that meet, as the files tell it.

#include <cmath>
#include <map>
#include <tuple>

#include <planish/io/read_mesh.h>
#include <planish/mesh/patch.h>

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "mesh/split.h"
#include "support/jacket.h"
#include "support/meshes.h"
#include "support/products.h"
#include "support/test_patches.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;

double length_of(const TriMesh& mesh, const std::vector<Index>& way) {
  double length = 0.0;
  for (std::size_t k = 0; k + 1 < way.size(); ++k)
    length += norm(mesh.positions[way[k + 1]] - mesh.positions[way[k]]);
  return length;
}

/// The border's vertices along a side of a seam, as the report tells it.
std::vector<Index> border_along(const TriMesh& mesh, const nlohmann::json& side) {
  const Index from = side["first_vertex"], to = side["last_vertex"];
  const std::size_t count = side["vertices"];
  const double length = side["length"];
  const Patch patch(mesh);
  for (const auto& loop : patch.border_loops()) {
    for (const bool ahead : {true, false}) {
      std::vector<Index> way(loop);
      if (!ahead) std::reverse(way.begin(), way.end());
      const auto start = std::find(way.begin(), way.end(), from);
      if (start == way.end()) continue;
      std::rotate(way.begin(), start, way.end());
      if (way.size() < count || way[count - 1] != to) continue;
      way.resize(count);
      if (std::abs(length_of(mesh, way) - length) < 1e-6) return way;
    }
  }
  ADD_FAILURE() << "no such way along the border";
  return {};
}

/// The lines of a layer of a DXF file.
std::vector<std::vector<Vec2>> dxf_lines(const std::string& path, const std::string& layer) {
  std::ifstream file(path);
  std::vector<std::vector<Vec2>> lines;
  bool in_vertex = false, in_layer = false;
  double x = 0.0;
  for (std::string code, value; std::getline(file, code) && std::getline(file, value);) {
    const int tag = std::stoi(code);
    if (tag == 0) in_vertex = value == "VERTEX";
    if (tag == 0 && value == "POLYLINE") in_layer = false;
    if (tag == 8 && !in_vertex) {
      in_layer = value == layer;
      if (in_layer) lines.emplace_back();
    }
    if (!in_vertex || !in_layer) continue;
    if (tag == 10) x = std::stod(value);
    if (tag == 20) lines.back().push_back({x, std::stod(value)});
  }
  std::erase_if(lines, [](const auto& line) { return line.empty(); });
  return lines;
}

/// How far along a line the place of it is that lies nearest to a point.
double way_along(const std::vector<Vec2>& line, Vec2 p) {
  double way = 0.0, best_way = 0.0, best = 1e300;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Vec2 edge = line[k + 1] - line[k];
    const double length = norm(edge);
    const double t = std::clamp(dot(p - line[k], edge) / (length * length), 0.0, 1.0);
    const double distance = norm(line[k] + t * edge - p);
    if (distance < best) {
      best = distance;
      best_way = way + t * length;
    }
    way += length;
  }
  EXPECT_LT(best, 1e-3) << "the notch does not begin at the border";
  return best_way;
}

/// Ways of all notches of a piece that begin on a side of a seam, from the side's first vertex.
std::vector<double> notch_ways(const std::string& folder, const nlohmann::json& side) {
  const TriMesh flat = read_mesh(folder + "/flat.obj").mesh;
  const auto cut = dxf_lines(folder + "/pattern.dxf", "cut").at(0);
  // The sheet's line begins at the border's vertex of the smallest number.
  const Patch patch(flat);
  Index first = static_cast<Index>(flat.positions.size());
  for (const Index v : patch.border_loops().front())
    first = std::min(first, v);
  const Vec2 shift = cut.at(0) - Vec2{flat.positions[first].x, flat.positions[first].y};
  std::vector<Vec2> line;
  for (const Index v : border_along(flat, side))
    line.push_back(shift + Vec2{flat.positions[v].x, flat.positions[v].y});
  // Of two places that a DXF file has to three decimals.
  constexpr double rounding = 1.5e-3;
  std::vector<double> ways;
  for (const auto& notch : dxf_lines(folder + "/pattern.dxf", "notch")) {
    double nearest = 1e300;
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      const Vec2 edge = line[k + 1] - line[k];
      const double t = std::clamp(dot(notch[0] - line[k], edge) / dot(edge, edge), 0.0, 1.0);
      nearest = std::min(nearest, norm(line[k] + t * edge - notch[0]));
    }
    if (nearest < rounding) ways.push_back(way_along(line, notch[0]));
  }
  std::sort(ways.begin(), ways.end());
  return ways;
}

/// Runs a product with notches at 30 % and 50 % of all seams and looks at what meets.
void expect_seams_to_fit(const std::string& input, std::size_t seam_count, const Names& more) {
  std::ofstream("seams.txt") << "* 30%\n* 50%\n";
  // Cuts along edges have teeth, and a notch must not cut one off: it is shallow.
  Names args = {"flatten",   input,       "-o",  "out",           "--json", "--seam-notches",
                "seams.txt", "--formats", "dxf", "--notch-depth", "1mm"};
  args.insert(args.end(), more.begin(), more.end());
  const CliResult run = planish(args);
  ASSERT_EQ(run.exit_code, k_exit_done) << run.err;
  const nlohmann::json result = run.json();
  std::map<std::string, std::string> folders;
  for (const nlohmann::json& patch : result["patches"])
    folders[patch["name"]] = "out/" + patch["folder"].get<std::string>();
  ASSERT_EQ(result["seams"].size(), seam_count);
  for (const nlohmann::json& seam : result["seams"]) {
    EXPECT_LT(seam["difference"], 0.01);
    EXPECT_NEAR(seam["sides"][0]["length"], seam["length_on_model"], 0.01);
    std::vector<std::vector<double>> ways;
    for (const nlohmann::json& side : seam["sides"])
      ways.push_back(notch_ways(folders.at(side["patch"]), side));
    ASSERT_GE(ways[0].size(), 2U);
    ASSERT_EQ(ways[0].size(), ways[1].size());
    for (std::size_t k = 0; k < ways[0].size(); ++k)
      EXPECT_NEAR(ways[0][k], ways[1][k], 0.01);
    const double length = seam["length_on_model"];
    EXPECT_NEAR(ways[0][0], 0.3 * length, 0.01);
    EXPECT_NEAR(ways[0][1], 0.5 * length, 0.01);
  }
}

using ProductSeams = CliTest;

TEST_F(ProductSeams, OfThreePatchesOfASampleFitAndTheirNotchesMeet) {
  for (const char* shape : {"saddle", "panel", "dome"}) {
    write_product("coat.obj", in_strips(make_shape(shape, 1500), 3));
    expect_seams_to_fit("coat.obj", 2, {"--unit", "mm"});
    std::filesystem::remove_all("out");
  }
}

TEST_F(ProductSeams, OfARealPatchInTwoFitAndTheirNotchesMeet) {
  for (const PatchFacts& facts : patches()) {
    if (facts.name != "gc_front_4k.obj") continue;
    TriMesh mesh = read_mesh(facts.path).mesh;
    for (Vec3& p : mesh.positions)
      p = 1000.0 * p;  // metres
    write_product("coat.obj", in_strips(mesh, 2));
    expect_seams_to_fit("coat.obj", 1, {});
    std::filesystem::remove_all("out");
  }
}

TEST_F(ProductSeams, OfAJacketMeshedPanelByPanelAreFoundAndTheirNotchesMeet) {
  write_product("jacket.obj", meshes::Jacket::panels());
  std::ofstream("seams.txt") << "* 30%\n* 50%\n";
  const CliResult run = planish({"flatten", "jacket.obj", "-o", "out", "--json", "--seam-notches",
                                 "seams.txt", "--formats", "dxf"});
  ASSERT_EQ(run.exit_code, k_exit_done) << run.err;
  const nlohmann::json result = run.json();
  ASSERT_EQ(result["seams"].size(), meshes::Jacket::seams().size());
  EXPECT_TRUE(result["near_borders"].empty());
  for (const nlohmann::json& seam : result["seams"]) {
    EXPECT_EQ(seam["matched"], "curve");
    EXPECT_NEAR(seam["difference"], seam["difference_on_model"], 0.01);
    EXPECT_EQ(seam["longer"].is_null(), seam["difference"] < 0.01);
    for (const nlohmann::json& side : seam["sides"]) {
      EXPECT_NEAR(side["length"], side["length_on_model"], 0.01);
      const std::string folder = "out/" + side["patch"].get<std::string>();
      const std::string one = seam["sides"][0]["patch"], other = seam["sides"][1]["patch"];
      const std::string partner = one == other ? "" : ": " + (side["patch"] == one ? other : one);
      EXPECT_THAT(content_of(folder + "/pattern.dxf"),
                  HasSubstr("\nseam " + seam["number"].dump() + partner + "\n"));
      const auto ways = notch_ways(folder, side);
      const double length = side["length"];
      ASSERT_GE(ways.size(), 2U);
      EXPECT_NEAR(ways[0], 0.3 * length, 1e-3 * length);
      EXPECT_NEAR(ways[1], 0.5 * length, 1e-3 * length);
    }
  }
  const std::string page = content_of("out/garment.html");
  EXPECT_THAT(page, HasSubstr("mm longer in the pattern and on the model</small>"));
}

/// Real patches by their names; none where there are no real patches.
/// @throws std::out_of_range where there are others, but not these
std::vector<NamedPatch> real_panels(const Names& names) {
  std::map<std::string, std::filesystem::path> paths;
  for (const PatchFacts& facts : patches())
    paths[facts.name] = facts.path;
  std::vector<NamedPatch> panels;
  for (const std::string& name : paths.empty() ? Names{} : names)
    panels.push_back({name, read_mesh(paths.at(name)).mesh, {}});
  return panels;
}

TEST_F(ProductSeams, OfRealPanelsMeshedApartAreFound) {
  const std::vector<NamedPatch> panels = real_panels({"gc_front_4k.obj", "gc_back_5k.obj"});
  if (panels.empty()) return;  // no real patches here
  write_product("body.obj", panels);
  const nlohmann::json result = planish({"flatten", "body.obj", "-o", "out", "--json", "--unit",
                                         "m", "--sweeps", "1", "--formats", "svg"})
                                    .json();
  ASSERT_EQ(result["seams"].size(), 4U);
  const std::vector<double> lengths = {92.4, 38.8, 390.0, 371.8};  // two shoulders, two sides
  for (std::size_t s = 0; s < 4; ++s) {
    EXPECT_NEAR(result["seams"][s]["length_on_model"], lengths[s], 0.1);
    EXPECT_LT(result["seams"][s]["difference_on_model"], 0.05);
  }
}

TEST_F(ProductSeams, RefuseNotchesBeyondThem) {
  write_product("coat.obj", in_strips(make_shape("saddle", 400), 2));
  std::ofstream("seams.txt") << "1 100m\n";
  const Names begin = {"flatten", "coat.obj", "-o", "out", "--seam-notches", "seams.txt"};
  EXPECT_THAT(planish(begin).err, HasSubstr("seams.txt"));
  std::ofstream("seams.txt") << "1 99999mm\n";
  const CliResult result = planish(begin);
  EXPECT_EQ(result.exit_code, k_exit_failed);
  EXPECT_THAT(result.err, HasSubstr("\"strip-1\" and \"strip-2\""));
  EXPECT_THAT(result.err, HasSubstr("beyond seam 1"));
  EXPECT_FALSE(std::filesystem::exists("out"));
}

TEST_F(ProductSeams, AreKeptOnResumingOnlyWithTheSameNotches) {
  write_product("coat.obj", in_strips(make_shape("saddle", 400), 2));
  const Names args = {"flatten",  "coat.obj",       "-o",        "out",           "--pick", "3",
                      "--resume", "--seam-notches", "seams.txt", "--notch-depth", "1mm"};
  std::ofstream("seams.txt") << "* 50%\n";
  EXPECT_EQ(planish(args).exit_code, k_exit_done);
  EXPECT_THAT(planish(args).err, HasSubstr("from the earlier run"));
  std::ofstream("seams.txt") << "* 40%\n";
  EXPECT_THAT(planish(args).err, testing::Not(HasSubstr("from the earlier run")));
}

/// Two sheets side by side, a tenth of a millimetre apart, with other vertices at the gap.
void write_sheets_side_by_side() {
  std::filesystem::create_directories("apart");
  for (const auto& [name, rows, first] :
       {std::tuple{"left", 20, 0.0}, std::tuple{"right", 27, 40.1}}) {
    TriMesh mesh = meshes::flat_grid(20, rows);
    for (Vec3& p : mesh.positions)
      p = {first + 2.0 * p.x, 80.0 * p.y / rows, 0.0};
    write_mesh(std::string("apart/") + name + ".obj", mesh);
  }
}

TEST_F(ProductSeams, MatchBordersWhoseVerticesDiffer) {
  write_sheets_side_by_side();
  const CliResult result = planish({"flatten", "apart", "--product", "-o", "out"});
  EXPECT_THAT(result.out, HasSubstr("left - right\n"));
  const nlohmann::json seams = nlohmann::json::parse(content_of("out/garment.json"))["seams"];
  ASSERT_EQ(seams.size(), 1U);
  EXPECT_EQ(seams[0]["matched"], "curve");
  EXPECT_EQ(seams[0]["longer"], nlohmann::json(nullptr));
  for (const nlohmann::json& side : seams[0]["sides"])
    EXPECT_NEAR(side["length_on_model"].get<double>(), 80.0, 1e-9);
  EXPECT_THAT(planish({"flatten", "apart", "-o", "batch"}).out,
              HasSubstr("--product searches for seams"));
}

TEST_F(ProductSeams, NamesBordersThatCouldNotBeMatched) {
  write_sheets_side_by_side();
  const CliResult result =
      planish({"flatten", "apart", "--product", "-o", "out", "--seam-tolerance", "0.05mm"});
  EXPECT_THAT(result.out, HasSubstr("There are no seams.\n"));
  EXPECT_THAT(result.out, HasSubstr("    80.0  left - right\n"));
  const nlohmann::json near = nlohmann::json::parse(content_of("out/garment.json"))["near_borders"];
  ASSERT_EQ(near.size(), 1U);
  EXPECT_EQ(near[0]["patches"], (nlohmann::json{"left", "right"}));
  EXPECT_NEAR(near[0]["length"].get<double>(), 80.0, 1e-9);
  const std::string page = content_of("out/garment.html");
  EXPECT_THAT(page, HasSubstr("Borders lie beside each other along 80.0\u00A0mm without a seam."));
  EXPECT_THAT(page, HasSubstr("<li>left - right: 80.0\u00A0mm</li>"));
}

}  // namespace
}  // namespace planish::cli
