#include "product/product_file.h"

#include <filesystem>
#include <fstream>
#include <utility>

#include <planish/core/error.h>
#include <planish/io/read_mesh.h>
#include <planish/measure/material.h>
#include <planish/mesh/repair.h>

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "mesh/split.h"
#include "support/products.h"

namespace planish::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class ProductFileTest : public CliTest {
 protected:
  static void write(const std::string& content) { std::ofstream("suit.json") << content; }
  static ProductFile read(const std::string& content) {
    write(content);
    return read_product_file("suit.json");
  }
  /// What the reader says is wrong.
  static std::string refusal(const std::string& content) {
    try {
      read(content);
    } catch (const Error& error) {
      EXPECT_EQ(error.place().path, "suit.json");
      return error.message();
    }
    return "read";
  }
};

TEST_F(ProductFileTest, HasAllThatIsSaid) {
  const ProductFile product = read(R"({
    "pieces": [{"file": "parts/front.obj", "name": "Front", "material": "neoprene",
                "quantity": 2, "mirrored": true, "unit": "cm"},
               {"file": "back.obj"}],
    "seams": [{"name": "side", "between": ["Front", "back"]}]})");
  ASSERT_EQ(product.pieces.size(), 2U);
  const RequestedPiece& front = product.pieces[0];
  EXPECT_EQ(front.file, "parts/front.obj");
  EXPECT_EQ(front.name, "Front");
  EXPECT_EQ(front.material->name, "neoprene");
  EXPECT_EQ(front.quantity, 2);
  EXPECT_TRUE(front.mirrored);
  EXPECT_EQ(front.unit, Unit::cm);
  const RequestedPiece& back = product.pieces[1];
  EXPECT_FALSE(back.name || back.material || back.quantity || back.unit || back.mirrored);
  ASSERT_EQ(product.seams.size(), 1U);
  EXPECT_EQ(product.seams[0].name, "side");
  EXPECT_THAT(product.seams[0].between, ElementsAre("Front", "back"));
}

TEST_F(ProductFileTest, HasAPieceOfEachSize) {
  const ProductFile product = read(R"({
    "pieces": [{"name": "tip", "sizes": {"S": "tip-s.obj", "M": "tip-m.obj"}, "allowance": "8mm"},
               {"name": "band", "sizes": {"M": "band-m.obj"}}],
    "seams": [{"name": "edge", "between": ["tip", "band"]}]})");
  ASSERT_EQ(product.pieces.size(), 3U);
  EXPECT_THAT(product.sizes, testing::UnorderedElementsAre("S", "M"));
  for (const RequestedPiece& piece : product.pieces) {
    const std::string& size = product.sizes[piece.size];
    EXPECT_EQ(piece.name, piece.style + "-" + size);
    EXPECT_EQ(piece.settings.back().key, "size");
    EXPECT_EQ(piece.settings.back().value, size);
  }
  ASSERT_EQ(product.seams.size(), 1U) << "of size M alone";
  EXPECT_THAT(product.seams[0].between, ElementsAre("tip-M", "band-M"));
  EXPECT_THAT(refusal(R"({"pieces": [{"name": "a", "sizes": {}}]})"), HasSubstr("pieces[0].sizes"));
  EXPECT_THAT(refusal(R"({"pieces": [{"name": "a", "sizes": {"S": 3}}]})"), HasSubstr("sizes.S"));
  EXPECT_THAT(refusal(R"({"pieces": [{"sizes": {"S": "a.obj"}}]})"), HasSubstr("needs \"name\""));
  EXPECT_THAT(refusal(R"({"pieces": [{"name": "a", "file": "a.obj", "sizes": {"S": "a.obj"}}]})"),
              HasSubstr("both given"));
}

TEST_F(ProductFileTest, HasPathsRelativeToItself) {
  std::filesystem::create_directories("suits");
  std::ofstream("suits/suit.json") << R"({"pieces": [{"file": "front.obj"}]})";
  EXPECT_EQ(read_product_file("suits/suit.json").pieces[0].file, "suits/front.obj");
}

