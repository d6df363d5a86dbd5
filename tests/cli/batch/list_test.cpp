// flatten --inputs: many inputs one by one, in shards, kept of earlier runs, and collected.

#include <algorithm>
#include <atomic>
#include <set>
#include <sstream>

#include <gmock/gmock.h>

#include "batch/input_list.h"
#include "cli/batch/csv_table.h"
#include "cli/cli_run.h"
#include "support/meshes.h"
#include "support/products.h"

namespace planish::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// The records that a run printed.
std::vector<nlohmann::json> records_in(const std::string& text) {
  std::vector<nlohmann::json> records;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    records.push_back(nlohmann::json::parse(line, nullptr, false));
    EXPECT_TRUE(records.back().is_object()) << line;
  }
  return records;
}

Names run_of_list(const std::string& folder, const Names& more = {}) {
  Names args = {"flatten", "--inputs", "list.txt", "-o", folder, "--no-report", "--formats", "svg"};
  args.insert(args.end(), more.begin(), more.end());
  return args;
}

class Lists : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    std::filesystem::create_directory("in");
    for (const char* shape : {"panel", "saddle", "dome"}) {
      for (const int size : {100, 150})
        write_mesh("in/" + std::string(shape) + std::to_string(size) + ".obj",
                   make_shape(shape, static_cast<std::size_t>(size)));
    }
    std::ofstream("in/bad.obj") << "v 0 0\n";
    std::ofstream("list.txt") << "\xEF\xBB\xBF# patches\n\nin/panel100.obj\r\n  in/panel150.obj\t\n"
                                 "in/bad.obj\n#in/gone.obj\nin/saddle100.obj\nin/saddle150.obj\n"
                                 "in/missing.obj\nin/dome100.obj\nin/dome150.obj";
  }
};

TEST_F(Lists, HaveALineOfJsonAndOfTheTableForEachPatch) {
  const CliResult result = planish(run_of_list("out", {"--csv", "t.csv", "--threads", "1"}));
  EXPECT_EQ(result.exit_code, k_exit_failed);
  EXPECT_THAT(result.err, HasSubstr("2 of 8 patches could not be flattened"));
  const std::vector<nlohmann::json> records = records_in(result.out);
  const auto rows = table_in(content_of("t.csv"));
  ASSERT_EQ(records.size(), 8U);
  ASSERT_EQ(rows.size(), 9U);
  const auto column = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(rows[0].begin(), rows[0].end(), name) -
                                    rows[0].begin());
  };
  for (std::size_t r = 0; r < records.size(); ++r) {
    EXPECT_EQ(records[r]["number"], r + 1);
    EXPECT_EQ(records[r]["of"], 8U);
    EXPECT_EQ(rows[r + 1].size(), rows[0].size());
    EXPECT_EQ(rows[r + 1].at(column("path")), records[r]["path"]);
    EXPECT_EQ(rows[r + 1].at(column("exit")), records[r]["exit"].dump());
  }
  EXPECT_EQ(records[0]["line"], 3);
  EXPECT_EQ(records[2]["error"]["code"], "malformed_file");
  EXPECT_EQ(records[5]["error"]["code"], "file_not_found");
  EXPECT_TRUE(records[5]["sha256"].is_null());
  // As a run on this patch alone has it.
  const auto alone = planish({"flatten", "in/dome150.obj", "-o", "alone", "--no-report",
                              "--formats", "svg", "--json"})
                         .json();
  const nlohmann::json& last = records.back();
  EXPECT_EQ(last["patch"], "dome150");
  EXPECT_EQ(last["exit"], 0);
  EXPECT_EQ(last["options"]["--formats"], "svg");
  EXPECT_EQ(last["figures"]["strain_rms"], alone["unfold"]["strain"]["rms"]);
  EXPECT_EQ(last["figures"]["width"], alone["unfold"]["width"]);
  EXPECT_EQ(last["figures"]["usable"], alone["usable"]);
  EXPECT_EQ(std::stod(rows.back().at(column("strain_rms"))), alone["unfold"]["strain"]["rms"]);
  for (const char* file : {"pattern.svg", "flat.obj", "processed.obj"})
    EXPECT_EQ(content_of("out/dome150/" + std::string(file)),
              content_of("alone/" + std::string(file)));
  EXPECT_FALSE(std::filesystem::exists("out/dome150/report.html"));
}

