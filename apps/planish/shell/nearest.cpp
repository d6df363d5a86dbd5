#include "shell/nearest.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace planish::cli {

namespace {

char small_letter(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

bool same_letter(char a, char b) {
  return small_letter(a) == small_letter(b);
}

bool starts_with(std::string_view word, std::string_view start) {
  return start.size() <= word.size() &&
         std::equal(start.begin(), start.end(), word.begin(), same_letter);
}

/// How far a word may be from the one that was meant. In words of one or two letters, as units and
/// sizes of paper, every letter counts.
std::size_t near_enough(std::string_view word) {
  const std::size_t letters = word.size() - std::min(word.find_first_not_of('-'), word.size());
  return letters < 3 ? 0 : std::max<std::size_t>(1, letters / 4);
}

}  // namespace

bool same_word(std::string_view a, std::string_view b) {
  return a.size() == b.size() && starts_with(a, b);
}

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
  if (nearest == nullptr || smallest > near_enough(word)) return {};
  return "; did you mean " + *nearest + "?";
}

}  // namespace planish::cli
