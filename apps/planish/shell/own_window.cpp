#include "shell/own_window.h"

#include <algorithm>
#include <exception>
#include <istream>
#include <optional>
#include <ostream>
#include <string_view>
#include <system_error>
#include <vector>

#include <planish/io/read_mesh.h>

#include "core/likely_units.h"
#include "flags/units.h"
#include "platform/path.h"
#include "run.h"
#include "shell/failures.h"
#include "shell/text.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view k_what_to_do =
    "Planish makes patterns of curved patches.\n\n"
    "Drop a mesh (.obj, .off, .ply or .stl) onto planish.exe: its pattern is written into a "
    "folder\n"
    "beside the mesh, and a page about it opens.\n\n"
    "For everything else open a terminal and type: planish --help\n";

void wait_for_enter(const OwnWindow& window) {
  window.err << "\nPress Enter to close this window." << std::flush;
  std::string line;
  std::getline(window.in, line);
}

/// The diagonals of the meshes that were dropped, model units, but for those whose files state a
/// unit. What cannot be read is left out: running says why.
std::vector<double> sizes_of(std::span<const std::string> dropped) {
  std::vector<double> sizes;
  for (const std::string& name : dropped) {
    std::error_code none;
    if (!fs::is_regular_file(path_of(name), none)) continue;
    try {
      const ReadResult file = read_mesh(path_of(name));
      if (!file.unit) sizes.push_back(bounding_box_diagonal(file.mesh));
    } catch (const std::exception&) {
      continue;  // whatever it is, the run meets it too
    }
  }
  return sizes;
}

/// "mm (6.28 mm), cm (62.8 mm), ..., in (160 mm)": how long that is in each unit.
std::string sizes_text(double size) {
  std::string text;
  for (const Unit unit : k_units) {
    text += (text.empty() ? "" : ", ") + std::string(to_string(unit)) + " (" +
            digits(size * millimetres_per(unit), 3) + " mm)";
  }
  return text;
}

/// Most mesh files do not say their unit, and a file that is dropped comes without flags. Where a
/// mesh would be too small or too large in millimetres, asks until there is an answer.
std::optional<Unit> unit_of_dropped(std::span<const std::string> dropped, const OwnWindow& window) {
  const std::vector<double> sizes = sizes_of(dropped);
  const auto unusual = std::find_if(sizes.begin(), sizes.end(), [](double size) {
    return size < k_small_piece || size > k_large_piece;
  });
  if (unusual == sizes.end()) return std::nullopt;
  window.err << "In which unit is the mesh? Its file does not say, and it would be so long:\n"
             << sizes_text(*unusual) << "\nType mm, cm, dm, m or in, and Enter: " << std::flush;
  for (std::string word; std::getline(window.in, word);) {
    word.erase(0, word.find_first_not_of(" \t\r"));
    word.erase(word.find_last_not_of(" \t\r") + 1);
    if (const auto unit = unit_of_word(word)) return *unit;
    window.err << (word.empty() ? "" : word + " is not one of them. ")
               << "Type mm, cm, dm, m or in, and Enter: " << std::flush;
  }
  return std::nullopt;
}

/// Where the pattern of what was dropped goes. That of several files has a folder of its own, as
/// one for the first file alone may be there.
fs::path folder_beside(const std::string& dropped, bool is_alone) {
  const fs::path path = path_of(dropped);
  fs::path name = path.has_filename() ? path.stem() : path.parent_path().filename();
  name += path_of(is_alone ? "-pattern" : "-and-more-pattern");
  return (path.has_filename() ? path : path.parent_path()).parent_path() / name;
}

/// The page that a run wrote: of one patch or of a product. A folder may hold an older one as well.
std::optional<fs::path> newest_page(const fs::path& folder) {
  std::optional<fs::path> newest;
  fs::file_time_type time;
  for (const char* const name : {"report.html", "garment.html"}) {
    const fs::path page = folder / path_of(name);
    std::error_code missing;
    const auto written = fs::last_write_time(page, missing);
    if (missing || (newest && written <= time)) continue;
    newest = page;
    time = written;
  }
  return newest;
}

/// Says where the page is if it cannot be opened.
/// @return whether it was opened
bool show(const fs::path& folder, const OwnWindow& window) {
  const std::optional<fs::path> page = newest_page(folder);
  if (!page) return false;
  const std::string cause = window.open(fs::absolute(*page));
  if (!cause.empty())
    window.err << "note: open " << utf8_of(*page) << " in a browser (" << cause << ")\n";
  return cause.empty();
}

int flatten_dropped(std::span<const std::string> words, const OwnWindow& window,
                    const RunContext& context) {
  const fs::path folder = folder_beside(words.front(), words.size() == 1);
  const std::optional<Unit> unit = unit_of_dropped(words, window);
  std::vector<std::string> args = {"flatten", "--output", utf8_of(folder)};
  if (unit) args.insert(args.end(), {"--unit", std::string(to_string(*unit))});
  args.emplace_back("--");
  args.insert(args.end(), words.begin(), words.end());
  const int exit_code = run(args, window.out, window.err, context);
  const bool is_seen = exit_code == k_exit_done && show(folder, window);
  if (!is_seen) wait_for_enter(window);
  return exit_code;
}

}  // namespace

bool are_dropped(std::span<const std::string> words) {
  return !words.empty() && std::all_of(words.begin(), words.end(), [](const std::string& word) {
    std::error_code none;
    const fs::path path = path_of(word);
    return path.is_absolute() && fs::exists(path, none);
  });
}

int run_in_own_window(std::span<const std::string> words, const OwnWindow& window,
                      const RunContext& context) {
  if (words.empty()) {
    window.err << k_what_to_do;
    wait_for_enter(window);
    return k_exit_usage;
  }
  if (are_dropped(words)) return flatten_dropped(words, window, context);
  return run(words, window.out, window.err, context);
}

}  // namespace planish::cli