TEST_F(Lists, ComeToOneTableInShardsAndOnAnyNumberOfThreads) {
  planish(run_of_list("out", {"--csv", "whole.csv", "--threads", "1"}));
  planish(run_of_list("threads", {"--csv", "threads.csv", "--threads", "3"}));
  EXPECT_EQ(content_of("threads.csv"), content_of("whole.csv"));
  std::set<std::size_t> numbers;
  std::ofstream lines("lines.jsonl");
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    const CliResult result = planish(run_of_list("shards", {"--shard", shard}));
    lines << result.out;
    for (const nlohmann::json& record : records_in(result.out))
      EXPECT_TRUE(numbers.insert(record["number"].get<std::size_t>()).second);
  }
  lines.close();
  EXPECT_EQ(numbers.size(), 8U);
  EXPECT_EQ(planish({"collect", "shards"}).exit_code, k_exit_done);
  EXPECT_EQ(content_of("shards/patches.csv"), content_of("whole.csv"));
  EXPECT_THAT(content_of("shards/patches.html"), HasSubstr("in/missing.obj"));
  const auto collected = planish({"collect", "lines.jsonl", "-o", "joined", "--json"}).json();
  EXPECT_EQ(content_of("joined/patches.csv"), content_of("whole.csv"));
  EXPECT_EQ(collected["failed"], 2);
  EXPECT_EQ(collected["errors"]["malformed_file"], 1);
}

TEST_F(Lists, WithMoreShardsThanInputsHaveEmptyOnes) {
  const CliResult result = planish(run_of_list("out", {"--shard", "9/20", "--csv", "t.csv"}));
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.out, IsEmpty());
  EXPECT_EQ(table_in(content_of("t.csv")).size(), 1U);
}

TEST_F(Lists, KeepWhatIsWholeAndOfTheSameJob) {
  const auto kept_of = [&](const Names& more) {
    Names again = more;
    again.emplace_back("--resume");
    std::vector<std::string> kept;
    for (const nlohmann::json& record : records_in(planish(run_of_list("out", again)).out))
      if (record["kept"]) kept.push_back(record["patch"]);
    std::sort(kept.begin(), kept.end());
    return kept;
  };
  planish(run_of_list("out", {"--shard", "1/2", "--csv", "first.csv"}));
  EXPECT_THAT(kept_of({}), ElementsAre("dome100", "panel100", "saddle150"));
  EXPECT_EQ(kept_of({"--csv", "kept.csv"}).size(), 6U);
  planish(run_of_list("new", {"--csv", "new.csv"}));
  EXPECT_EQ(content_of("kept.csv"), content_of("new.csv"));
  // Another file, another mesh, other options.
  std::ofstream("out/dome100/pattern.svg") << "changed";
  EXPECT_THAT(kept_of({}), Not(testing::Contains("dome100")));
  write_mesh("in/dome150.obj", make_shape("dome", 200));
  EXPECT_THAT(kept_of({}), Not(testing::Contains("dome150")));
  EXPECT_EQ(kept_of({}).size(), 6U);
  EXPECT_THAT(kept_of({"--allowance", "5mm"}), IsEmpty());
  // The same flag, but its file says something else.
  const auto write_cloth = [](const char* strain) {
    const std::string usual =
        R"({"usual": {"strain": ")" + std::string(strain) + R"(", "source": "own test"}})";
    std::ofstream("cloth.json") << R"({"name": "cloth", "stretch": )" << usual
                                << R"(, "compression": )" << usual << "}";
  };
  const Names of_cloth = {"--material", "cloth.json"};
  write_cloth("60 %");
  planish(run_of_list("out", of_cloth));
  EXPECT_EQ(kept_of(of_cloth).size(), 6U);
  write_cloth("50 %");
  EXPECT_THAT(kept_of(of_cloth), IsEmpty());
}

TEST_F(Lists, DoNotTrustWhatStandsInARecord) {
  planish(run_of_list("out"));
  const std::string good = content_of("out/panel100/record.json");
  for (const char* bad : {"", "{", "[]", R"({"records": []})", R"({"records": [1], "files": {}})",
                          R"({"records": [{"number": -1}], "files": {"../x": "1"}})"}) {
    std::ofstream("out/panel100/record.json") << bad;
    const CliResult collected = planish({"collect", "out", "-o", "joined"});
    EXPECT_EQ(collected.exit_code, k_exit_failed) << bad;
    const CliResult result = planish(run_of_list("out", {"--resume"}));
    EXPECT_EQ(records_in(result.out).size(), 8U);
    EXPECT_EQ(
        nlohmann::json::parse(content_of("out/panel100/record.json"))["records"][0]["figures"],
        nlohmann::json::parse(good)["records"][0]["figures"]);
  }
}

