#include "io/formats/group_runs.h"

#include <utility>

namespace planish {

namespace {

constexpr const char* k_nameless = "default";

}  // namespace

std::size_t GroupRuns::number_of(std::string_view name) {
  const auto known = numbers_.find(name);
  if (known != numbers_.end()) return known->second;
  names_.emplace_back(name);
  numbers_.emplace(names_.back(), names_.size() - 1);
  return names_.size() - 1;
}

void GroupRuns::begin(std::string_view name, std::size_t first) {
  if (name.empty()) name = k_nameless;
  if (runs_.empty() && first > 0) runs_.push_back({0, number_of(k_nameless)});
  if (!runs_.empty() && runs_.back().first == first) runs_.pop_back();  // it has no triangle
  runs_.push_back({first, number_of(name)});
}

FaceGroups GroupRuns::spread(std::string kind, std::size_t triangle_count) const {
  constexpr auto none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> place(names_.size(), none);  // among the names that are used
  std::vector<std::size_t> used;
  used.reserve(names_.size());
  for (const Run& run : runs_) {
    if (run.first == triangle_count || place[run.name] != none) continue;
    place[run.name] = used.size();
    used.push_back(run.name);
  }
  if (used.size() < 2) return {};
  FaceGroups groups;
  groups.kind = std::move(kind);
  groups.names.reserve(used.size());
  for (const std::size_t name : used)
    groups.names.push_back(names_[name]);
  groups.of_triangle.reserve(triangle_count);
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    const std::size_t end = r + 1 < runs_.size() ? runs_[r + 1].first : triangle_count;
    groups.of_triangle.resize(end, static_cast<Index>(place[runs_[r].name]));
  }
  return groups;
}

}  // namespace planish
