#pragma once

#include "shell/command.h"

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
          "the pattern of least rms strain; without it, up to 6 % more of that make the largest "
          "strains as small as they get"};
}

}  // namespace planish::cli
