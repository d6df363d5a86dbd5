#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <planish/flatten/product.h>
#include <planish/io/model.h>

#include "shell/session.h"

namespace planish::cli {

/// A piece of a file. Pieces that are not used are kept too: the orientation of the others is
/// judged against them.
struct ReadPiece {
  ProductPatch patch;
  bool is_taken = true;
  MeshFormat format = MeshFormat::obj;
  std::string in_file = {};  ///< its name there; in the product it may have another
  /// Names that several pieces have together, as a piece and its mirror image.
  std::vector<std::string> asked_as = {};
  bool is_image = false;   ///< the mirror image of the one before it
  std::string style = {};  ///< name that all sizes of it have; empty for one size
};

/// What stands for the pieces of a file that cannot be read.
/// @pre called in a handler
ReadPiece unreadable(std::string name, const std::string& path, std::size_t group);

/// The pieces of all files, before flags choose among them by the names that they get in the
/// product.
struct AllPieces {
  std::vector<ReadPiece> pieces = {};
  std::vector<std::string> known = {};  ///< names in the files, by which each file was read
  Model last = {};                      ///< of the last file of which something was taken
  std::string path = {};                ///< of that

  /// Adds those of a file.
  void add(Model model, const std::string& from, std::size_t group);
  /// How many are taken.
  std::size_t taken() const;
};

/// Those with a number behind names that are there already.
AllPieces with_distinct_names(AllPieces all);

/// Takes and leaves out what flags call by names that no file has: "Front-2" of the second file
/// with a piece Front, "Front, mirrored".
/// @throws UsageError where a name could mean two pieces, Error unknown_name
void choose_by_names_of_product(AllPieces& all, const Arguments& arguments);

/// Turns over the pieces that are inside out against a neighbour, with their mirror images, but
/// with --strict; notes tell which.
void turn_inside_out(AllPieces& all, const Arguments& arguments, Session& session);

}  // namespace planish::cli
