#pragma once

// Every verb that takes one mesh, run on one file, and what holds of each run whatever the file is.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <planish/io/read_mesh.h>
#include <planish/mesh/inspect.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/cli_run.h"

namespace planish::cli {

struct Verb {
  Names args;               ///< with the input's name "IN"
  std::string output;       ///< what it writes, if anything
  Purpose needs;            ///< of the mesh
  bool reads_only = false;  ///< needs no more than that the file can be read
};

inline const std::vector<Verb>& verbs_of_one_mesh() {
  static const std::vector<Verb> verbs = {
      {{"measure", "IN"}, "", Purpose::measure},
      {{"convert", "IN", "out.ply"}, "out.ply", Purpose::measure, true},
      {{"evolve", "IN", "-o", "out.obj", "--sweeps", "3"}, "out.obj", Purpose::evolve},
      {{"unfold", "IN", "-o", "flat.obj"}, "flat.obj", Purpose::unfold},
      {{"flatten", "IN", "-o", "folder", "--method", "controllable", "--sweeps", "3", "--formats",
        "svg"},
       "folder",
       Purpose::unfold}};
  return verbs;
}

struct VerbRun {
  Verb verb;
  CliResult result;
  nlohmann::json json;

  /// With a result; that may be the design, where evolving made the pattern worse.
  bool done() const {
    return result.exit_code == k_exit_done ||
           (result.exit_code == k_exit_target_missed && json.contains("rejected_strain"));
  }
};

/// Runs a verb in the current folder, which must not have its output yet.
inline VerbRun run_verb(const Verb& verb, const std::string& input) {
  Names args = verb.args;
  std::replace(args.begin(), args.end(), std::string("IN"), input);
  args.insert(args.end(), {"--json", "--threads", "1"});
  VerbRun run{verb, planish(args), {}};
  run.json = run.result.json();
  return run;
}

/// Checks that no number is infinite or NaN, which JSON has as null. What may be null says so.
inline void expect_numbers(const nlohmann::json& json, const std::string& key = "") {
  static const std::set<std::string> may_be_null = {
      "max_deviation", "remeshed_from", "unlimited_strain", "unmatched_strain", "obstruction",
      "nesting", "overlap", "opened", "holes",
      // of candidates outside of the fixed order
      "pick",
      // beside a plane
      "bending_ratio", "bending_added", "bending_lost",
      // with other triangles, or where nothing is bent more
      "normal_turn", "border_turn", "sharpest_fold", "form_change",
      // where too many triangles lie on one another
      "self_intersections",
      // of what cannot be laid flat, or is too large
      "strain", "smallest_limit",
      // too large for a double, of a patch of 1e154 and more
      "area", "area_excess", "area_limit", "border_length"};
  if (json.is_null()) {
    EXPECT_EQ(may_be_null.count(key), 1U) << key << " is no number";
  } else if (json.is_object()) {
    for (const auto& [name, value] : json.items())
      expect_numbers(value, name);
  } else if (json.is_array()) {
    for (const auto& value : json)
      expect_numbers(value, key);
  } else if (json.is_number_float()) {
    EXPECT_TRUE(std::isfinite(json.get<double>())) << key;
  }
}

/// What holds of every run: an end that the docs know, and either a whole output or none.
inline void expect_orderly(const VerbRun& run, const std::string& input) {
  const bool written = !run.verb.output.empty() && std::filesystem::exists(run.verb.output);
  if (run.done()) {
    expect_numbers(run.json);
    EXPECT_EQ(written, !run.verb.output.empty());
    if (written && !std::filesystem::is_directory(run.verb.output)) {
      EXPECT_FALSE(read_mesh(run.verb.output).mesh.triangles.empty());  // refuses what is no number
    }
    return;
  }
  EXPECT_EQ(run.result.exit_code, k_exit_failed) << run.result.err;
  EXPECT_FALSE(written);
  ASSERT_TRUE(run.json.contains("error")) << run.result.out;
  EXPECT_EQ(run.json["error"]["path"], input);
  EXPECT_THAT(run.result.err, testing::HasSubstr(input));
  EXPECT_LT(run.result.err.size(), 500U);
}

/// Whether a verb that needs `needs` is refused for what stands in the way from `blocks` on.
inline bool is_blocked(const Verb& verb, Purpose blocks) {
  return !verb.reads_only && verb.needs >= blocks;
}

/// The figures of a patch that do not depend on its size, place or the order of its vertices.
inline void expect_same_figures(const nlohmann::json& figures, const nlohmann::json& sound,
                                double tolerance) {
  for (const char* const count :
       {"triangles", "inner_vertices", "components", "boundary_loops", "euler_characteristic"})
    EXPECT_EQ(figures[count], sound[count]) << count;
  for (const char* const figure : {"e_max", "e_avg", "energy", "sum_abs_defect", "min_angle"}) {
    EXPECT_NEAR(figures[figure].get<double>(), sound[figure].get<double>(),
                tolerance * (1.0 + sound[figure].get<double>()))
        << figure;
  }
}

}  // namespace planish::cli
