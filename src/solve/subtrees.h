#pragma once

#include <cstddef>
#include <vector>

#include "solve/supernodes.h"

namespace planish {

/// A tree of supernodes taken apart for threads: subtrees that know nothing of one another, and
/// what is above them.
struct Subtrees {
  struct Range {
    std::size_t begin, end;  ///< supernodes of a whole subtree, children before parents
  };
  std::vector<Range> parts;  ///< the one with most work first
  std::vector<Index> top;    ///< all other supernodes, children before parents
};

/// Work of factoring a supernode, about one per multiplication.
double work_of(const Supernodes& tree, std::size_t node);

/// Parts of at most an eighth of one thread's share of the work where the tree allows that.
/// @param tree in postorder
Subtrees split_tree(const Supernodes& tree, unsigned threads);

}  // namespace planish
