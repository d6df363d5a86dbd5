// What --resume reads from the folder of an earlier run, which anybody may have written.

#include <planish/io/mesh_format.h>
#include <planish/report/json_report.h>

#include <planish_json/json.h>

#include "core/fnv_hash.h"
#include "fuzz/check.h"
#include "fuzz/temporary_folder.h"
#include "product/figures.h"
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

/// The job.json that says that all of them are as they were written, with the figures that the
/// input has in a file of that name.
OutputFile job_of_all(const PatchJob& job, const std::map<std::string, std::string>& files) {
  std::vector<OutputFile> written;
  for (const auto& [name, content] : files)
    written.push_back({name, content});
  OutputFile file = job_file(job, {}, written, "");
  const auto figures = files.find("figures.json");
  if (figures == files.end()) return file;
  Json json = Json::parse(file.content);
  json["figures"] = parse_shallow(figures->second);
  file.content = json_text(json);
  return file;
}

/// What a run does with results that it keeps.
void tell(const ProductPatch& patch, FinishedPatch results) {
  const std::size_t vertices = results.processed.positions.size();
  fuzz::check(results.unfold.pattern.positions.size() == vertices,
              "a pattern has a place for every vertex");
  for (const Vec2 p : results.unfold.pattern.positions)
    fuzz::check(fuzz::is_finite(p), "patterns are finite");
  ProductCallbacks callbacks;
  callbacks.earlier = [&](std::size_t, const PatchTwin*, const SewnBorder&) {
    return std::optional(results);
  };
  const ProductReport report = flatten_product({&patch, 1}, {}, callbacks);
  fuzz::check(report.finished() == 1, "nothing is done again");
  fuzz::check(!patch_line(report.patches.front()).empty(), "every patch has a line");
  fuzz::check(!json_report(report, "product", {{"piece"}, {{}}}).empty(), "the whole is told");
  report.patches.front().finished->outcome().target_met();
  seams_text(report, false);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::TemporaryFolder folder;
  auto files = files_in({reinterpret_cast<const char*>(data), size});
  const ProductPatch patch{"piece", meshes::flat_grid(2, 2)};
  const PatchJob job = job_of(patch, MeshFormat::obj, {}, {}, {});
  // A file of that name in the input stands as it is.
  if (!files.contains("job.json")) files["job.json"] = job_of_all(job, files).content;
  folder.fill(files);
  auto results = finished_results(job, ".");
  if (results) tell(patch, *std::move(results));
  return 0;
}