TEST_F(ProductFileTest, HasMaterialsOfTheirOwnFiles) {
  std::filesystem::create_directories("suits");
  std::ofstream("suits/suit.json") << R"({"pieces": [{"file": "a.obj", "material": "my.json"}]})";
  const auto figure = R"({"strain": 0.1, "source": "a test"})";
  std::ofstream("suits/my.json") << R"({"name": "suede", "stretch": {"usual": )" << figure
                                 << R"(}, "compression": {"usual": )" << figure << "}}";
  EXPECT_EQ(read_product_file("suits/suit.json").pieces[0].material->name, "suede");
  std::ofstream("suits/my.json") << "{}";
  try {
    read_product_file("suits/suit.json");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.place().path, "suits/my.json");
    EXPECT_EQ(error.message(), "needs \"name\"");
  }
}

TEST_F(ProductFileTest, NamesKeysThatAreNotKnownAndThoseThatAre) {
  EXPECT_THAT(refusal(R"({"pieces": [{"file": "a.obj", "matrial": "neoprene"}]})"),
              HasSubstr("pieces[0]: unknown key \"matrial\"; did you mean material?; known are "
                        "file, name, material, quantity, mirrored, unit, sizes, allowance, "));
  EXPECT_THAT(refusal(R"({"parts": []})"), HasSubstr("product: unknown key \"parts\""));
  EXPECT_THAT(refusal(R"({"pieces": [{"file": "a"}], "seams": [{"nam": "x"}]})"),
              HasSubstr("seams[0]: unknown key \"nam\""));
}

TEST_F(ProductFileTest, SaysWhereAValueCannotBe) {
  const auto piece = [](const std::string& rest) {
    return refusal(R"({"pieces": [{"file": "a.obj"}, {"file": "b.obj", )" + rest + "}]}");
  };
  EXPECT_THAT(piece(R"("unit": "ell")"), HasSubstr("pieces[1].unit: is \"ell\""));
  EXPECT_THAT(piece(R"("material": "wood")"), HasSubstr("pieces[1].material: is \"wood\""));
  for (const char* quantity : {"0", "-1", "1.5", "1000001", "\"2\"", "null"})
    EXPECT_THAT(piece("\"quantity\": " + std::string(quantity)), HasSubstr("whole number from 1"));
  EXPECT_THAT(piece(R"("mirrored": "no")"), HasSubstr("pieces[1].mirrored: must be true or false"));
  EXPECT_THAT(piece(R"("mirrored": true, "quantity": 3)"), HasSubstr("must be even"));
  EXPECT_THAT(piece(R"("name": "")"), HasSubstr("pieces[1].name: must be a text"));
}

TEST_F(ProductFileTest, RefusesWhatIsNoProduct) {
  for (const char* content : {"", "{", "[]", "3", "null"})
    EXPECT_NE(refusal(content), "read") << content;
  EXPECT_EQ(refusal("{\n \"pieces\": [,]}"), "is no JSON, from column 13 on");
  EXPECT_THAT(refusal("{}"), HasSubstr("at least one piece"));
  EXPECT_THAT(refusal(R"({"pieces": {}})"), HasSubstr("pieces: must be a list"));
  EXPECT_THAT(refusal(R"({"pieces": ["a.obj"]})"), HasSubstr("pieces[0]: must be an object"));
  EXPECT_THAT(refusal(R"({"pieces": [{"name": "Front"}]})"), HasSubstr("needs \"file\""));
  EXPECT_THAT(refusal(R"({"pieces": [{"file": "a", "name": "A"}, {"file": "b", "name": "A"}]})"),
              HasSubstr("pieces[1].name: \"A\" is already taken"));
  EXPECT_THAT(refusal(R"({"pieces": [{"file": "a"}], "seams": [{"name": "x", "between": ["A"]}]})"),
              HasSubstr("seams[0].between: must be the names of two pieces"));
  EXPECT_THROW(read_product_file("none.json"), Error);
}

