#include "piece/piece_keys.h"

#include <algorithm>
#include <array>

#include "flags/annotation_flags.h"
#include "shell/failures.h"
#include "shell/nearest.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

/// Flags about patterns as a whole, and the name, which is that of folder and reports as well.
constexpr std::array<std::string_view, 6> k_of_all = {
    "piece-name", "seam-notches", "date", "edge-lengths", "curve-tolerance", "sheet-unit"};

template <class Names>
bool has_name(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> flag_keys() {
  std::vector<std::string> keys;
  for (const Flag& flag : annotation_flags().flags) {
    const std::string key = flag.name.substr(2);
    if (!has_name(k_of_all, key)) keys.push_back(key);
  }
  return keys;
}

}  // namespace

const std::vector<std::string>& piece_keys() {
  static const std::vector<std::string> keys = [] {
    std::vector<std::string> all = flag_keys();
    all.insert(all.end(), {"darts", "turn", "material", "name", "out"});
    return all;
  }();
  return keys;
}

bool is_flag_of_piece(std::string_view key) {
  static const std::vector<std::string> keys = flag_keys();
  return has_name(keys, key);
}

bool is_file_key(std::string_view key) {
  constexpr std::array<std::string_view, 4> k_files = {"notches", "marks", "inner-lines",
                                                       "edge-allowances"};
  return has_name(k_files, key);
}

bool is_edge_key(std::string_view key) {
  const auto begins = [&](std::string_view start) {
    return key.starts_with(start) && key.size() > start.size();
  };
  return begins(k_allowance_of) || begins(k_hem_of) || begins(k_ends_of) || begins(k_edge);
}

void check_piece_key(const std::string& key, const std::string& where) {
  if (is_edge_key(key) || has_name(piece_keys(), key)) return;
  std::vector<std::string> known = piece_keys();
  known.insert(known.end(), {"allowance.N", "hem.N", "ends.N", "edge.N"});
  throw UsageError(where + ": no setting is called \"" + key + "\"" + nearest_hint(key, known) +
                   " (there are " + list_of(known) + ")");
}

}  // namespace planish::cli
