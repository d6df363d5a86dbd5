#include "run.h"

#include <new>

#include <planish/core/version.h>
#include <planish/core/ways_on.h>
#include <planish/report/json_report.h>

#include "batch/stated_units.h"
#include "help.h"
#include "model/project_file.h"
#include "parse.h"
#include "shell/command.h"
#include "shell/failures.h"
#include "shell/session.h"
#include "shell/text.h"
#include "text/json_text.h"

namespace planish::cli {

namespace {

// A constant, so that nothing has to be allocated to say it.
constexpr const char* k_out_of_memory = "out of memory";

CommandResult usage_failure(const std::string& message, const std::string& json) {
  return {{}, json, k_exit_usage, message};
}

/// Does what the command line asks for; failures come out as exceptions.
CommandResult obey(std::span<const std::string> args, std::ostream& err,
                   const RunContext& context) {
  const Parsed parsed = parse(args);
  const bool all = parsed.arguments.has("--help-all");
  if (all || parsed.arguments.has("--help")) {
    return {parsed.command == nullptr ? program_help() : verb_help(*parsed.command, all), {}};
  }
  if (parsed.arguments.has("--version")) {
    return {"planish " + std::string(k_version) + "\n", json_version(k_version)};
  }
  if (parsed.command == nullptr) throw UsageError("no verb given");
  Session session(parsed.arguments, err, context);
  for (const std::string& note : parsed.notes)
    session.note(note);
  const Arguments arguments = with_project(*parsed.command, parsed.arguments);
  return parsed.command->run(with_stated_unit(*parsed.command, arguments, session), session);
}

/// The outcome of a failed run. To be called while its exception is being handled.
CommandResult outcome_of_failure() {
  try {
    throw;
  } catch (const UsageError& error) {
    return usage_failure(error.what(), json_failure("usage", error.what()));
  } catch (const Cancelled&) {
    const std::string message = "interrupted; nothing was written";
    return {{}, json_failure("interrupted", message), k_exit_interrupted, message};
  } catch (const Error& error) {
    const std::string message = with_way_on(error);
    if (is_of_usage(error)) return usage_failure(message, json_report(error));
    return {{}, json_report(error), k_exit_failed, message};
  } catch (const std::bad_alloc&) {
    return {{}, k_out_of_memory_json, k_exit_failed, k_out_of_memory};
  } catch (const std::exception& error) {
    const std::string message =
        "internal error: " + std::string(error.what()) + "; please report this";
    return {{}, json_failure("internal_error", message), k_exit_failed, message};
  }
}

void print(const CommandResult& outcome, bool as_json, std::ostream& out, std::ostream& err) {
  if (!outcome.complaint.empty()) err << "error: " << Shown{outcome.complaint} << "\n";
  if (outcome.exit_code == k_exit_usage)
    err << "planish --help and planish VERB --help tell more\n";
  const bool prints_json = as_json && !outcome.json.empty();
  const std::string& text = prints_json ? outcome.json : outcome.text;
  if (prints_json) {
    out << text;
  } else {
    out << Shown{text};
  }
  if (!text.empty() && text.back() != '\n') out << '\n';
  out.flush();
}

int tell_of_no_memory(bool as_json, std::ostream& out, std::ostream& err) {
  err << "error: " << k_out_of_memory << '\n';
  if (as_json) out << k_out_of_memory_json << '\n' << std::flush;
  return k_exit_failed;
}

}  // namespace

int run(std::span<const std::string> args, std::ostream& out, std::ostream& err,
        const RunContext& context) {
  if (args.empty()) {
    err << short_help();
    return k_exit_usage;
  }
  CommandResult outcome;
  try {
    RunContext own = context;
    own.on_line = [&out](std::string_view line) { out << line << '\n' << std::flush; };
    outcome = obey(args, err, own);
  } catch (...) {
    try {
      outcome = outcome_of_failure();
    } catch (const std::bad_alloc&) {  // not even for the words
      return tell_of_no_memory(asks_for(args, "--json"), out, err);
    }
  }
  print(outcome, asks_for(args, "--json"), out, err);
  if (!out && outcome.exit_code == k_exit_done) {
    err << "error: cannot write to standard output\n";
    return k_exit_failed;
  }
  return outcome.exit_code;
}

}  // namespace planish::cli
