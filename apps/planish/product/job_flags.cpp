#include <algorithm>
#include <utility>

#include "flags/annotation_flags.h"
#include "flags/unfold_flags.h"
#include "piece/single_patch_flags.h"
#include "product/job.h"
#include "product/rename.h"
#include "product/seams.h"
#include "shell/failures.h"

namespace planish::cli {

namespace {

/// The seams of a mirror image are not known, as nothing says where it lies.
void refuse_notches_of_mirrored(const std::vector<ProductPatch>& patches,
                                const Arguments& arguments) {
  const bool has_images =
      std::any_of(patches.begin(), patches.end(),
                  [](const ProductPatch& patch) { return patch.name.ends_with(k_mirrored_piece); });
  if (!has_images || !arguments.has("--seam-notches")) return;
  throw UsageError(
      "flag --seam-notches does not go with \"mirrored\" pieces: list the other one as a file of "
      "its own");
}

}  // namespace

std::vector<Flag> product_flags() {
  return {{"--product", "",
           "take several files as the parts of one product, and find the seams between them"},
          rename_flag(),
          piece_flag(),
          {"--resume", "",
           "with several patches: keep results that are there, complete and made by the same job"},
          {"--seam-tolerance",
           "LENGTH",
           "largest distance between borders that are one seam, as 0.5mm (default: a tenth of an "
           "edge's length)",
           0,
           false,
           {.range = {.min = 0.0}}}};
}

void refuse_product_flags(const Arguments& arguments, bool is_of_several) {
  std::vector<std::string> refused = {"--rename", "--resume"};
  if (!is_of_several) refused.insert(refused.end(), {"--product", "--seam-tolerance"});
  for (const std::string& flag : refused) {
    if (!arguments.has(flag)) continue;
    throw UsageError("flag " + flag + " goes with several patches; the input has one");
  }
}

void refuse_seam_flags(const Arguments& arguments) {
  for (const char* flag : {"--seam-notches", "--seam-tolerance"}) {
    if (!arguments.has(flag)) continue;
    throw UsageError("flag " + std::string(flag) +
                     " goes with seams, and between the files of a batch none are searched; add "
                     "--product where they are the parts of one product");
  }
}

std::vector<PatternOptions> annotations_of_patches(const std::vector<PieceRequest>& requests,
                                                   const std::vector<ProductPatch>& patches,
                                                   const Arguments& arguments) {
  refuse_single_patch_flags(arguments, "the input has several: take one with --only NAME");
  refuse_notches_of_mirrored(patches, arguments);
  std::vector<TriMesh> meshes;
  std::vector<std::string> names;
  std::vector<std::size_t> groups;
  meshes.reserve(patches.size());
  names.reserve(patches.size());
  groups.reserve(patches.size());
  for (const ProductPatch& patch : patches) {
    meshes.push_back(patch.mesh);
    names.push_back(patch.name);
    groups.push_back(patch.group);
  }
  std::vector<std::vector<Notch>> notches = notches_on_seams(arguments, meshes, names);
  const std::vector<Seam> seams =
      find_seams_in_groups(meshes, groups, seam_tolerance_from(arguments));
  std::vector<std::vector<SeamNumber>> numbers = numbers_of_seams(arguments, seams, meshes, names);
  std::vector<PatternOptions> result;
  result.reserve(requests.size());
  for (const PieceRequest& request : requests)
    result.push_back(request.annotations);
  if (matches_seams_of_product(arguments)) {
    for (const Seam& seam : seams) {
      for (const SeamSide& side : seam.sides)
        result[side.patch].curves.length_tolerance = k_length_tolerance_of_seams;
    }
  }
  for (std::size_t p = 0; p < patches.size(); ++p) {
    PieceLabel& label = result[p].label;
    label.name = names[p];
    if (label.fabric.empty()) label.fabric = patches[p].words.material;
    if (patches[p].words.quantity > 0) label.quantity = patches[p].words.quantity;
    result[p].notches.insert(result[p].notches.end(), notches[p].begin(), notches[p].end());
    result[p].seam_numbers = std::move(numbers[p]);
  }
  return result;
}

}  // namespace planish::cli
