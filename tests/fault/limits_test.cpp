#include "cli/cli_run.h"
#include "fault/child.h"
#include "fault/hard_files.h"
#include "support/ringed_disk.h"

// Files of one megabyte take at most one gigabyte and ten seconds before they are accepted or
// refused. A method that is quadratic in some size would take many times that.

namespace planish::cli {
namespace {

namespace fs = std::filesystem;
using fault::Limits;
using fault::Text;
using fault::told;

constexpr std::size_t k_megabyte = 1'000'000;

Limits limits() {
  return {.memory = fault::can_limit_memory() ? 1000 * k_megabyte : 0, .cpu_seconds = 10};
}

class LimitsTest : public CliTest {
 protected:
  static void expect_answered(const Names& args, const std::string& what) {
    const auto ended = fault::run_program(args, limits());
    // Also a word in an option file that is unknown is a usage error.
    EXPECT_TRUE(ended.exit_code == k_exit_done || ended.exit_code == k_exit_failed ||
                ended.exit_code == k_exit_usage)
        << what << ": " << told(ended);
    EXPECT_EQ(ended.err.find("memory"), std::string::npos) << what << ": " << told(ended);
    EXPECT_EQ(ended.err.find("internal"), std::string::npos) << what << ": " << told(ended);
  }

  static void expect_answered(const std::vector<fault::HardFile>& hard) {
    for (const fault::HardFile& file : hard) {
      ASSERT_LT(file.content.size(), 2 * k_megabyte) << file.name;
      std::ofstream(file.name, std::ios::binary) << file.content;
      expect_answered({"measure", file.name, "--threads", "2"}, file.name);
      fs::remove(file.name);
    }
  }

  /// An option file of one megabyte.
  static void put_option(const std::function<void(Text&, std::size_t)>& add_line) {
    std::ofstream("option.txt") << fault::lines(k_megabyte, "", add_line);
  }

