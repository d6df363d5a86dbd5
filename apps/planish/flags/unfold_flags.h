#pragma once

#include "shell/command.h"
#include "shell/failures.h"

namespace planish::cli {

/// --match-seams, for verbs that lay flat.
inline Flag match_seams_flag() {
  return {
      "--match-seams", "",
      "keep the length of every border edge, or in a product of those along seams, so that what "
      "is sewn together stays equally long"};
}

/// --least-stretch, for the same.
inline Flag least_stretch_flag() {
  return {"--least-stretch", "",
          "the pattern of least stretch; without it, up to 6 % more rms strain make the largest "
          "strains as small as they get"};
}

/// --no-match-seams, for the verb that makes products.
inline Flag no_match_seams_flag() {
  return {"--no-match-seams", "",
          "let the two sides of a product's seams become unequal (default: equal to 0.1 mm)"};
}

/// Whether the seams of a product are to match.
/// @throws UsageError where both flags are there
inline bool matches_seams_of_product(const Arguments& arguments) {
  const bool is_off = arguments.has("--no-match-seams");
  if (is_off && arguments.has("--match-seams"))
    throw UsageError("--match-seams and --no-match-seams do not go together: take one");
  return !is_off;
}

}  // namespace planish::cli
