#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "shell/command.h"
#include "shell/session.h"

namespace planish::cli {

/// An input of many that are worked on one by one.
struct ListedInput {
  std::string path;
  std::size_t line = 0;     ///< of the list, from 1; 0 where there is no list
  std::size_t number = 0;   ///< among the inputs, from 1
  std::string folder = {};  ///< safe name for what is made of it, unlike that of every other
};

/// A part of many inputs, that one of several machines works on.
struct Shard {
  std::size_t number = 1, count = 1;
};

/// The shard that --shard names, all of one without it.
/// @throws UsageError for what is not K/N with K from 1 to N
Shard shard_from(const Arguments& arguments);

/// What the text of a list names: a path a line; blanks at both ends do not count, nor lines that
/// are empty or begin with #.
/// @param name of the list, for errors; relative paths begin in its folder
/// @throws Error malformed_file with its line for what can be no path, and for a list of none
std::vector<ListedInput> listed_inputs(const std::string& text, const std::string& name);

/// The inputs of --inputs, that of "-" from standard input.
/// @throws UsageError for a mesh in the list's place; Error file_not_found, file_unreadable, and as
/// listed_inputs()
std::vector<ListedInput> inputs_from(const Arguments& arguments, Session& session);

/// With numbers from 1, and the folder of each, which depends on all of them.
std::vector<ListedInput> numbered(std::vector<ListedInput> inputs);

/// Every Nth of numbered inputs, from the Kth on: long and short work often stand side by side in a
/// list, and so every shard gets its share of both.
std::vector<ListedInput> of_shard(const std::vector<ListedInput>& inputs, const Shard& shard);

}  // namespace planish::cli
