#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <planish/core/range.h>
#include <planish/core/unit.h>
#include <planish/io/read_features.h>
#include <planish/mesh/tri_mesh.h>

#include "shell/run_context.h"

namespace planish::cli {

/// What may stand behind a flag.
enum class ValueType {
  on_off,  ///< the flag is there or not
  integer,
  number,
  share,   ///< a fraction, or per cent with %
  length,  ///< model units, or with a unit
  angle,   ///< degrees
  radians,
  name,   ///< one of the choices
  names,  ///< some of the choices, with commas between them
  text,
  file,
  folder,
};

/// "share"
std::string_view to_string(ValueType type);

/// What a flag takes, for `planish describe`.
struct FlagValue {
  /// Where it does not follow from what the help calls the value.
  std::optional<ValueType> type = {};
  std::vector<std::string> choices = {};  ///< names; words that are taken besides a number
  Range range = {};                       ///< of numbers, in the unit of their type
  /// As it would be typed. Empty where there is none, or where it depends on something else.
  std::string standard = {};
  /// Of the files that it may name: "obj". Empty for files of any name.
  std::vector<std::string> extensions = {};
  bool optional = false;  ///< the value may be left out; where it is there, "=" stands before it
  bool repeats = false;   ///< given several times, all values count, with commas between them
};

/// One flag, as the parser, the help and `planish describe` see it.
struct Flag {
  std::string name;   ///< "--lambda-min"
  std::string value;  ///< what the help calls its value; empty where it takes none
  std::string doc;
  char letter = 0;  ///< of the short form; 0 for none
  bool required = false;
  FlagValue accepts = {};
  bool first = false;  ///< one of the few that most people need; --help shows these alone
};

ValueType type_of(const Flag& flag);
/// Whether the flag takes the next word for its value.
bool needs_value(const Flag& flag);
/// Of an operand: a name where there are choices, else a file.
ValueType type_of(const FlagValue& operand);

struct FlagGroup {
  std::string title;
  std::vector<Flag> flags;
  std::string method = {};       ///< that alone takes them; empty for all
  std::string first_title = {};  ///< above the flags that come first; empty for the same
};

/// What the user typed behind the verb, and what the input files say in its place; or the same from
/// a caller that has values at hand.
struct Arguments {
  std::vector<std::string> operands;
  /// Full name of the flag -> its value: one field as it was typed; several where commas would
  /// stand between them; none of flags without one.
  std::map<std::string, std::vector<Field>, std::less<>> flags;
  /// What the files of flags hold, where their values are but names for it.
  std::map<std::string, Rows, std::less<>> rows = {};
  std::map<std::string, TriMesh, std::less<>> meshes = {};
  /// What drawings (.obj) hold that flags name and that are no files: those of a project.
  std::map<std::string, std::string, std::less<>> files = {};
  /// The unit of length that all input files state, which holds without --unit.
  std::optional<Unit> stated_unit = {};
  /// Names of pieces in all files of a run over several, which --only and --without may have in
  /// each.
  std::vector<std::string> names_of_all = {};

  bool has(std::string_view flag) const { return flags.find(flag) != flags.end(); }
  /// The value of a flag, or the other one where it was not given; of several fields a text.
  Field value(std::string_view flag, Field other = {}) const;
  /// The same as a text.
  std::string text(std::string_view flag, std::string other = {}) const;
  /// The same, divided at commas.
  std::vector<Field> fields(std::string_view flag, std::string other = {}) const;
  /// The rows that stand for a flag's file, else those of the file.
  /// @throws Error as read_rows()
  Rows rows_of(const std::string& flag) const;
};

/// What a verb says and how it ended. run() alone prints it, so that --json is one object always.
/// Verbs make it before they write their files, the last that they do: nothing can fail behind
/// that.
struct CommandResult {
  std::string text;  ///< for people
  std::string json;
  int exit_code = k_exit_done;
  std::string complaint = {};  ///< for standard error, where the exit code is not 0
};

class Session;

/// One verb of the program.
struct Command {
  std::string name;
  std::string summary;      ///< a line for the list of verbs
  std::string usage;        ///< what follows the verb: "INPUT -o OUTPUT"
  std::string description;  ///< a paragraph for the verb's own help
  std::vector<std::string> operands;
  std::vector<FlagGroup> groups;
  std::vector<std::string> examples;
  CommandResult (*run)(const Arguments&, Session&);
  bool operands_optional = false;
  bool operands_repeat = false;  ///< the last may be given several times
  /// What each of the operands takes.
  std::vector<FlagValue> operand_values = {};
};

/// What --threads takes; 0 for all usable processors.
inline constexpr Range k_threads = {0.0, 1024.0};

/// Marks the flags that --help shows first; of several with one name, the first one.
/// @throws std::out_of_range where the verb has none of that name
void mark_first(std::vector<FlagGroup>& groups, const std::vector<std::string>& names);

/// Whether --help shows some flags only, and --help-all the rest.
bool has_first_flags(const Command& command);

/// The flags that every verb takes, before or behind it.
const FlagGroup& global_flags();

/// The flag of that name that the verb takes, as every verb may, or nullptr.
const Flag* find_flag(const Command& command, std::string_view name);

}  // namespace planish::cli