TEST_F(Lists, CopyWhatFailsWithItsError) {
  planish(run_of_list("out", {"--keep-failures", "failures"}));
  EXPECT_EQ(content_of("failures/bad.obj"), content_of("in/bad.obj"));
  EXPECT_EQ(nlohmann::json::parse(content_of("failures/bad.error.json"))["error"]["code"],
            "malformed_file");
  EXPECT_TRUE(std::filesystem::exists("failures/missing.error.json"));
  EXPECT_FALSE(std::filesystem::exists("failures/panel100.obj"));
}

TEST_F(Lists, HaveALineForEachPieceOfAnInput) {
  write_product("in/coat.obj",
                {{"front", make_shape("dome", 100), {}}, {"back", make_shape("saddle", 100), {}}});
  std::ofstream("list.txt") << "in/coat.obj\nin/panel100.obj\n";
  const auto records = records_in(planish(run_of_list("out", {"--csv", "t.csv"})).out);
  ASSERT_EQ(records.size(), 3U);
  EXPECT_EQ(table_in(content_of("t.csv")).size(), 4U);
  for (const nlohmann::json& record : records) {
    EXPECT_TRUE(record["figures"]["strain_rms"].is_number()) << record;
    EXPECT_TRUE(record["error"].is_null());
  }
  const auto again = records_in(planish(run_of_list("out", {"--resume"})).out);
  EXPECT_TRUE(
      std::all_of(again.begin(), again.end(), [](const nlohmann::json& r) { return r["kept"]; }));
  EXPECT_EQ(planish({"collect", "out"}).exit_code, k_exit_done);
  EXPECT_EQ(content_of("out/patches.csv"), content_of("t.csv"));
}

TEST_F(Lists, ReadStandardInput) {
  std::istringstream in("in/panel100.obj\nin/dome100.obj\n");
  RunContext context;
  context.in = &in;
  Names args = run_of_list("out");
  args[2] = "-";
  EXPECT_EQ(records_in(planish(args, context).out).size(), 2U);
  EXPECT_EQ(planish(args).exit_code, k_exit_usage);  // there is none
}

TEST_F(Lists, BeginRelativePathsInTheirFolder) {
  std::ofstream("in/list.txt") << "panel100.obj\n";
  Names args = run_of_list("out");
  args[2] = "in/list.txt";
  const auto records = records_in(planish(args).out);
  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(std::filesystem::path(records[0]["path"].get<std::string>()),
            std::filesystem::path("in") / "panel100.obj");
}

