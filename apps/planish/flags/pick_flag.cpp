#include "flags/pick_flag.h"

#include <string>
#include <string_view>
#include <utility>

#include "flags/quantities.h"
#include "shell/failures.h"
#include "shell/run_context.h"
#include "shell/text.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

constexpr Range k_numbers = {1.0, static_cast<double>(k_candidates)};
constexpr std::string_view k_choices =
    "1 as designed, 2, 3, 4, 5 at most 2, 1, 0.5, 0.1 % rms, 6 flat";

/// Limits judge the design, too.
bool is_limit(std::string_view flag) {
  return flag == "--max-strain" || flag == "--material" || flag == "--max-rms-strain";
}

void refuse_other_choices(const Arguments& arguments, int number) {
  for (const char* flag : {"--prefer", "--max-strain", "--material", "--max-rms-strain",
                           "--closeness", "--target-e-max", "--max-sweeps"}) {
    if (!arguments.has(flag) || (number == 1 && is_limit(flag))) continue;
    throw UsageError("flags --pick and " + std::string(flag) +
                     " both say how far to go: use one of them");
  }
}

int number_from(const std::string& text) {
  if (text.find_first_not_of("0123456789") != std::string::npos) {
    throw UsageError("--pick is \"" + text + "\" but must be a number from 1 to " +
                     std::to_string(k_candidates) + ": " + std::string(k_choices));
  }
  return whole_number_of("--pick", text, k_numbers);
}

}  // namespace

Flag pick_flag() {
  return {"--pick", "N",   "how much strain to leave: " + std::string(k_choices) + " (default 5)",
          0,        false, {.type = ValueType::integer, .range = k_numbers}};
}

FlattenOptions picked(FlattenOptions options, const Arguments& arguments) {
  if (!arguments.has("--pick")) return options;
  const int number = number_from(arguments.flags.at("--pick"));
  refuse_other_choices(arguments, number);
  if (!std::holds_alternative<Auto>(options.method))
    throw UsageError("flag --pick goes with method auto only");
  return pick(number, std::move(options));
}

CommandResult with_design_checked(CommandResult outcome, const FlattenReport& report) {
  if (!report.rejected) return outcome;
  outcome.exit_code = k_exit_target_missed;
  outcome.complaint = "evolving would have stretched the pattern more, to " +
                      percent(report.rejected->rms) + " rms where the design has " +
                      percent(report.as_designed.strain.rms) +
                      ": the pattern of the design was written" +
                      (outcome.complaint.empty() ? "" : ". " + outcome.complaint);
  return outcome;
}

}  // namespace planish::cli
