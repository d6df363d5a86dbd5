#pragma once

#include <cstddef>
#include <vector>

#include "solve/supernodes.h"

namespace planish {

/// A tree of supernodes taken apart for threads: subtrees that know nothing of one another, and
/// what is above them. In stages, one after the other, as what the parts of a stage leave to their
/// parents takes memory until these are factored.
struct Subtrees {
  struct Range {
    std::size_t begin, end;  ///< supernodes of a whole subtree, children before parents
  };
  std::vector<Range> parts;  ///< in each stage the one with most work first
  std::vector<Index> top;    ///< all other supernodes, children before parents
  /// Parts and supernodes of the top up to these belong to the stage and to those before it. No
  /// supernode of the top has a child in a later stage.
  struct Stage {
    std::size_t parts_end, top_end;
  };
  std::vector<Stage> stages;
};

/// Work of factoring a supernode, about one per multiplication.
double work_of(const Supernodes& tree, std::size_t node);

/// Parts of at most a sixteenth of one thread's share of the work, stages of an eighth to three
/// eighths of all where the tree allows that.
/// @param tree in postorder
Subtrees split_tree(const Supernodes& tree, unsigned threads);

}  // namespace planish
