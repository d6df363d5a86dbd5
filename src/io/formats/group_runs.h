#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <planish/io/read_mesh.h>

namespace planish {

/// Collects which triangles of a file belong together, by names that hold until the next one.
class GroupRuns {
 public:
  /// Triangles from number `first` on are of this name; one without letters is "default".
  void begin(std::string_view name, std::size_t first);

  /// The groups that have triangles; none where there are fewer than two. Triangles before the
  /// first name are of "default".
  FaceGroups spread(std::string kind, std::size_t triangle_count) const;

 private:
  struct Run {
    std::size_t first;
    std::size_t name;
  };
  std::size_t number_of(std::string_view name);

  std::vector<Run> runs_;
  std::vector<std::string> names_;
  std::map<std::string, std::size_t, std::less<>> numbers_;
};

}  // namespace planish