/// A saddle in two strips, and a file that says what they are.
class ProductOfAFile : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    std::vector<NamedPatch> strips = in_strips(make_shape("saddle", 300), 2);
    write_mesh("one.obj", strips[0].mesh);
    write_mesh("two.obj", strips[1].mesh);
    std::ofstream("suit.json") << R"({
      "pieces": [{"file": "one.obj", "name": "Front", "material": "neoprene", "quantity": 4,
                  "mirrored": true},
                 {"file": "two.obj", "name": "Back"}],
      "seams": [{"name": "side", "between": ["Back", "Front"]},
                {"name": "other", "between": ["Back", "Front"]}]})";
  }

  static CliResult flatten(const Names& more = {}) {
    Names args = {"flatten", "suit.json", "-o", "out", "--pick", "3", "--formats", "svg"};
    args.insert(args.end(), more.begin(), more.end());
    return planish(args);
  }
};

TEST_F(ProductOfAFile, GetsNamesQuantitiesMaterialsAndSeams) {
  std::ofstream("suit.json") << R"({
      "pieces": [{"file": "one.obj", "name": "Front", "material": "neoprene", "quantity": 4,
                  "mirrored": true, "unit": "mm"},
                 {"file": "one.obj", "name": "Large", "unit": "cm"},
                 {"file": "two.obj", "name": "Back"}],
      "seams": [{"name": "side", "between": ["Back", "Front"]}]})";
  const CliResult result = planish({"flatten", "suit.json", "-o", "out", "--formats", "svg",
                                    "--max-strain", "90%", "--no-match-seams"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  const auto json = nlohmann::json::parse(content_of("out/garment.json"));
  const auto& pieces = json["patches"];
  ASSERT_EQ(pieces.size(), 4U);
  EXPECT_EQ(pieces[0]["name"], "Front");
  EXPECT_EQ(pieces[0]["quantity"], 2) << "the other two are mirrored";
  EXPECT_EQ(pieces[0]["material"], "neoprene");
  EXPECT_EQ(pieces[0]["unfold"]["limits"][0]["asked"],
            material_named("neoprene").stretch.usual.strain);
  EXPECT_EQ(pieces[1]["name"], "Front, mirrored");
  EXPECT_EQ(pieces[1]["twin"], nlohmann::json::parse(R"({"of": "Front", "mirrored": true})"));
  EXPECT_TRUE(pieces[2]["quantity"].is_null());
  EXPECT_EQ(pieces[2]["unfold"]["limits"][0]["asked"], 0.9) << "of the command line";
  EXPECT_NEAR(pieces[2]["unfold"]["width"], 10.0 * pieces[0]["unfold"]["width"].get<double>(),
              1e-6 * pieces[2]["unfold"]["width"].get<double>());
  ASSERT_EQ(json["seams"].size(), 1U);
  EXPECT_EQ(json["seams"][0]["name"], "side");
  const std::string pattern = content_of("out/Front/pattern.svg");
  EXPECT_THAT(pattern, HasSubstr("Front"));
  EXPECT_THAT(pattern, HasSubstr("neoprene"));
  EXPECT_THAT(content_of("out/garment.html"), HasSubstr("<small>side</small>"));
}

TEST_F(ProductOfAFile, DrawsSizesOverEachOther) {
  for (const auto& [size, scale] : {std::pair{"S", 1.0}, std::pair{"L", 1.25}}) {
    TriMesh mesh = make_shape("dome", 300);
    for (Vec3& p : mesh.positions)
      p = scale * p;
    write_mesh("tip-" + std::string(size) + ".obj", mesh);
  }
  std::ofstream("sizes.json") << R"({"pieces": [{"name": "tip", "allowance": "8mm",
    "sizes": {"S": "tip-S.obj", "L": "tip-L.obj"}}]})";
  const CliResult result = planish({"flatten", "sizes.json", "-o", "out", "--formats", "svg,dxf"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_TRUE(std::filesystem::exists("out/tip-S/pattern.svg"));
  EXPECT_TRUE(std::filesystem::exists("out/sizes-tip.dxf"));
  const std::string drawing = content_of("out/sizes-tip.svg");
  EXPECT_NE(drawing.find("id=\"S\""), std::string::npos);
  EXPECT_NE(drawing.find("id=\"L\""), std::string::npos);
  EXPECT_NE(content_of("out/tip-L/pattern.svg").find("size L"), std::string::npos);
  EXPECT_THAT(result.out, HasSubstr("no seams")) << "sizes are not sewn to each other";

  write_mesh("tip-L.obj", make_shape("saddle", 300));
  const CliResult other = planish({"flatten", "sizes.json", "-o", "out"});
  EXPECT_EQ(other.exit_code, k_exit_failed);
  EXPECT_THAT(other.err, HasSubstr("has other triangles than"));
}

TEST_F(ProductOfAFile, ResumesWhereTheFileSaysTheSame) {
  ASSERT_EQ(flatten().exit_code, k_exit_done);
  const CliResult again = flatten({"--resume"});
  EXPECT_THAT(again.err, HasSubstr("from the earlier run"));
  std::ofstream("suit.json")
      << R"({"pieces": [{"file": "one.obj", "name": "Front", "quantity": 3}]})";
  EXPECT_THAT(flatten({"--resume"}).err, testing::Not(HasSubstr("from the earlier run")));
}

TEST_F(ProductOfAFile, SaysWhichSeamIsNotThere) {
  const CliResult result = flatten();
  EXPECT_THAT(result.err, HasSubstr("seam \"other\": Back and Front share no border"));
  std::ofstream("suit.json") << R"({"pieces": [{"file": "one.obj", "name": "Front"}],
                                    "seams": [{"name": "side", "between": ["Front", "Bak"]}]})";
  const CliResult wrong = flatten();
  EXPECT_EQ(wrong.exit_code, k_exit_failed);
  EXPECT_THAT(wrong.err, HasSubstr("no piece is called \"Bak\""));
}

