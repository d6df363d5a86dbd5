#include "piece/single_patch_flags.h"

#include <string>

#include "piece/piece_keys.h"
#include "shell/failures.h"

namespace planish::cli {

namespace {

/// How several patches may have what a flag asks of one.
std::string way_for_pieces(const std::string& flag) {
  const std::string key = flag.substr(2);
  return is_flag_of_piece(key) ? ", or ask for it with --piece NAME:" + key + "=..." : "";
}

}  // namespace

void refuse_single_patch_flags(const Arguments& arguments, const std::string& why_not) {
  for (const char* flag :
       {"--fix", "--weights", "--obstacle", "--history", "--fields", "--notches", "--marks",
        "--edge-allowances", "--fold", "--inner-lines", "--piece-name"}) {
    if (!arguments.has(flag)) continue;
    throw UsageError("flag " + std::string(flag) + " goes with one patch only; " + why_not +
                     way_for_pieces(flag));
  }
}

}  // namespace planish::cli
