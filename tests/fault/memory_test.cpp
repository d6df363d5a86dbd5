#include <cstdlib>
#include <cstring>
#include <iostream>
#include <ostream>
#include <set>
#include <streambuf>
#include <utility>

#include <sys/mman.h>
#include <sys/wait.h>

#include "cli/cli_run.h"
#include "fault/child.h"
#include "fault/failing_memory.h"
#include "support/products.h"

// Verbs whose memory ends. Each run is a process of its own, forked, so that one that is ended by
// the system or hangs is told like any other.

namespace planish::cli {
namespace {

namespace fs = std::filesystem;
using fault::Ending;
using fault::Files;

constexpr std::size_t k_text = 4096, k_most_places = 30'000;
constexpr unsigned k_patience = 60;  // seconds after which a run counts as hung
const char* const k_old = "as it was";

/// What a child hands to its parent.
struct Shared {
  std::size_t allocations, places;
  std::array<std::size_t, k_most_places> first_of_place;
  std::array<char, k_text> out, err;
};

/// Keeps the beginning of what is written to it, and allocates nothing.
class Beginning : public std::streambuf {
 public:
  explicit Beginning(std::array<char, k_text>& text) {
    setp(text.data(), text.data() + k_text - 1);
  }

 protected:
  int overflow(int c) override { return traits_type::not_eof(c); }
  std::streamsize xsputn(const char* text, std::streamsize count) override {
    const auto kept = std::min<std::streamsize>(count, epptr() - pptr());
    std::memcpy(pptr(), text, static_cast<std::size_t>(kept));
    pbump(static_cast<int>(kept));
    return count;
  }
};

/// Times differ from run to run, and hashes of files that tell times: then a file must end as it
/// should, and nearly be as long.
/// @param of_parts what is told of several patches or methods, of which some may have failed, may
/// have any length
bool is_whole(const std::string& name, const std::string& content, const std::string& expected,
              bool of_parts) {
  if (content == expected) return true;
  const auto is_one_of = [&](std::initializer_list<const char*> parts) {
    return std::any_of(parts.begin(), parts.end(),
                       [&](const char* part) { return name.find(part) != std::string::npos; });
  };
  const std::size_t end = is_one_of({".csv"}) ? 1 : std::min<std::size_t>(3, expected.size());
  const std::size_t room = 40 + expected.size() / 20;
  const bool is_about_as_long =
      content.size() + room >= expected.size() && content.size() <= expected.size() + room;
  return content.ends_with(expected.substr(expected.size() - end)) &&
         ((of_parts && is_one_of({"out/garment.", "out/layout.", "out/compare.", "out."})) ||
          (is_about_as_long && is_one_of({".html", ".json", ".csv"})));
}

class Memory : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    write_mesh("panel.obj", make_shape("panel", 150));
    void* const page =
        mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    ASSERT_NE(page, MAP_FAILED);
    shared_ = static_cast<Shared*>(page);
  }
  void TearDown() override {
    munmap(shared_, sizeof(Shared));
    CliTest::TearDown();
  }

  /// Fails the allocations of a run in turn, and checks after each that the run ended with "out of
  /// memory" and left all as it was; or could do without, and all is there.
  /// @param most that many runs, unless all are asked for
  /// @param done exit code of a run with enough memory
  void fail_in_turn(const Names& args, std::size_t most, int done = k_exit_done) {
    args_ = args;
    done_ = done;
    inputs_ = fault::contents(".");
    count_places();
    ASSERT_EQ(ended_.exit_code, done_) << fault::told(ended_);
    const std::size_t allocations = shared_->allocations, places = shared_->places;
    whole_ = fault::contents(".");
    put_old_files();
    const std::vector<std::size_t> numbers = numbers_to_fail(most);
    for (const std::size_t n : numbers)
      fail_at(n, Ending::once);
    for (std::size_t k = 0; k < 8; ++k)
      fail_at(1 + k * k * k * allocations / 512, Ending::for_good);
    std::cout << args.front() << ": " << allocations << " allocations from " << places
              << " places, failed " << numbers.size() << "\n";
  }