  static void expect_option_answered(const Names& args, const std::string& what) {
    Names all = args;
    all.insert(all.end(), {"option.txt", "--threads", "2"});
    expect_answered(all, args.back() + " with " + what);
  }
};

TEST_F(LimitsTest, OfHardObjFiles) {
  expect_answered(fault::hard_obj_files(k_megabyte));
}

TEST_F(LimitsTest, OfHardStlFiles) {
  expect_answered(fault::hard_stl_files(k_megabyte));
}

TEST_F(LimitsTest, OfHardPlyAndOffFiles) {
  expect_answered(fault::hard_ply_and_off_files(k_megabyte));
}

/// Those that lead where work could grow with the square of the size: many at one vertex, edge or
/// place, many pieces or names.
bool may_be_quadratic(const std::string& name) {
  const std::vector<std::string> names = {
      "hub.obj",         "one_edge.obj",    "many_fans.obj",  "many_pieces.obj",
      "equal_faces.obj", "groups.obj",      "one_place.obj",  "stl_nearly_one_place.stl",
      "materials.obj",   "one_polygon.obj", "properties.ply", "long_polygon.off"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<fault::HardFile> all_hard_files(std::size_t bytes) {
  std::vector<fault::HardFile> files = fault::hard_obj_files(bytes);
  for (auto* more : {&fault::hard_stl_files, &fault::hard_ply_and_off_files}) {
    for (fault::HardFile& file : (*more)(bytes))
      files.push_back(std::move(file));
  }
  return files;
}

/// What reading, checking, measuring and writing a file takes above what starting the program
/// takes. Not by `measure`, which also lays the patch flat, with a factorization in more than
/// linear time.
double instructions_without_solves(const fault::HardFile& file, std::uint64_t start) {
  std::ofstream(file.name, std::ios::binary) << file.content;
  const std::uint64_t all = fault::instructions_of(
      {"evolve", file.name, "-o", "out.obj", "--sweeps", "0", "--threads", "1"});
  EXPECT_GT(all, start) << file.name;
  return static_cast<double>(all) - static_cast<double>(start);
}

// All of them with PLANISH_LONG_TESTS=1.
TEST_F(LimitsTest, WorkDoublesWithTheFile) {
  constexpr std::size_t bytes = 25'000;
  constexpr double most = 2.6;  // n log n is 2.1 there, n^2 is 4
  const bool every = std::getenv("PLANISH_LONG_TESTS") != nullptr;
  const std::uint64_t start = fault::instructions_of({"--version"});
  ASSERT_GT(start, 100'000U)
      << "the program could not be run under valgrind, which scripts/test installs";
  const auto once = all_hard_files(bytes), twice = all_hard_files(2 * bytes);
  std::size_t compared = 0;
  for (std::size_t k = 0; k < once.size(); ++k) {
    if (!every && !may_be_quadratic(once[k].name)) continue;
    const double first = instructions_without_solves(once[k], start);
    const double second = instructions_without_solves(twice[k], start);
    std::cout << once[k].name << ": " << first << " instructions, twice the size " << second / first
              << " times as many\n";
    // What is refused at once is not to be compared.
    if (first < 1e6) continue;
    ++compared;
    EXPECT_LT(second, most * first) << once[k].name;
  }
  EXPECT_GE(compared, 10U);
}

// Once to see whether the file is sound, once by its numbers and once by those of the sweeps.
// Everything else takes the patch that has it, the report's pages too.
TEST_F(LimitsTest, FlattenFindsTopologyOnceForEachNumbering) {
  ASSERT_EQ(fault::run_program({"sample", "panel", "--vertices", "300", "-o", "p.obj"}).exit_code,
            0);
  const Names flatten = {"flatten", "p.obj", "-o", "out", "--pick", "5", "--threads", "1"};
  EXPECT_EQ(fault::calls_of("planish::build_rings(", flatten), 3U);
  EXPECT_EQ(fault::calls_of("planish::inspect_manifold(", flatten), 2U);
}

const Names k_evolve = {"evolve", "panel.obj", "-o", "o.obj", "--method", "fairing"};
const Names k_unfold = {"unfold", "panel.obj", "-o", "o.svg", "--allowance", "10mm"};

Names with(Names args, const std::string& flag) {
  args.push_back(flag);
  return args;
}

TEST_F(LimitsTest, OfHardOptionFiles) {
  for (const auto& [what, add_line] :
       std::vector<std::pair<std::string, std::function<void(Text&, std::size_t)>>>{
           {"ends of the mesh",
            [](Text&t, std::size_t k) { t.add(k % 2 == 0 ? "0 299\n" : "1 298\n"); }},
           {"one number", [](Text&t, std::size_t) { t.add("150\n"); }},
           {"all numbers", [](Text&t, std::size_t k) { t.add(k % 300, '\n'); }},
           {"pairs", [](Text&t, std::size_t k) { t.add(k % 300, ' ', k * 7 % 300, '\n'); }},
           {"one line", [](Text&t, std::size_t k) { t.add(k * 7 % 300, ' '); }},
           {"shares", [](Text&t, std::size_t k) { t.add("0.", k % 1000, " slit\n"); }},
           {"marks", [](Text&t, std::size_t k) { t.add(k % 300, " drill\n"); }},
           {"seams", [](Text&t, std::size_t k) { t.add("* 0.", 1 + k % 9, " v\n"); }},
           {"stretches", [](Text&t, std::size_t k) { t.add(k % 60, ' ', k * 7 % 60, " 3\n"); }},
           {"comments", [](Text&t, std::size_t) { t.add("#\n"); }}}) {
    put_option(add_line);
    for (const std::string flag : {"--fix", "--cut"})
      expect_option_answered(with(k_evolve, flag), what);
    for (const std::string flag :
         {"--notches", "--marks", "--inner-lines", "--edge-allowances", "--seam-notches"})
      expect_option_answered(with(k_unfold, flag), what);
    expect_option_answered(
        {"evolve", "panel.obj", "-o", "o.obj", "--method", "local_perturbation", "--weights"},
        what);
  }
}

TEST_F(LimitsTest, OfHardDrawings) {
  std::ofstream("lines.obj") << fault::lines(k_megabyte, "", [](Text& t, std::size_t k) {
    t.add("v ", k % 2 == 0 ? -300 : 300, ' ', k * 37 % 400, " 0\n");
    if (k > 0) t.add("l ", k, ' ', k + 1, '\n');
  });
  for (const std::string flag : {"--fix", "--cut"}) {
    Names args = with(k_evolve, flag);
    args.push_back("lines.obj");
    expect_answered(args, flag + " with a drawing");
  }
}

TEST_F(LimitsTest, OfHardObstacles) {
  const Names args = {"evolve",   "panel.obj", "-o",
                      "o.obj",    "--method",  "local_perturbation",
                      "--sweeps", "1",         "--obstacle"};
  for (const fault::HardFile& file : fault::hard_obj_files(k_megabyte)) {
    std::ofstream(file.name, std::ios::binary) << file.content;
    expect_answered(with(args, file.name), "--obstacle " + file.name);
    fs::remove(file.name);
  }
}

TEST_F(LimitsTest, OfHubsWithManyNeighbours) {
  // Twenty thousand at one vertex, in two rings, as a file of somewhat more than a megabyte.
  write_mesh("hub.obj", meshes::ringed_disk(20'000, 2, [](double r, double) { return 0.01 * r; }));
  const Limits four = {.memory = fault::can_limit_memory() ? 4000 * k_megabyte : 0,
                       .cpu_seconds = 60};
  const auto run = [&](Names args) {
    args.insert(args.end(), {"--threads", "2"});
    return fault::run_program(args, four);
  };
  for (const Names& args :
       {Names{"measure", "hub.obj"}, Names{"unfold", "hub.obj", "-o", "o.svg"}}) {
    const auto ended = run(args);
    EXPECT_EQ(ended.exit_code, k_exit_done) << args.front() << ": " << told(ended);
  }
  for (const std::string method :
       {"auto", "classical", "controllable", "least_norm", "flattenable_laplacian", "local_offset",
        "global_penalty", "local_perturbation", "fairing"}) {
    const auto ended =
        run({"evolve", "hub.obj", "-o", "o.obj", "--sweeps", "1", "--json", "--method", method});
    const bool refused = method == "auto" || method == "least_norm";
    EXPECT_EQ(ended.exit_code, refused ? k_exit_failed : k_exit_done)
        << method << ": " << told(ended);
    if (refused) {
      EXPECT_EQ(nlohmann::json::parse(ended.out)["error"]["code"], "too_large") << method;
    }
  }
}

}  // namespace
}  // namespace planish::cli