TEST_F(Lists, AreRefusedWithTheirLine) {
  const auto message_of = [](const std::string& content, int exit_code) {
    std::ofstream("list.txt", std::ios::binary) << content;
    const CliResult result = planish(run_of_list("out"));
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    EXPECT_THAT(result.out, IsEmpty());
    EXPECT_FALSE(std::filesystem::exists("out"));
    return result.err;
  };
  EXPECT_THAT(message_of("", k_exit_failed), HasSubstr("names no input"));
  EXPECT_THAT(message_of("# none\n\n", k_exit_failed), HasSubstr("names no input"));
  EXPECT_THAT(message_of(std::string("in/a.obj\nin/\0b.obj\n", 18), k_exit_failed),
              HasSubstr("list.txt:2: has a control character"));
  EXPECT_THAT(message_of("in/a.obj\n\n" + std::string(40'000, 'x'), k_exit_failed),
              HasSubstr("list.txt:3: has 40000 bytes"));
}

TEST_F(Lists, OfAnyBytesAreReadOrRefused) {
  std::uint32_t state = 1;
  for (int k = 0; k < 20'000; ++k) {
    std::string text;
    for (std::uint32_t size = (state >> 20U) % 64; size > 0; --size) {
      state = state * 1664525U + 1013904223U;
      constexpr std::string_view letters = "a/.\\ \t\r\n\n#\0\xEF\xBB\xBF\xFF\x7F";
      text += state % 3 == 0 ? static_cast<char>(state >> 24U)
                             : letters[(state >> 16U) % letters.size()];
    }
    state = state * 1664525U + 1013904223U;
    try {
      const auto inputs = numbered(listed_inputs(text, "some/list"));
      std::set<std::string> folders;
      std::size_t line = 0;
      for (const ListedInput& input : inputs) {
        EXPECT_GT(input.line, line);
        line = input.line;
        EXPECT_TRUE(folders.insert(input.folder).second);
        EXPECT_EQ(input.folder.find_first_of("/\\"), std::string::npos);
      }
      std::size_t in_shards = 0;
      for (std::size_t s = 1; s <= 3; ++s)
        in_shards += of_shard(inputs, {s, 3}).size();
      EXPECT_EQ(in_shards, inputs.size());
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::malformed_file);
    }
  }
}

TEST_F(Lists, RefuseWhatDoesNotGoTogether) {
  const auto message_of = [](const Names& args) {
    const CliResult result = planish(args);
    EXPECT_EQ(result.exit_code, k_exit_usage) << result.err;
    return result.err;
  };
  for (const char* shard : {"0/2", "3/2", "1", "1/", "/2", "a/b", "1/2/3", "-1/2", "1/0"})
    EXPECT_THAT(message_of(run_of_list("out", {"--shard", shard})), HasSubstr("must be K/N"));
  EXPECT_THAT(message_of({"flatten", "panel.obj", "--shard", "1/2"}), HasSubstr("--inputs"));
  EXPECT_THAT(message_of({"flatten", "panel.obj", "--csv", "t.csv"}), HasSubstr("--inputs"));
  EXPECT_THAT(message_of({"flatten", "panel.obj", "--inputs", "list.txt"}), HasSubstr("not both"));
  EXPECT_THAT(message_of({"flatten", "--inputs", "list.txt"}), HasSubstr("--output"));
  EXPECT_THAT(message_of({"flatten", "--inputs", "in/panel100.obj", "-o", "o"}),
              HasSubstr("looks like a mesh"));
  EXPECT_THAT(message_of(run_of_list("out", {"--fix", "f.txt"})), HasSubstr("a list has several"));
  EXPECT_THAT(message_of(run_of_list("out", {"--history", "h.csv"})),
              HasSubstr("a list has several"));
  EXPECT_THAT(message_of(run_of_list("out", {"--product"})), HasSubstr("--product"));
  EXPECT_THAT(message_of(run_of_list("out", {"--max-strain", "200%"})), HasSubstr("--max-strain"));
  EXPECT_THAT(message_of({"flatten", "panel.obj", "--open", "--no-report"}), HasSubstr("--open"));
  EXPECT_FALSE(std::filesystem::exists("out"));
}

TEST_F(Lists, StopWhereTheUserAsks) {
  const std::atomic<bool> interrupted = true;
  const CliResult result =
      planish(run_of_list("out", {"--csv", "t.csv"}), {.interrupted = &interrupted});
  EXPECT_EQ(result.exit_code, k_exit_interrupted);
  EXPECT_THAT(result.err, HasSubstr("--resume"));
  EXPECT_FALSE(std::filesystem::exists("t.csv"));
}

TEST_F(Lists, CollectTellsWhatIsMissingAndTornLines) {
  const std::string lines = planish(run_of_list("out", {"--shard", "1/2"})).out;
  std::ofstream("torn.jsonl") << lines << R"({"schema":2,"numb)";
  const CliResult result = planish({"collect", "torn.jsonl", "-o", "joined"});
  EXPECT_EQ(result.exit_code, k_exit_failed);
  EXPECT_THAT(result.err, HasSubstr("no result of 4 inputs"));
  EXPECT_EQ(table_in(content_of("joined/patches.csv")).size(), 5U);
  std::ofstream("bad.jsonl") << lines << "{}\n";
  EXPECT_THAT(planish({"collect", "bad.jsonl"}).err, HasSubstr("bad.jsonl:5: is no record"));
  EXPECT_THAT(planish({"collect", "in"}).err, HasSubstr("no results of flatten --inputs"));
  EXPECT_THAT(planish({"collect", "nowhere"}).err, HasSubstr("no such file or folder"));
}

TEST_F(Lists, OneFileWithoutAReport) {
  const auto files =
      planish({"flatten", "panel.obj", "-o", "out", "--no-report", "--json"}).json()["files"];
  EXPECT_FALSE(files.contains("report_html"));
  EXPECT_TRUE(std::filesystem::exists("out/report.json"));
  EXPECT_FALSE(std::filesystem::exists("out/report.html"));
}

}  // namespace
}  // namespace planish::cli
