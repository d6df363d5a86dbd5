// What --resume reads from the folder of an earlier run, which anybody may have written.

#include <planish/io/write_mesh.h>

#include "core/fnv_hash.h"
#include "fuzz/check.h"
#include "fuzz/temporary_folder.h"
#include "product/job.h"
#include "product/seams.h"
#include "product/state.h"
#include "product/text.h"
#include "support/meshes.h"

using namespace planish;
using namespace planish::cli;

namespace {

/// The files of an input, each begun by a line "=== NAME"; names lead nowhere else.
std::map<std::string, std::string> files_in(std::string_view input) {
  std::map<std::string, std::string> files;
  while (!input.empty()) {
    const std::size_t begin = input.find("=== ");
    if (begin == input.npos) break;
    input.remove_prefix(begin + 4);
    std::string name(input.substr(0, input.find('\n')));
    for (char& c : name) {
      const bool is_plain = (c >= 'a' && c <= 'z') || c == '.' || c == '_';
      if (!is_plain) c = '_';
    }
    input.remove_prefix(std::min(input.size(), name.size() + 1));
    const std::string_view content = input.substr(0, input.find("=== "));
    if (name.size() < 40 && name.find("..") == name.npos && name.size() > 1) files[name] = content;
    input.remove_prefix(content.size());
  }
  return files;
}

/// The job.json that says that all of them are as they were written.
OutputFile job_of_all(const std::string& job, const std::map<std::string, std::string>& files) {
  std::vector<OutputFile> written;
  for (const auto& [name, content] : files)
    written.push_back({name, content});
  return job_file(job, written, "");
}

/// What a run does with results that it keeps.
void tell(const ProductPatch& patch, const PatchResults& results) {
  fuzz::check(results.pattern.size() == results.mesh.positions.size(),
              "a pattern has a place for every vertex");
  for (const Vec2 p : results.pattern)
    fuzz::check(fuzz::is_finite(p), "patterns are finite");
  const std::vector<PatchOutcome> outcomes = {
      {.failure = {}, .report = results.report, .mesh = results.mesh, .pattern = results.pattern}};
  const ProductJob job{.path = "product.obj",
                       .patches = {patch},
                       .folder = ".",
                       .options = {},
                       .annotations = {},
                       .files_of = {}};
  const auto seams = measure_seams(outcomes, seams_from({}, {&results.mesh, 1}), Unit::mm);
  fuzz::check(!patch_line(patch, outcomes.front()).empty(), "every patch has a line");
  fuzz::check(!product_json(job, outcomes, seams).empty(), "the whole is told");
  missed_target(outcomes.front());
  seams_text(job, seams);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::TemporaryFolder folder;
  auto files = files_in({reinterpret_cast<const char*>(data), size});
  const ProductPatch patch{"piece", "piece", meshes::flat_grid(2, 2)};
  const std::string job = job_of(patch, {}, {});
  // A file of that name in the input stands as it is.
  if (!files.contains("job.json")) files["job.json"] = job_of_all(job, files).content;
  folder.fill(files);
  const auto results = finished_results(job, ".");
  if (results) tell(patch, *results);
  return 0;
}
