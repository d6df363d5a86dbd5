#include "shell/nearest.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace planish::cli {

namespace {

bool same_letter(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

bool starts_with(std::string_view word, std::string_view start) {
  return start.size() <= word.size() &&
         std::equal(start.begin(), start.end(), word.begin(), same_letter);
}

}  // namespace

// Optimal string alignment, three rows of the table at a time.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j)
    row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = last[j - 1] + (same_letter(a[i - 1], b[j - 1]) ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, change});
      const bool swapped =
          i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) && same_letter(a[i - 2], b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::string nearest_hint(std::string_view word, std::span<const std::string> known) {
  const std::string* nearest = nullptr;
  std::size_t smallest = 0;
  for (const std::string& candidate : known) {
    // The beginning of a word, as in --max-dev, is as good as a letter mistyped.
    const bool begun = word.size() > 3 && starts_with(candidate, word);
    const bool bare = candidate.ends_with(word) && candidate.starts_with("--") &&
                      candidate.size() == word.size() + 2;  // "help" for "--help"
    const std::size_t distance = begun || bare ? 1 : edit_distance(word, candidate);
    if (nearest != nullptr && distance >= smallest) continue;
    nearest = &candidate;
    smallest = distance;
  }
  if (nearest == nullptr) return {};
  const bool close = smallest <= std::max<std::size_t>(1, word.size() / 3);
  return close ? "; did you mean " + *nearest + "?" : "; the nearest is " + *nearest;
}

}  // namespace planish::cli
