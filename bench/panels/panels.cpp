// Divides products into panels, and prints a row for each answer: pieces, tips, seam over the root
// of the area, jag (length of seams over chords of four mean edges), largest rms and largest strain
// of a piece, how many lap, seconds.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <planish/io/read_mesh.h>
#include <planish/mesh/surface_line.h>
#include <planish/panels/suggest_panels.h>

#include "mesh/mean_edge.h"
#include "support/meshes.h"

using namespace planish;

namespace {

double seconds() {
  using namespace std::chrono;
  return duration<double>(steady_clock::now().time_since_epoch()).count();
}

/// The length of all seams over that of their chords.
double jag_of_seams(const PanelSuggestion& found, double mean_edge) {
  double length = 0.0, chords = 0.0;
  for (const std::vector<Index>& seam : found.seams) {
    std::vector<Vec3> line;
    double along = 0.0;
    for (const Index v : seam) {
      if (!line.empty()) along += norm(found.mesh.positions[v] - line.back());
      line.push_back(found.mesh.positions[v]);
    }
    length += along;
    chords += along / jag_of(line, mean_edge);
  }
  return chords > 0.0 ? length / chords : 1.0;
}

void write_groups(const std::string& name, const PanelSuggestion& found) {
  std::ofstream file(name);
  for (const Vec3 p : found.mesh.positions)
    file << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
  for (std::size_t k = 0; k < found.panels.size(); ++k) {
    file << "g panel-" << k + 1 << '\n';
    for (const Index t : found.panels[k].triangles) {
      const Triangle& c = found.mesh.triangles[t];
      file << "f " << c[0] + 1 << ' ' << c[1] + 1 << ' ' << c[2] + 1 << '\n';
    }
  }
  for (const std::vector<Index>& seam : found.seams) {
    file << 'l';
    for (const Index v : seam)
      file << ' ' << v + 1;
    file << '\n';
  }
}

void print_row(const std::string& name, const PanelSuggestion& found, double mean_edge,
               double time) {
  double rms = 0.0, largest = 0.0;
  int laps = 0;
  for (const SuggestedPanel& panel : found.panels) {
    rms = std::max(rms, panel.strain.rms);
    largest = std::max(largest, panel.strain.max);
    laps += panel.overlaps || !panel.has_pattern ? 1 : 0;
  }
  std::printf(
      "%-6s %-4s %3zu pieces %3zu tips seam %6.3f jag %.3f rms %.2f %% largest %.0f %% "
      "lap %d  J %.3f  %.1f s\n",
      name.c_str(), found.met ? "met" : "NOT", found.panels.size(), found.tips,
      found.length / std::sqrt(meshes::area(found.mesh)), jag_of_seams(found, mean_edge),
      100.0 * rms, 100.0 * largest, laps, found.cost, time);
  std::fflush(stdout);
}

void run(const std::filesystem::path& product, const PanelOptions& given,
         const std::filesystem::path& folder) {
  const Patch patch(read_mesh(product).mesh);
  const double mean_edge = mean_edge_length(patch.mesh()), begin = seconds();
  const std::string name = product.stem().string();
  PanelOptions options = given;
  options.on_better = [&](const PanelSuggestion& found) {
    print_row(name, found, mean_edge, seconds() - begin);
    if (!folder.empty()) write_groups((folder / (name + ".obj")).string(), found);
  };
  suggest_panels(patch, options);
  std::printf("%-6s searched for %.1f s\n", name.c_str(), seconds() - begin);
}

}  // namespace

int main(int count, char** words) {
  if (count < 4) {
    std::puts("bench_panels MOVES RMS FOLDER_FOR_OBJ|- PRODUCT.obj ...");
    return 1;
  }
  PanelOptions options;
  options.moves = std::strtoul(words[1], nullptr, 10);
  options.limits.rms = std::strtod(words[2], nullptr);
  const std::string folder = words[3];
  for (int i = 4; i < count; ++i)
    run(words[i], options, folder == "-" ? "" : folder);
}
