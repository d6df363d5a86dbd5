#pragma once

#include <functional>
#include <vector>

#include <planish_json/json.h>

#include "batch/input_list.h"
#include "shell/command.h"
#include "shell/session.h"

namespace planish::cli {

/// --inputs, --shard, --csv and --keep-failures.
std::vector<Flag> list_flags();

/// A run on many inputs, one by one.
struct ListJob {
  std::vector<ListedInput> inputs;  ///< of all shards, numbered()
  /// The verb, on an input alone: its folder is --output. Called from several threads.
  std::function<CommandResult(const Arguments&, Session&)> work;
  /// Receives each record as soon as it is there; from the calling thread.
  std::function<void(const Json& record)> on_record;
};

/// Works on the inputs of a shard, as many at a time as there are threads, each on one. What is in
/// memory of an input is gone when it is done, but for a line of the table. An input that fails
/// does not end the others. With --resume those are kept whose records are there and right.
/// @param arguments with --output; of --inputs only whether it is there
/// @throws UsageError for flags that go with one patch, Error file_unwritable
CommandResult run_list(const ListJob& job, const Arguments& arguments, Session& session);

/// @throws UsageError for flags that make sense with --inputs alone
void refuse_list_flags(const Arguments& arguments);

}  // namespace planish::cli