 private:
  template <class Prepare>
  void run_in_child(const Prepare& prepare) {
    shared_->out = shared_->err = {};
    const pid_t child = fork();
    if (child == 0) {
      alarm(k_patience);
      Beginning out_text(shared_->out), err_text(shared_->err);
      std::ostream out(&out_text), err(&err_text);
      prepare();
      const int code = run(args_, out, err);
      shared_->allocations = fault::let_memory_last();
      shared_->places = fault::places_noted();
      _exit(code);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ended_ = {};
    if (WIFEXITED(status)) ended_.exit_code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) ended_.signal = WTERMSIG(status);
    ended_.out = shared_->out.data();
    ended_.err = shared_->err.data();
  }

  void count_places() {
    run_in_child([&] { fault::note_places(shared_->first_of_place); });
  }

  /// The first from every place, if they are too many some of them, and some of all.
  std::vector<std::size_t> numbers_to_fail(std::size_t most) const {
    const std::size_t all = shared_->allocations;
    std::set<std::size_t> numbers;
    if (std::getenv("PLANISH_LONG_TESTS") != nullptr) {
      for (std::size_t n = 1; n <= all; ++n)
        numbers.insert(n);
    } else {
      const auto spread = [most](std::size_t k, std::size_t count) {
        return count <= most ? k : k * count / most;
      };
      for (std::size_t k = 0; k < std::min(most, shared_->places); ++k)
        numbers.insert(shared_->first_of_place[spread(k, shared_->places)]);
      for (std::size_t k = 0; k < most / 4; ++k)
        numbers.insert(1 + k * 2'654'435'761U % all);
    }
    return {numbers.begin(), numbers.end()};
  }

  void put_old_files() {
    for (const auto& [name, content] : whole_) {
      if (name.back() != '/' && !inputs_.contains(name)) std::ofstream(name) << k_old;
    }
    before_ = fault::contents(".");
  }

  void fail_at(std::size_t n, Ending ending) {
    run_in_child([&] { fault::let_memory_end(n, ending); });
    const std::string at = args_.front() + " without allocation " + std::to_string(n) +
                           (ending == Ending::once ? ": " : " and all that follow: ") +
                           fault::told(ended_);
    const bool told = ended_.err.find("out of memory") != std::string::npos ||
                      ended_.out.find("out of memory") != std::string::npos;
    const bool done = ended_.exit_code == done_;
    EXPECT_TRUE(done || (ended_.exit_code == k_exit_failed && told)) << at;
    const Files after = fault::contents(".");
    if (after == before_ && !done) return;
    const bool in_parts = fs::exists("out/garment.json");
    const bool of_parts = in_parts || args_.front() == "compare" || args_.front() == "frontier";
    for (const auto& [name, content] : after) {
      ASSERT_TRUE(before_.contains(name)) << at << " left " << name;
      if (content == before_.at(name)) {
        EXPECT_TRUE(!done || told || inputs_.contains(name) || name.back() == '/') << at << name;
      } else {
        EXPECT_TRUE(done || in_parts) << at << " wrote " << name;
        EXPECT_TRUE(is_whole(name, content, whole_.at(name), of_parts))
            << at << " wrote half of " << name;
      }
    }
    EXPECT_EQ(after.size(), before_.size()) << at;
    put_old_files();
  }

  Shared* shared_ = nullptr;
  Names args_;
  int done_ = k_exit_done;  ///< exit code with enough memory
  fault::Ended ended_;
  Files inputs_, whole_, before_;
};

TEST_F(Memory, EndsWhileMeasuring) {
  fail_in_turn(
      {"measure", "panel.obj", "--json", "--map", "m.csv", "--picture", "m.svg", "--threads", "1"},
      200);
}

TEST_F(Memory, EndsWhileEvolving) {
  fail_in_turn({"evolve", "panel.obj", "-o", "out.ply", "--sweeps", "2", "--history", "h.csv",
                "--threads", "1"},
               100);
}

TEST_F(Memory, EndsWhileEvolvingByEachMethod) {
  for (const std::string method :
       {"auto", "classical", "least_norm", "flattenable_laplacian", "local_offset",
        "global_penalty", "local_perturbation", "fairing"}) {
    fail_in_turn({"evolve", "panel.obj", "-o", "out.obj", "--method", method, "--sweeps", "2",
                  "--json", "--threads", "1"},
                 60);
  }
}

TEST_F(Memory, EndsInThreadsOfAMethod) {
  for (const std::string method : {"auto", "controllable", "least_norm"}) {
    fail_in_turn({"evolve", "panel.obj", "-o", "out.obj", "--method", method, "--sweeps", "1",
                  "--threads", "4"},
                 80);
  }
}

TEST_F(Memory, EndsWhileTakingVerticesOut) {
  write_mesh("panel.obj", make_shape("panel", 150));
  fail_in_turn({"evolve", "panel.obj", "-o", "out.stl", "--remesh", "--sweeps", "1"}, 60);
}

TEST_F(Memory, EndsWhileUnfolding) {
  for (const std::string output : {"out.svg", "out.dxf", "out.pdf", "out.plt", "out.off"}) {
    fail_in_turn({"unfold", "panel.obj", "-o", output}, 60);
  }
  fail_in_turn({"unfold", "panel.obj", "-o", "out.pdf", "--paper", "a4", "--match-seams"}, 100);
}

TEST_F(Memory, EndsWhileFlattening) {
  std::ofstream("marks.txt") << "20 cross\n30 drill\n";
  std::ofstream("notches.txt") << "0.25 v\n60% slit double\n";
  fail_in_turn({"flatten",      "panel.obj", "-o",        "out",         "--method",
                "controllable", "--sweeps",  "1",         "--formats",   "svg,dxf,pdf,plt",
                "--textured",   "--history", "h.csv",     "--allowance", "10mm",
                "--marks",      "marks.txt", "--notches", "notches.txt", "--grain",
                "0,0,1",        "--sheet",   "1m",        "--threads",   "1",
                "--json"},
               150);
}

TEST_F(Memory, EndsWhileFlatteningOnThreads) {
  fail_in_turn({"flatten", "panel.obj", "-o", "out", "--sweeps", "3", "--threads", "4"}, 60);
}

TEST_F(Memory, EndsWhileFlatteningAProduct) {
  write_product("product.obj", in_strips(make_shape("panel", 150), 3));
  std::ofstream("notches.txt") << "* 50%\n";
  for (const std::string threads : {"1", "3"}) {
    fail_in_turn({"flatten", "product.obj", "-o", "out", "--method", "controllable", "--sweeps",
                  "1", "--sheet", "1500mm", "--turn", "none", "--seam-notches", "notches.txt",
                  "--threads", threads},
                 10, k_exit_target_missed);
  }
}

TEST_F(Memory, EndsWhileCuttingOpen) {
  std::ofstream("cuts.txt") << "0 75\n";
  fail_in_turn({"unfold", "panel.obj", "-o", "out.svg", "--cut", "cuts.txt", "--json"}, 60);
}

TEST_F(Memory, EndsWhileComparing) {
  fail_in_turn({"compare", "panel.obj", "-o", "out", "--methods", "fairing,classical", "--json",
                "--threads", "1"},
               20);
}

TEST_F(Memory, EndsWhileDrawingAFrontier) {
  write_mesh("panel.obj", make_shape("panel", 100));
  for (const std::string output : {"out.html", "out.svg"}) {
    fail_in_turn({"frontier", "panel.obj", "-o", output, "--methods", "fairing", "--threads", "1"},
                 20);
  }
}

TEST_F(Memory, EndsWhileSuggestingCuts) {
  fail_in_turn({"suggest-cuts", "panel.obj", "-o", "cuts.txt", "--picture", "cuts.svg", "--apply",
                "cut.obj", "--max-cuts", "1", "--json"},
               60);
}

TEST_F(Memory, EndsWhileConverting) {
  write_mesh("in.ply", make_shape("panel", 150));
  write_mesh("in.stl", make_shape("panel", 150));
  write_mesh("in.off", make_shape("panel", 150));
  for (const auto& [input, output] : {std::pair{"panel.obj", "out.ply"},
                                      {"in.ply", "out.stl"},
                                      {"in.stl", "out.off"},
                                      {"in.off", "out.obj"}}) {
    fail_in_turn({"convert", input, output}, 100);
  }
}

TEST_F(Memory, EndsWhileMakingASample) {
  fail_in_turn({"sample", "dome", "--vertices", "500", "-o", "out.obj", "--json"}, 200);
  fail_in_turn({"sample", "--list", "--json"}, 200);
}

TEST_F(Memory, EndsWhileHelping) {
  fail_in_turn({"flatten", "--help"}, 200);
  fail_in_turn({"--version", "--json"}, 200);
}

}  // namespace
}  // namespace planish::cli