std::vector<std::string> names_of(const std::string& garment) {
  const nlohmann::json json = nlohmann::json::parse(content_of(garment));
  std::vector<std::string> names;
  for (const auto& patch : json["patches"])
    names.push_back(patch["name"]);
  return names;
}

TEST_F(ProductOfAFile, TakesPiecesByTheNamesThatItShows) {
  EXPECT_EQ(flatten({"--only", "Front"}).exit_code, k_exit_done);
  EXPECT_THAT(names_of("out/garment.json"), ElementsAre("Front", "Front, mirrored"));
  const CliResult mirrored = flatten({"--only", "Front, mirrored"});
  EXPECT_EQ(mirrored.exit_code, k_exit_done) << mirrored.err;
  EXPECT_THAT(mirrored.err,
              HasSubstr("without the seams to pieces that are left out: side, other"));
  EXPECT_THAT(names_of("out/garment.json"), ElementsAre("Front, mirrored"));
  EXPECT_EQ(flatten({"--without", "Front, mirrored,Back"}).exit_code, k_exit_done);
  EXPECT_THAT(names_of("out/garment.json"), ElementsAre("Front"));
  EXPECT_EQ(flatten({"--without", "Front, mirrored"}).exit_code, k_exit_done);
  EXPECT_THAT(names_of("out/garment.json"), ElementsAre("Front", "Back"));
  EXPECT_EQ(nlohmann::json::parse(content_of("out/garment.json"))["seams"][0]["name"], "side");
  const CliResult wrong = flatten({"--only", "Frnt"});
  EXPECT_EQ(wrong.exit_code, k_exit_usage);
  EXPECT_THAT(wrong.err, HasSubstr("there are Front, Back, Front, mirrored"));
}

TEST_F(ProductOfAFile, TakesPiecesOfAFileThatHasNamesOfItsOwn) {
  write_product("one.obj", in_strips(make_shape("saddle", 300), 2));
  std::ofstream("suit.json") << R"({
      "pieces": [{"file": "one.obj", "name": "Front", "mirrored": true},
                 {"file": "two.obj", "name": "Back"}]})";
  EXPECT_EQ(flatten({"--only", "Front-2"}).exit_code, k_exit_done);
  EXPECT_THAT(names_of("out/garment.json"), ElementsAre("Front-2", "Front-2, mirrored"));
  EXPECT_EQ(flatten({"--only", "Front", "--without", "Front-1"}).exit_code, k_exit_done);
  EXPECT_THAT(names_of("out/garment.json"), ElementsAre("Front-2", "Front-2, mirrored"));
  EXPECT_EQ(flatten({"--only", "strip-1"}).exit_code, k_exit_done);
  EXPECT_THAT(names_of("out/garment.json"), ElementsAre("Front-1", "Front-1, mirrored"));
  // In the file strip-2, in the product the name of the other piece.
  std::ofstream("suit.json") << R"({
      "pieces": [{"file": "one.obj", "name": "Front"}, {"file": "two.obj", "name": "strip-2"}]})";
  for (const char* flag : {"--only", "--without"}) {
    const CliResult either = flatten({flag, "strip-2"});
    EXPECT_EQ(either.exit_code, k_exit_usage);
    EXPECT_THAT(either.err,
                HasSubstr("\"strip-2\" could mean strip-2 of two.obj or Front-2 of one.obj"));
  }
}

