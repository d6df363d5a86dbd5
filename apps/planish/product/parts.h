#pragma once

#include <optional>
#include <string>
#include <vector>

#include <planish/flatten/product.h>
#include <planish/io/model.h>

#include "flags/units.h"
#include "product/product_file.h"
#include "shell/session.h"

namespace planish::cli {

/// Behind the name of a piece, for the mirror image that a product file asks for.
inline const std::string k_mirrored_piece = ", mirrored";

/// Where a patch comes from and goes to.
struct PatchPlace {
  std::string folder;  ///< safe name of its folder, unlike that of every other
  MeshFormat format = MeshFormat::obj;
};

/// What the main job is to be done on.
struct ProductInput {
  /// Names as the files have them; those that repeat one have a number behind it.
  std::vector<ProductPatch> patches;
  std::vector<PatchPlace> places;  ///< of the patches
  std::string path;                ///< of the file where there is one patch
  Model whole;                     ///< where there is one patch: its file
  /// Files that have nothing to do with each other: each is its own group of patches.
  bool is_batch = false;
  /// It is described by a file: several patches by its own account, even where it lists one.
  bool is_described = false;
  std::vector<NamedSeam> seams = {};         ///< of a product that is described
  std::vector<NamedSettings> settings = {};  ///< of its pieces, which are there
  /// Of each patch the name that all sizes of it have; empty for those of one size, and without.
  std::vector<std::string> styles = {};
  std::optional<Plane> symmetric_in = {};  ///< that of --symmetric
  std::vector<std::string> left_out = {};  ///< names of the pieces that flags leave out
};

/// Reads mesh files, all mesh files of folders in the order of their names, or those that a product
/// file lists, and takes their pieces as the flags ask, with coordinates multiplied by --scale.
/// Patches that are inside out against a neighbour along their seam, also one that is left out, are
/// turned over, but with --strict. Names are those that patches have where nothing is left out, and
/// --only and --without know them too. Seams to patches that are left out are gone. A file of
/// several that cannot be read is a patch with that failure.
/// @param paths one at least; a product file must be the only one
/// @param arguments as read_model() has them. The unit of a piece is that of the product file, else
///   --unit, else what its own file states; pieces are scaled to the unit of the run
/// @param as_product several files are parts of one product; else they are a batch
/// @throws UsageError for a product file beside others; Error what read_mesh() throws of the only
///   file; file_unreadable for a folder that holds no mesh file; as read_product_file(),
///   malformed_file for a seam between pieces that are not there; as read_model() for names that
///   are not there
ProductInput read_product(Session& session, const std::vector<std::string>& paths,
                          const Arguments& arguments, bool as_product);

/// Safe folders for all patches.
std::vector<PatchPlace> places_of(const std::vector<ProductPatch>& patches,
                                  const std::vector<MeshFormat>& formats);

/// The mesh files in a folder, not in folders below, in the order of their names. A note names
/// models that cannot be read.
/// @throws Error file_unreadable where it cannot be read or holds no mesh file
std::vector<std::string> mesh_files_in(Session& session, const std::string& folder);

}  // namespace planish::cli
