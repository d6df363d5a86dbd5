#pragma once

// DXF files as entities, for tests.

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace planish {

struct DxfTag {
  int code;
  std::string value;
};

/// All tags from one "0" to the next.
using DxfEntity = std::vector<DxfTag>;

inline std::vector<DxfEntity> read_dxf(const std::string& dxf) {
  std::vector<DxfEntity> entities;
  std::istringstream lines(dxf);
  for (std::string code, value; std::getline(lines, code) && std::getline(lines, value);) {
    if (code == "0") entities.emplace_back();
    entities.back().push_back({std::stoi(code), value});
  }
  return entities;
}

/// Empty where there is none.
inline std::string value_of(const DxfEntity& entity, int code) {
  const auto found = std::find_if(entity.begin(), entity.end(),
                                  [&](const DxfTag& tag) { return tag.code == code; });
  return found == entity.end() ? "" : found->value;
}

inline double real_of(const DxfEntity& entity, int code) {
  return std::stod(value_of(entity, code));
}

inline std::vector<DxfEntity> all_of_kind(const std::string& dxf, const std::string& kind) {
  std::vector<DxfEntity> found;
  for (const DxfEntity& entity : read_dxf(dxf)) {
    if (entity.front().value == kind) found.push_back(entity);
  }
  return found;
}

inline std::vector<std::string> values(const std::vector<DxfEntity>& entities, int code) {
  std::vector<std::string> found;
  found.reserve(entities.size());
  for (const DxfEntity& entity : entities)
    found.push_back(value_of(entity, code));
  return found;
}

}  // namespace planish
