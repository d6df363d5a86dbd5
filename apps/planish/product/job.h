#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <planish/flatten/flatten.h>
#include <planish/io/write_file.h>
#include <planish/pattern/pattern_options.h>

#include "product/parts.h"
#include "shell/command.h"
#include "shell/session.h"

namespace planish::cli {

/// The files of one patch, and its report among them.
struct PatchFiles {
  std::vector<OutputFile> files;
  std::string report;
};

struct NestRequest;

/// The main job on a product of several patches.
struct ProductJob {
  std::string path;  ///< of the input, for people
  std::vector<ProductPatch> patches;
  std::filesystem::path folder;  ///< each patch's is in it
  FlattenOptions options;
  std::vector<PatternOptions> annotations;  ///< of each patch
  /// Makes the files of a patch that go into a folder. Called from any thread.
  std::function<PatchFiles(const FlattenReport&, MeshFormat, const PatternOptions&,
                           const std::filesystem::path& folder)>
      files_of;
  /// How all patches are laid on sheets together; nothing where they are not.
  std::shared_ptr<const NestRequest> nest = {};
};

/// --resume and --seam-tolerance.
std::vector<Flag> product_flags();

/// @throws UsageError for flags that make sense only with several patches
void refuse_product_flags(const Arguments& arguments);

/// What each patch gets on its pattern: what the flags ask of all, its name, and the notches on its
/// seams.
/// @throws UsageError for flags that make sense only with one patch, Error as seam_notches_from()
std::vector<PatternOptions> annotations_of_patches(const PatternOptions& annotations,
                                                   const std::vector<ProductPatch>& patches,
                                                   const Arguments& arguments);

/// Flattens every patch, each on one thread, and writes each into its folder as it is done; then
/// the seams of the whole into garment.json. A patch that fails is told by name and does not stop
/// the others. Results do not depend on the number of threads.
/// @throws Error as Session::write()
CommandResult run_product(const ProductJob& job, const Arguments& arguments, Session& session);

}  // namespace planish::cli
