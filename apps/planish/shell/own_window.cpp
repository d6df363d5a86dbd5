#include "shell/own_window.h"

#include <algorithm>
#include <cmath>
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

/// The longest diagonal among meshes that were dropped, model units; 0 where none can be read: then
/// running says why.
double longest_of(std::span<const std::string> dropped) {
  double longest = 0.0;
  for (const std::string& name : dropped) {
    std::error_code none;
    if (!fs::is_regular_file(path_of(name), none)) continue;
    try {
      longest = std::max(longest, bounding_box_diagonal(read_mesh(path_of(name)).mesh));
    } catch (const Error&) {
      continue;
    }
  }
  return longest;
}

/// Mesh files do not say their unit, and a file that is dropped comes without flags. Where the
/// meshes would be too small or too large in millimetres, asks; Enter alone is for the likeliest
/// unit.
Unit unit_of_dropped(std::span<const std::string> dropped, const OwnWindow& window) {
  const double longest = longest_of(dropped);
  const std::vector<Unit> likely = likely_units(longest, Unit::mm);
  const bool is_usual = k_small_piece <= longest && longest <= k_large_piece;
  if (is_usual || likely.empty()) return Unit::mm;
  const std::string best(to_string(likely.front()));
  window.err << "What is dropped is " << digits(longest, 3)
             << " long in the unit of its file, which the file does not say.\nIn " << best
             << " that is " << digits(longest * millimetres_per(likely.front()), 3)
             << " mm. Type mm, cm, dm, m or in, and Enter; Enter alone takes " << best << ": "
             << std::flush;
  for (std::string word; std::getline(window.in, word);) {
    word.erase(0, word.find_first_not_of(" \t\r"));
    word.erase(word.find_last_not_of(" \t\r") + 1);
    if (word.empty()) return likely.front();
    if (const auto unit = unit_of_word(word)) return *unit;
    window.err << Shown{word} << " is not one of mm, cm, dm, m and in. Which is it? " << std::flush;
  }
  return likely.front();
}

/// Where the pattern of a dropped file goes.
fs::path folder_beside(const std::string& dropped) {
  const fs::path path = path_of(dropped);
  fs::path name = path.has_filename() ? path.stem() : path.parent_path().filename();
  name += path_of("-pattern");
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
  const fs::path folder = folder_beside(words.front());
  const Unit unit = unit_of_dropped(words, window);
  std::vector<std::string> args = {
      "flatten", "--output", utf8_of(folder), "--unit", std::string(to_string(unit)), "--"};
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
