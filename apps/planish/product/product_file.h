#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <planish/core/unit.h>
#include <planish/measure/material.h>

#include "piece/piece_settings.h"

namespace planish::cli {

/// A piece as a product file has it. What it does not say, the flags of the command line say.
struct RequestedPiece {
  std::string file;                         ///< path of its mesh file
  std::optional<std::string> name;          ///< for label, folder and reports
  std::optional<Material> material;         ///< what it is cut from: its limits of strain
  std::optional<Unit> unit;                 ///< of the numbers in the file
  std::optional<int> quantity;              ///< how many to cut, the mirrored ones among them
  bool mirrored = false;                    ///< half of them are mirror images
  std::string style = {};                   ///< name that all sizes of it have; empty for one size
  std::size_t size = 0;                     ///< number of its size, from 0
  std::size_t entry = 0;                    ///< of the list in the file, from 0
  std::vector<PieceSetting> settings = {};  ///< all others, as those of --piece
};

/// The name of a seam between two pieces.
struct NamedSeam {
  std::string name;
  std::array<std::string, 2> between;  ///< names of the pieces; equal for a dart
};

/// A product as a file describes it.
struct ProductFile {
  std::vector<RequestedPiece> pieces;   ///< at least one
  std::vector<NamedSeam> seams;         ///< in the order in which seams between two pieces get them
  std::vector<std::string> sizes = {};  ///< of all pieces, in the order of the file
};

/// Whether the path is that of a product file: one that ends with .json.
bool is_product_file(const std::string& path);

/// Reads a product file (docs/product_file.md), strictly: keys that are not known are errors.
/// Paths in it are relative to its folder.
/// @throws Error file_unreadable, malformed_file naming the place in the file, as in "pieces[1]"
ProductFile read_product_file(const std::string& path);

}  // namespace planish::cli
