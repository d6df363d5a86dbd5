#pragma once

#include "shell/command.h"
#include "shell/failures.h"

namespace planish::cli {

/// --match-seams, for verbs that lay flat.
inline Flag match_seams_flag() {
  return {"--match-seams", "",
          "keep the length of every border edge, or in a product of every edge along a seam, so "
          "that sewn sides stay equally long"};
}

/// --least-stretch, for the same.
inline Flag least_stretch_flag() {
  return {"--least-stretch", "",
          "write the pattern of least rms strain; without this flag the rms strain may be up to 6 "
          "% higher, to make the largest strains as small as possible"};
}

/// --no-match-seams, for the verb that makes products.
inline Flag no_match_seams_flag() {
  return {
      "--no-match-seams", "",
      "allow the two sides of a product's seams to differ in length (default: equal to 0.1 mm)"};
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
