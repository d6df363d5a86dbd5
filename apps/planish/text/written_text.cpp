#include "text/written_text.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "platform/path.h"
#include "shell/text.h"

namespace planish::cli {

namespace {

/// What files are for, and their roles, in the order in which people need them.
struct Purpose {
  std::string_view text;
  std::vector<std::string_view> roles;
};

const std::vector<Purpose>& purposes() {
  static const std::vector<Purpose> k_purposes = {
      {"the result in 3D and in figures, in a browser", {"report_html"}},
      {"the pattern, to print at 100 %", {"pattern_pdf"}},
      {"the same on pages to join, at 100 %", {"pattern_pages"}},
      {"the pattern, for cutters and CAD", {"pattern", "pattern_dxf", "pattern_plt"}},
      {"the pattern of the design as it is",
       {"as_designed", "as_designed_dxf", "as_designed_pdf", "as_designed_plt"}},
      {"the pattern as a mesh", {"flat"}},
      {"the surface of that pattern", {"processed"}},
      {"that surface with its pattern as texture", {"textured"}},
      {"lengths of the border's edges", {"edge_lengths"}},
      {"figures of every sweep", {"history"}},
      {"strain, curvature and moves, by place", {"fields", "fields_vertices", "fields_triangles"}},
      {"all figures, for programs", {"report_json"}}};
  return k_purposes;
}

/// "pattern.svg, .dxf": names that differ in their extension alone.
std::string joined_names(const std::vector<std::filesystem::path>& names) {
  std::string text;
  for (const std::filesystem::path& name : names) {
    const bool is_same = !text.empty() && name.stem() == names.front().stem();
    text += (text.empty() ? "" : ", ") + utf8_of(is_same ? name.extension() : name);
  }
  return text;
}

std::string line_of(const std::string& names, std::string_view purpose) {
  constexpr std::size_t k_names = 32;
  const std::string shown = left(names, k_names) + (names.size() < k_names ? "" : "  ");
  return "  " + (purpose.empty() ? names : shown + std::string(purpose)) + "\n";
}

std::string page_line(const std::filesystem::path& page) {
  return "\nOpen " + utf8_of(page) + " in a browser to see the result.\n";
}

}  // namespace

std::string written_text(const std::vector<OutputFile>& files) {
  std::string text = "\nWritten:\n";
  for (const OutputFile& file : files)
    text += line_of(utf8_of(file.path), {});
  const auto page = std::find_if(files.begin(), files.end(), [](const OutputFile& file) {
    return file.path.extension() == path_of(".html");
  });
  return page == files.end() ? text : text + page_line(page->path);
}

std::string written_text(const std::filesystem::path& folder, const WrittenFiles& paths,
                         const std::vector<OutputFile>& files) {
  const auto name_of = [&folder](const std::filesystem::path& path) {
    return path.parent_path() == folder ? path.filename() : path;
  };
  std::string text = "\nWritten into " + utf8_of(folder) + ":\n";
  for (const Purpose& purpose : purposes()) {
    std::vector<std::filesystem::path> names;
    for (const std::string_view role : purpose.roles) {
      const auto found = paths.find(std::string(role));
      if (found != paths.end()) names.push_back(name_of(path_of(found->second)));
    }
    if (!names.empty()) text += line_of(joined_names(names), purpose.text);
  }
  for (const OutputFile& file : files) {
    const bool has_role = std::any_of(paths.begin(), paths.end(), [&](const auto& role) {
      return path_of(role.second) == file.path;
    });
    if (!has_role) text += line_of(utf8_of(name_of(file.path)), {});
  }
  const auto page = paths.find("report_html");
  return page == paths.end() ? text : text + page_line(path_of(page->second));
}

}  // namespace planish::cli
