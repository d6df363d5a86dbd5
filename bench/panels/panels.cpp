// Divides products into panels, or scores how any program cut and laid flat the files of a folder
// (docs/panels.md, "Measured").

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <planish/io/mesh_format.h>
#include <planish/io/read_mesh.h>
#include <planish/io/write_file.h>
#include <planish/panels/suggest_panels.h>

#include "panels/uv_map.h"
#include "panels/uv_score.h"

using namespace planish;

namespace {

namespace fs = std::filesystem;

constexpr const char* k_usage =
    "bench_panels MOVES RMS FOLDER_FOR_OBJ|- PRODUCT.obj ...\n"
    "  divides products; writes NAME.obj with texture coordinates, and NAME.seconds\n"
    "bench_panels score FOLDER ...\n"
    "  a row for each .obj with texture coordinates; those of one name are side by side.\n"
    "  Seconds are read from NAME.seconds";

double seconds() {
  using namespace std::chrono;
  return duration<double>(steady_clock::now().time_since_epoch()).count();
}

void print_head() {
  std::puts(
      "| product | of | pieces | tips | seam | jag | rms | 99 % | largest | overlap | flipped |"
      " seconds |\n|---|---|---|---|---|---|---|---|---|---|---|---|");
}

void print_row(const std::string& name, const std::string& of, const UvScore& score,
               std::optional<double> time) {
  std::printf("| %s | %s | %zu | %zu | %.3f | %.3f | %.2f %% | %.2f %% | %.1f %% | %zu | %zu |",
              name.c_str(), of.c_str(), score.pieces, score.tips, score.seam, score.jag,
              100.0 * score.strain.rms, 100.0 * score.strain.p99, 100.0 * score.strain.max,
              score.overlapping, score.flipped);
  if (time)
    std::printf(" %.1f |\n", *time);
  else
    std::puts(" |");
  std::fflush(stdout);
}

void print_failure(const std::string& name, const std::string& of, const Error& error) {
  std::printf("| %s | %s | %s |||||||||\n", name.c_str(), of.c_str(), error.what());
}

/// What is beside the file of that name.
std::optional<double> stated_seconds(fs::path file) {
  std::ifstream beside(file.replace_extension(".seconds"));
  double time = 0.0;
  return beside >> time ? std::optional(time) : std::nullopt;
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".obj") names.push_back(entry.path().filename().string());
  }
  return names;
}

bool print_score(const fs::path& file, const std::string& of) {
  const std::string name = file.stem().string();
  try {
    print_row(name, of, score_of(read_uv_map(file)), stated_seconds(file));
    return true;
  } catch (const Error& error) {
    print_failure(name, of, error);
    return false;
  }
}

int score(const std::vector<fs::path>& folders) {
  std::vector<std::string> names;
  for (const fs::path& folder : folders) {
    for (std::string& name : names_in(folder))
      names.push_back(std::move(name));
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  print_head();
  bool are_read = !names.empty();
  for (const std::string& name : names) {
    for (const fs::path& folder : folders) {
      if (fs::exists(folder / name))
        are_read = print_score(folder / name, folder.string()) && are_read;
    }
  }
  return are_read ? 0 : 1;
}

void divide(const fs::path& product, const PanelOptions& given, const fs::path& folder) {
  const Patch patch(read_mesh(product).mesh);
  const double begin = seconds();
  const std::string name = product.stem().string();
  PanelOptions options = given;
  options.on_better = [&](const PanelSuggestion& found) {
    std::fprintf(stderr, "%s: %zu pieces, J %.3f, %s, after %.1f s\n", name.c_str(),
                 found.panels.size(), found.cost, found.met ? "met" : "NOT met", seconds() - begin);
  };
  const PanelSuggestion found = suggest_panels(patch, options);
  const double time = seconds() - begin;
  const char* const kept = found.met ? "met" : "NOT met";
  try {
    const UvMap map = uv_map_of(found, options.limits);
    if (!folder.empty()) {
      const std::vector<OutputFile> files = {
          {folder / (name + ".obj"), format_panels(found, map)},
          {folder / (name + ".seconds"), std::to_string(time) + "\n"}};
      write_files(files);
    }
    print_row(name, kept, score_of(map), time);
  } catch (const Error& error) {
    print_failure(name, kept, error);
  }
}

}  // namespace

int main(int count, char** words) {
  const std::vector<std::string> given(words + 1, words + count);
  if (given.size() > 1 && given[0] == "score") return score({given.begin() + 1, given.end()});
  if (given.size() < 4) {
    std::puts(k_usage);
    return 1;
  }
  PanelOptions options;
  options.moves = std::strtoul(words[1], nullptr, 10);
  options.limits.rms = std::strtod(words[2], nullptr);
  options.match_seams = false;  // as textures are measured, each piece by itself
  print_head();
  for (std::size_t i = 3; i < given.size(); ++i)
    divide(given[i], options, given[2] == "-" ? "" : given[2]);
}
