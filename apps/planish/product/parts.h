#pragma once

#include <optional>
#include <string>
#include <vector>

#include <planish/flatten/product.h>
#include <planish/io/read_mesh.h>

#include "flags/cut_flag.h"
#include "shell/session.h"

namespace planish::cli {

/// Where a patch comes from and goes to.
struct PatchPlace {
  std::string folder;  ///< safe name of its folder, unlike that of every other
  MeshFormat format = MeshFormat::obj;
};

/// What the main job is to be done on.
struct ProductInput {
  std::vector<ProductPatch> patches;  ///< names as the files have them
  std::vector<PatchPlace> places;     ///< of the patches
  std::string path;                   ///< of the file where there is one patch
  ReadResult whole;                   ///< where there is one patch: the file as it is
  /// Files that have nothing to do with each other: each is its own group of patches.
  bool is_batch = false;
};

/// Reads a mesh file, or all mesh files of a folder in the order of their names, and divides what
/// it reads into patches: by the groups that the files have, then into pieces that hang together.
/// A file of several that cannot be read is a patch with that failure.
/// @param as_product the files of a folder are parts of one product; else they are a batch
/// @throws Error what read_mesh() throws of the only file; file_unreadable for a folder that holds
///   no mesh file
ProductInput read_product(Session& session, const std::string& path, bool as_product);

/// Cuts an input of one patch open as --cut says; where that divides it, it has several patches
/// from then on.
/// @throws UsageError for an input of several patches, Error as cut_as_asked()
std::optional<CutDone> cut_product(ProductInput& input, const Arguments& arguments,
                                   Session& session);

/// The mesh files in a folder, not in folders below, in the order of their names. A note names
/// models that cannot be read.
/// @throws Error file_unreadable where it cannot be read or holds no mesh file
std::vector<std::string> mesh_files_in(Session& session, const std::string& folder);

/// Names of folders and files that are sound everywhere and lead nowhere else: letters, digits,
/// dots, hyphens, underscores and what is not ASCII; other characters become underscores. No two
/// are equal, also where the system takes small and large letters for the same.
std::vector<std::string> safe_names(const std::vector<std::string>& names);

}  // namespace planish::cli
