// Dividing any small surface into panels, closed ones among them, with any limits.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include <planish/mesh/cut.h>
#include <planish/panels/suggest_panels.h>

#include "fuzz/bytes_to_patch.h"
#include "fuzz/check.h"
#include "mesh/split.h"

using namespace planish;

namespace {

/// A second sheet below the first one, joined to it along its border: a ball, or where the first
/// one has holes a ball with handles.
TriMesh closed_from(fuzz::Bytes& bytes) {
  TriMesh mesh = fuzz::mesh_from(bytes);
  const Inspection inspection = inspect(mesh);
  if (blocking_problem(inspection, Purpose::measure)) return mesh;
  const Patch sheet(mesh);
  const double down = 0.1 + bytes.fraction() + 1.0;
  std::vector<Index> below(mesh.positions.size());
  for (Index v = 0; v < below.size(); ++v) {
    below[v] = v;
    if (sheet.is_border(v)) continue;
    below[v] = static_cast<Index>(mesh.positions.size());
    mesh.positions.push_back(mesh.positions[v] - Vec3{0.0, 0.0, down});
  }
  for (const Triangle& t : sheet.triangles())
    mesh.triangles.push_back({below[t[0]], below[t[2]], below[t[1]]});
  return mesh;
}

PanelOptions options_from(fuzz::Bytes& bytes) {
  PanelOptions options;
  const auto limit = [&] { return bytes.flag() ? bytes.within(2e-3, 1.0) : 0.0; };
  options.limits = {.max = limit(), .p99 = limit(), .rms = limit()};
  options.prefer = static_cast<PanelPreference>(bytes.whole(0, 2));
  options.moves = bytes.whole(1, 2);
  options.trial_vertices = bytes.whole(100, 120);
  return options;
}

void check_panels(const TriMesh& given, const PanelSuggestion& found, const PanelOptions& options) {
  const TriMesh& mesh = found.mesh;
  fuzz::check(
      std::equal(given.positions.begin(), given.positions.end(), mesh.positions.begin(),
                 mesh.positions.begin() + static_cast<std::ptrdiff_t>(given.positions.size())),
      "the vertices of the product come first");
  std::vector<int> times(mesh.triangles.size(), 0);
  double area = 0.0;
  bool met = true;
  Index first = 0;
  for (const SuggestedPanel& panel : found.panels) {
    fuzz::check(!panel.triangles.empty() && panel.triangles.front() >= first,
                "panels are in the order of their smallest triangles");
    first = panel.triangles.front();
    fuzz::check(std::is_sorted(panel.triangles.begin(), panel.triangles.end()),
                "triangles of panels are increasing");
    for (const Index t : panel.triangles)
      ++times.at(t);
    area += panel.area;
    met = met && panel.has_pattern && !panel.overlaps && options.limits.kept_by(panel.strain);
  }
  fuzz::check(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; }),
              "panels partition the triangles");
  fuzz::check(std::abs(area - 1.0) < 1e-6, "panels have the area of the product");
  fuzz::check(met == found.met, "`met` says what the panels say");
}

/// Along the seams the mesh falls into the panels.
void check_seams(const PanelSuggestion& found) {
  std::vector<CutPath> paths;
  double length = 0.0;
  for (const std::vector<Index>& seam : found.seams) {
    fuzz::check(seam.size() >= 2, "seams have two ends");
    paths.push_back({seam, {}});
    length += path_length(seam, found.mesh.positions);
  }
  fuzz::check(std::abs(length - found.length) <= 1e-9 * length, "seams have the length told");
  const CutMesh cut = cut_open(Patch(found.mesh), paths);
  std::vector<std::vector<Index>> parts;
  for (const NamedPatch& part : split(cut.mesh, "part"))
    parts.emplace_back().push_back(static_cast<Index>(part.mesh.triangles.size()));
  std::vector<std::vector<Index>> panels;
  for (const SuggestedPanel& panel : found.panels)
    panels.emplace_back().push_back(static_cast<Index>(panel.triangles.size()));
  fuzz::check(parts == panels, "seams cut the product into the panels");
}

void check_same(const PanelSuggestion& one, const PanelSuggestion& other) {
  fuzz::check(one.mesh.positions == other.mesh.positions &&
                  one.mesh.triangles == other.mesh.triangles && one.seams == other.seams &&
                  one.met == other.met && one.cost == other.cost && one.length == other.length &&
                  one.tips == other.tips && one.panels.size() == other.panels.size(),
              "the same on any number of threads");
  for (std::size_t k = 0; k < one.panels.size(); ++k) {
    fuzz::check(one.panels[k].triangles == other.panels[k].triangles &&
                    one.panels[k].strain.rms == other.panels[k].strain.rms &&
                    one.panels[k].strain.max == other.panels[k].strain.max,
                "the same panels on any number of threads");
  }
}

/// Ended after some questions: nothing, or an answer that holds.
void check_cancelled(const Patch& patch, const PanelOptions& options, std::size_t questions) {
  std::atomic<std::size_t> asked = 0;
  try {
    const PanelSuggestion found = suggest_panels(
        patch, options, {.threads = 1, .is_cancelled = [&] { return ++asked > questions; }});
    check_panels(patch.mesh(), found, options);
    fuzz::check(found.was_cancelled || asked <= questions,
                "a search that was cancelled is marked as cancelled");
  } catch (const Cancelled&) {
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const PanelOptions options = options_from(bytes);
  const std::size_t questions = bytes.flag() ? bytes.whole(0, 2000) : 0;
  const TriMesh mesh = bytes.flag() ? closed_from(bytes) : fuzz::mesh_from(bytes);
  if (blocking_problem(inspect(mesh), Purpose::measure)) return 0;
  fuzz::allow_refusal([&] {
    const Patch patch(mesh);
    const PanelSuggestion found = suggest_panels(patch, options, {.threads = 1});
    if (fuzz::has_edges_below(1e-70, mesh)) return;  // squares of their lengths vanish
    check_panels(mesh, found, options);
    check_seams(found);
    if (questions > 0)
      check_cancelled(patch, options, questions);
    else
      check_same(found, suggest_panels(patch, options, {.threads = 2}));
  });
  return 0;
}
