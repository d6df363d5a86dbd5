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

}  // namespace planish::cli