/// A mirror image of what is inside out would be the same piece once more.
TEST_F(ProductOfAFile, TurnsTheMirrorImageWithItsPiece) {
  std::vector<NamedPatch> strips = in_strips(make_shape("saddle", 300), 3);
  write_mesh("large.obj", strips[0].mesh);
  write_mesh("one.obj", turned_over(strips[1].mesh));
  write_mesh("more.obj", strips[2].mesh);
  std::ofstream("suit.json") << R"({
      "pieces": [{"file": "large.obj"}, {"file": "one.obj", "name": "Front", "mirrored": true},
                 {"file": "more.obj"}]})";
  for (const Names& only :
       {Names{}, Names{"--only", "Front"}, Names{"--only", "Front, mirrored"}}) {
    const CliResult result = flatten(only);
    EXPECT_THAT(result.err, HasSubstr("turned over, as they were inside out against a neighbour "
                                      "along a seam: Front against "));
    const TriMesh mirrored = read_mesh("out/Front__mirrored/processed.obj").mesh;
    EXPECT_EQ(mirrored.triangles, turned_over(strips[1].mesh).triangles) << only.size();
  }
}

TEST_F(ProductOfAFile, TakesTheSecondPieceOfAName) {
  std::filesystem::create_directory("other");
  std::vector<NamedPatch> strips = in_strips(make_shape("saddle", 300), 2);
  write_mesh("other/one.obj", strips[1].mesh);
  const auto names = [](const Names& flags) {
    Names args = {"flatten", "one.obj", "other/one.obj", "--product",
                  "-o",      "out",     "--formats",     "svg"};
    args.insert(args.end(), flags.begin(), flags.end());
    const CliResult result = planish(args);
    EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
    return std::filesystem::exists("out/garment.json")
               ? names_of("out/garment.json")
               : std::vector<std::string>{
                     nlohmann::json::parse(content_of("out/report.json"))["name"]};
  };
  EXPECT_THAT(names({"--only", "one-2"}), ElementsAre("one-2"));
  std::filesystem::remove_all("out");
  EXPECT_THAT(names({"--without", "one-2"}), ElementsAre("one"));
  std::filesystem::remove_all("out");
  EXPECT_THAT(names({"--only", "one"}), ElementsAre("one", "one-2"));
  EXPECT_EQ(planish({"flatten", "one.obj", "other/one.obj", "--product", "-o", "more", "--only",
                     "one-2", "--resume"})
                .exit_code,
            k_exit_usage);
}

TEST_F(ProductOfAFile, GoesOnWhereAFileIsMissing) {
  std::filesystem::remove("two.obj");
  const CliResult result = flatten();
  EXPECT_EQ(result.exit_code, k_exit_failed);
  EXPECT_THAT(result.err, HasSubstr("1 of 3 patches could not be flattened: Back"));
  EXPECT_TRUE(std::filesystem::exists("out/Front/pattern.svg"));
}

TEST_F(ProductOfAFile, RefusesNotchesOnSeamsOfMirroredPieces) {
  std::ofstream("seams.txt") << "* 50%\n";
  const CliResult result = flatten({"--seam-notches", "seams.txt"});
  EXPECT_EQ(result.exit_code, k_exit_usage);
  EXPECT_THAT(result.err, HasSubstr("\"mirrored\""));
}

}  // namespace
}  // namespace planish::cli
