#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace planish::cli {

/// The cells of each line of comma-separated values; a text in quotes is one cell.
inline std::vector<std::vector<std::string>> table_in(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    auto& row = rows.emplace_back(1);
    bool quoted = false;
    for (const char c : line) {
      if (c == '"') {
        quoted = !quoted;
      } else if (c == ',' && !quoted) {
        row.emplace_back();
      } else {
        row.back() += c;
      }
    }
  }
  return rows;
}

}  // namespace planish::cli
