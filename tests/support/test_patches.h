#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace planish {

/// A line of the table in DATA.md.
struct PatchFacts {
  std::string name;
  double vertices, triangles, border_vertices, e_max, e_avg, min_angle;
  std::filesystem::path path;
};

inline std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::stringstream stream(line);
  for (std::string cell; std::getline(stream, cell, '|');)
    cells.push_back(cell);
  return cells;
}

/// All patches of the folder that the environment variable PLANISH_TEST_DATA tells; none where it
/// is not set.
/// @throws std::runtime_error where it is set and holds none, so that no test passes over nothing
inline std::vector<PatchFacts> patches() {
  std::vector<PatchFacts> facts;
  const char* folder = std::getenv("PLANISH_TEST_DATA");
  if (folder == nullptr) return facts;
  const std::filesystem::path patches = std::filesystem::path(folder) / "patches";
  std::ifstream table(patches / "DATA.md");
  for (std::string line; std::getline(table, line);) {
    const auto at = line.find("| patches/");
    if (at != 0) continue;
    const auto cells = cells_of(line);
    std::string name = cells.at(1).substr(std::string(" patches/").size());
    name.erase(name.find_last_not_of(' ') + 1);
    facts.push_back({name, std::stod(cells.at(3)), std::stod(cells.at(4)), std::stod(cells.at(5)),
                     std::stod(cells.at(6)), std::stod(cells.at(7)), std::stod(cells.at(8)),
                     patches / name});
  }
  if (facts.empty()) throw std::runtime_error("no patch in " + patches.string());
  return facts;
}

/// All files of the folder "bad" beside those patches; none where no folder is told.
/// @throws std::runtime_error as patches()
inline std::vector<std::filesystem::path> bad_files() {
  std::vector<std::filesystem::path> paths;
  const char* folder = std::getenv("PLANISH_TEST_DATA");
  if (folder == nullptr) return paths;
  const std::filesystem::path bad = std::filesystem::path(folder) / "bad";
  for (const auto& entry : std::filesystem::directory_iterator(bad))
    paths.push_back(entry.path());
  if (paths.empty()) throw std::runtime_error("no file in " + bad.string());
  return paths;
}

}  // namespace planish
