#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <planish/flatten/product.h>
#include <planish/io/write_file.h>
#include <planish/pattern/pattern_options.h>
#include <planish/report/html_report.h>
#include <planish/report/json_report.h>

#include "cut/cut_flag.h"
#include "output/pattern_output.h"
#include "piece/piece_settings.h"
#include "product/parts.h"
#include "shell/command.h"
#include "shell/session.h"

namespace planish::cli {

struct NestRequest;

/// The main job on a product of several patches.
struct ProductJob {
  std::string path;  ///< of the input, for people
  std::vector<ProductPatch> patches;
  std::vector<PatchPlace> places;        ///< of each patch
  bool is_batch = false;                 ///< as ProductInput has it
  std::vector<NamedSeam> seams = {};     ///< as ProductInput has them
  std::vector<std::string> styles = {};  ///< likewise
  std::optional<CutOutcome> cut = {};    ///< that made the patches; nothing where none was cut
  std::filesystem::path folder;          ///< each patch's is in it
  ProductOptions options;
  std::vector<PieceRequest> requests;       ///< of each patch, what is asked for it
  std::vector<PatternOptions> annotations;  ///< of each patch, with notches on seams
  std::vector<WrittenFiles> paths;          ///< of each patch, what is written of it
  /// Makes the files of a patch. Called from any thread.
  std::function<std::vector<OutputFile>(const FlattenReport&, std::size_t patch,
                                        const PatternOptions&)>
      files_of;
  /// How all patches are laid on sheets together; nothing where they are not.
  std::shared_ptr<const NestRequest> nest = {};
  std::vector<PatternFormat> formats = {};  ///< of patterns
  PatternOutput output = {};                ///< how they are written
  PageProject project = {};                 ///< of the run
};

/// --product, --resume and --seam-tolerance.
std::vector<Flag> product_flags();

/// @param is_of_several there were several patches, of which one is used: flags about seams are
///   allowed, as its orientation is judged along the seams with the others
/// @throws UsageError for flags that make sense only with several patches
void refuse_product_flags(const Arguments& arguments, bool is_of_several);

/// @throws UsageError for flags of seams, which are not searched between the files of a batch
void refuse_seam_flags(const Arguments& arguments);

/// What each patch gets on its pattern: what is asked for it, its name, and the notches on its
/// seams and their numbers.
/// @throws UsageError for flags that make sense only with one patch, Error as notches_on_seams()
std::vector<PatternOptions> annotations_of_patches(const std::vector<PieceRequest>& requests,
                                                   const std::vector<ProductPatch>& patches,
                                                   const Arguments& arguments);

/// flatten_product() with files: writes each patch into its folder as it is done, then the whole
/// into garment.json. A line says what became of each patch.
/// @throws Error as Session::write()
CommandResult run_product(const ProductJob& job, const Arguments& arguments, Session& session);

}  // namespace planish::cli
