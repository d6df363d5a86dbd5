#include <chrono>
#include <csignal>
#include <thread>

#include "cli/cli_run.h"
#include "fault/child.h"
#include "support/products.h"

// The program is ended from outside at many moments of its run.

namespace planish::cli {
namespace {

namespace fs = std::filesystem;
using fault::run_program;
using fault::Running;
using fault::told;
using Clock = std::chrono::steady_clock;
using fault::Files;

const char* const k_partial = ".planish-partial-";

/// A job, and what it writes.
struct Job {
  Names args;
  std::string folder;           ///< of its outputs
  int exit_code = k_exit_done;  ///< of an uninterrupted run
};

class Kills : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    write_mesh("panel.obj", make_shape("panel", 150));
    write_product("product.obj", in_strips(make_shape("panel", 150), 4));
    fs::create_directory("one");
  }

  static std::vector<Job> jobs() {
    return {{{"flatten", "panel.obj", "-o", "out", "--method", "controllable", "--sweeps", "3",
              "--formats", "svg,dxf,pdf,plt"},
             "out"},
            {{"evolve", "panel.obj", "-o", "one/o.ply", "--sweeps", "20", "--history", "one/h.csv"},
             "one"},
            {{"flatten", "product.obj", "-o", "parts", "--method", "controllable", "--sweeps", "3",
              "--resume"},
             "parts",
             k_exit_target_missed}};
  }

  /// The files below a folder that are not of a run that was killed.
  static Files results_in(const std::string& folder) {
    if (!fs::exists(folder)) return {};
    Files found = fault::contents(folder);
    std::erase_if(found,
                  [](const auto& file) { return file.first.find(k_partial) != std::string::npos; });
    return found;
  }

  /// A file is whole if it ends as it should. Those that tell times differ in length.
  static void expect_whole(const std::string& name, const std::string& content,
                           const Files& expected) {
    ASSERT_TRUE(expected.contains(name)) << name;
    const std::string& right = expected.at(name);
    const bool tells_times =
        name.ends_with(".html") || name.ends_with(".json") || name.ends_with(".csv");
    if (!tells_times) {
      EXPECT_EQ(content, right) << name;
    } else {
      ASSERT_FALSE(content.empty()) << name;
      EXPECT_TRUE(content.ends_with(right.substr(right.size() - 3))) << name;
      if (name.ends_with(".json")) {
        EXPECT_TRUE(nlohmann::json::accept(content)) << name;
      }
    }
  }

  /// Runs each job and ends it after a longer time each time, from the first moment to the last.
  void end_by(int signal, int times) {
    const std::string inputs = content_of("panel.obj") + content_of("product.obj");
    for (const Job& job : jobs()) {
      const auto begin = Clock::now();
      const auto whole = run_program(job.args);
      const auto took = Clock::now() - begin;
      ASSERT_EQ(whole.exit_code, job.exit_code) << told(whole);
      const Files expected = results_in(job.folder);
      int ended_by_it = 0;
      for (int k = 0; k < times; ++k) {
        if (k % 2 == 0) fs::remove_all(job.folder);  // else over what is there
        Running running(job.args);
        std::this_thread::sleep_for(took * (k + 1) / times);
        running.send(signal);
        const auto ended = running.wait();
        ended_by_it += ended.exit_code == job.exit_code ? 0 : 1;
        // Before the program listens the system ends it, which shells call 128 + 2 as well.
        EXPECT_TRUE(ended.exit_code == job.exit_code || ended.signal == signal ||
                    (signal != SIGKILL && ended.exit_code == k_exit_interrupted))
            << job.args.front() << ": " << told(ended);
        EXPECT_EQ(content_of("panel.obj") + content_of("product.obj"), inputs);
        for (const auto& [name, content] : results_in(job.folder)) {
          if (name.back() != '/') expect_whole(name, content, expected);
        }
        if (signal != SIGKILL && ended.signal == 0) expect_no_partial_files(job.folder);
      }
      EXPECT_GT(ended_by_it, 0) << job.args.front();
      const auto again = run_program(job.args);
      EXPECT_EQ(again.exit_code, job.exit_code) << told(again);
      EXPECT_EQ(results_in(job.folder).size(), expected.size());
      for (const auto& [name, content] : results_in(job.folder)) {
        if (name.back() != '/') expect_whole(name, content, expected);
      }
      std::cout << job.args.front() << ": signal " << signal << ", " << times << " times, "
                << ended_by_it << " before the end\n";
    }
  }

  static void expect_no_partial_files(const std::string& folder) {
    if (!fs::exists(folder)) return;
    for (const auto& [name, content] : fault::contents(folder))
      EXPECT_EQ(name.find(k_partial), std::string::npos) << name;
  }
};

TEST_F(Kills, ByTheSystemLeaveNoHalfFile) {
  end_by(SIGKILL, 30);
}

TEST_F(Kills, ByCtrlCEndWith130AndLeaveNothingHalf) {
  end_by(SIGINT, 20);
}

TEST_F(Kills, ByRequestEndAsByCtrlC) {
  end_by(SIGTERM, 5);
}

TEST_F(Kills, InTheMidstOfReplacingLeaveOldOrNew) {
  // The file that is written is the one that is read.
  const std::string before = content_of("panel.obj");
  const Names args = {"evolve", "panel.obj", "-o", "panel.obj", "--sweeps", "2"};
  const auto begin = Clock::now();
  ASSERT_EQ(run_program(args).exit_code, k_exit_done);
  const auto took = Clock::now() - begin;
  const std::string after = content_of("panel.obj");
  ASSERT_NE(before, after);
  for (int k = 0; k < 30; ++k) {
    std::ofstream("panel.obj", std::ios::binary) << before;
    Running running(args);
    std::this_thread::sleep_for(took * (k + 15) / 45);
    running.send(SIGKILL);
    running.wait();
    const std::string found = content_of("panel.obj");
    EXPECT_TRUE(found == before || found == after) << found.size();
  }
}

TEST_F(Kills, LeaveFilesOfAKnownNameThatTheNextRunPassesOver) {
  fs::create_directory("in");
  write_mesh("in/a.obj", make_shape("panel", 100));
  std::ofstream("in/b.obj.planish-partial-1-0") << "v 0 0";
  const auto ended = run_program({"flatten", "in", "-o", "out"});
  EXPECT_EQ(ended.exit_code, k_exit_done) << told(ended);
  EXPECT_EQ(content_of("in/b.obj.planish-partial-1-0"), "v 0 0");
}

}  // namespace
}  // namespace planish::cli
