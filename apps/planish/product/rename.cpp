#include "product/rename.h"

#include <map>
#include <set>
#include <utility>

#include "shell/failures.h"
#include "shell/safe_names.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

constexpr const char* k_flag = "--rename";

/// Old name -> new name.
std::map<std::string, std::string> asked_names(const Arguments& arguments) {
  std::map<std::string, std::string> names;
  for (const Field& field : arguments.fields(k_flag)) {
    const std::string pair = field_text(field);
    const std::size_t sign = pair.find('=');
    if (sign == std::string::npos || sign == 0 || sign + 1 == pair.size()) {
      throw UsageError(std::string(k_flag) + " has \"" + pair +
                       "\" but needs OLD=NEW, with commas between several");
    }
    if (!names.emplace(pair.substr(0, sign), pair.substr(sign + 1)).second)
      throw UsageError(std::string(k_flag) + " names \"" + pair.substr(0, sign) + "\" twice");
  }
  return names;
}

}  // namespace

Flag rename_flag() {
  return {
      k_flag, "OLD=NEW", "other names for pieces, separated by commas: panel-1=front,panel-2=back",
      0,      false,     {.repeats = true}};
}

void rename_pieces(ProductInput& input, const Arguments& arguments) {
  if (arguments.has(k_flag)) give_names(input, asked_names(arguments), k_flag);
}

void give_names(ProductInput& input, std::map<std::string, std::string> asked,
                const std::string& flag) {
  if (asked.empty()) return;
  if (input.is_described)
    throw UsageError("flag " + flag +
                     " gives no names to pieces of a product file: give them there");
  std::vector<std::string> old_names, new_names;
  for (ProductPatch& patch : input.patches) {
    old_names.push_back(patch.name);
    if (const auto found = asked.find(patch.name); found != asked.end()) {
      patch.name = found->second;
      asked.erase(found);
    }
    new_names.push_back(patch.name);
  }
  if (!asked.empty()) {
    throw UsageError(flag + ": no piece is called \"" + asked.begin()->first + "\"; there are " +
                     list_of_some(old_names));
  }
  std::set<std::string> once;
  for (const std::string& name : new_names) {
    if (!once.insert(name).second)
      throw UsageError(flag + ": two pieces would be called \"" + name + "\"");
  }
  const std::vector<std::string> folders = safe_names(new_names);
  for (std::size_t p = 0; p < folders.size(); ++p)
    input.places[p].folder = folders[p];
}

std::vector<PieceRequest> named_requests(ProductInput& input, const PatternOptions& usual,
                                         const Arguments& arguments, Session& session) {
  std::vector<PieceRequest> requests =
      piece_requests(input.patches, input.settings, usual, arguments, session);
  std::map<std::string, std::string> names;
  for (std::size_t p = 0; p < requests.size(); ++p) {
    if (requests[p].name) names.emplace(input.patches[p].name, *requests[p].name);
  }
  give_names(input, std::move(names), "--piece");
  return requests;
}

}  // namespace planish::cli
