#include "flags/pick_flag.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "flags/constraint_flags.h"
#include "flags/method_flags.h"
#include "flags/quantities.h"
#include "shell/failures.h"
#include "shell/run_context.h"
#include "shell/session.h"
#include "shell/text.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

constexpr Range k_numbers = {1.0, static_cast<double>(k_candidates)};
constexpr std::string_view k_choices =
    "1 as designed, 2, 3, 4, 5 at most 2, 1, 0.5, 0.1 % rms, 6 flat";

constexpr std::array<std::string_view, 3> k_limits = {"--max-strain", "--material",
                                                      "--max-rms-strain"};
constexpr std::array<std::string_view, 6> k_asking = {
    "--pick", "--prefer", "--method", "--target-e-max", "--closeness", "--max-bending"};
/// How far the form may go, which alone is reason enough to change it.
constexpr std::string_view k_tolerance = "--max-deviation";

/// Limits judge the design, too.
bool is_limit(std::string_view flag) {
  return std::find(k_limits.begin(), k_limits.end(), flag) != k_limits.end();
}

bool is_asking(std::string_view flag) {
  return std::find(k_asking.begin(), k_asking.end(), flag) != k_asking.end();
}

void refuse_other_choices(const Arguments& arguments, int number) {
  for (const char* flag : {"--prefer", "--max-strain", "--material", "--max-rms-strain",
                           "--closeness", "--target-e-max", "--max-sweeps"}) {
    if (!arguments.has(flag) || (number == 1 && is_limit(flag))) continue;
    throw UsageError("flags --pick and " + std::string(flag) +
                     " both say how far to go: use one of them");
  }
}

int number_from(const Field& field) {
  const std::string text = field_text(field);
  if (text.find_first_not_of("0123456789") != std::string::npos) {
    throw UsageError("--pick is \"" + text + "\" but must be a number from 1 to " +
                     std::to_string(k_candidates) + ": " + std::string(k_choices));
  }
  return whole_number_of("--pick", field, k_numbers);
}

}  // namespace

bool asks_to_evolve(const Arguments& arguments) {
  return std::any_of(k_asking.begin(), k_asking.end(),
                     [&](std::string_view flag) { return arguments.has(std::string(flag)); });
}

void note_idle_evolve_flags(Session& session, const Arguments& arguments) {
  const bool has_limit = std::any_of(k_limits.begin(), k_limits.end(), [&](std::string_view flag) {
    return arguments.has(std::string(flag));
  });
  if (has_limit || arguments.has(std::string(k_tolerance)) || asks_to_evolve(arguments)) return;
  std::vector<std::string> idle;
  std::vector<FlagGroup> groups = method_flags(Auto{});
  groups.push_back(constraint_flags());
  for (const FlagGroup& group : groups) {
    for (const Flag& flag : group.flags) {
      if (arguments.has(flag.name) && !is_limit(flag.name) && !is_asking(flag.name))
        idle.push_back(flag.name);
    }
  }
  if (idle.empty()) return;
  std::sort(idle.begin(), idle.end());
  idle.erase(std::unique(idle.begin(), idle.end()), idle.end());
  std::string names = idle.front();
  for (std::size_t k = 1; k < idle.size(); ++k)
    names += (k + 1 < idle.size() ? ", " : " and ") + idle[k];
  session.note(names + (idle.size() == 1 ? " says" : " say") +
               " how to change the form, but nothing asks for a change: the surface stays as it "
               "is. --pick 5 takes nearly all stretch out; --max-rms-strain and --material set a "
               "limit");
}

Flag pick_flag() {
  return {"--pick", "N",   "how much strain to leave: " + std::string(k_choices),
          0,        false, {.type = ValueType::integer, .range = k_numbers}};
}

FlattenOptions picked(FlattenOptions options, const Arguments& arguments) {
  if (!arguments.has("--pick")) return options;
  const int number = number_from(arguments.value("--pick"));
  refuse_other_choices(arguments, number);
  if (options.method && !std::holds_alternative<Auto>(*options.method))
    throw UsageError("flag --pick goes with method auto only");
  return preset_options(number, std::move(options));
}

CommandResult with_design_checked(CommandResult outcome, const FlattenReport& report) {
  if (!report.rejected) return outcome;
  outcome.exit_code = k_exit_target_missed;
  outcome.complaint = "evolving would have stretched the pattern more, to " +
                      percent(report.rejected->rms) + " rms where the design has " +
                      percent(report.design_pattern.strain.rms) +
                      ": the pattern of the design was written" +
                      (outcome.complaint.empty() ? "" : ". " + outcome.complaint);
  return outcome;
}

}  // namespace planish::cli
