#pragma once

#include <span>
#include <string>
#include <vector>

#include <planish/draw/drawing.h>
#include <planish/flatten/product.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/seams.h>
#include <planish/pattern/notches.h>
#include <planish/pattern/pattern_options.h>
#include <planish/sheet/pattern_sheet.h>

#include "product/product_file.h"
#include "shell/command.h"
#include "shell/session.h"

namespace planish::cli {

/// --seam-tolerance, model units; 0 without.
double seam_tolerance_from(const Arguments& arguments);

/// Both sides of the slits of a patch that was cut become equally long, unless seams need not match
/// or all of its border keeps its lengths.
/// @throws UsageError, Cancelled
void match_own_seams(const Patch& patch, const Arguments& arguments, FlattenOptions& options,
                     const Context& context);

/// How a product is made whose patches are flattened so.
/// @param is_cut its pieces are of one form: ProductOptions::common_lengths
/// @throws UsageError
ProductOptions product_options_from(const Arguments& arguments, FlattenOptions flatten,
                                    bool is_cut);

/// What the file of --seam-notches lists, or draws on the model; nothing without that flag.
/// @throws Error as read_rows() and seam_notches_in(), seam_notches_at()
std::vector<SeamNotch> seam_notches_from(const Arguments& arguments,
                                         std::span<const TriMesh> meshes);

/// Of each patch the notches that --seam-notches puts on its seams; none without that flag.
/// @throws Error as seam_notches_from() and notches_of_patches()
std::vector<std::vector<Notch>> notches_on_seams(const Arguments& arguments,
                                                 std::span<const TriMesh> meshes,
                                                 std::span<const std::string> names);

/// Of each patch what is written of its seams: in the middle of each side that is at least 15 mm
/// long, and near both ends of those of 80 mm or more.
/// @param seams of the meshes
/// @param names of the patches
std::vector<std::vector<SeamNumber>> numbers_of_seams(const Arguments& arguments,
                                                      std::span<const Seam> seams,
                                                      std::span<const TriMesh> meshes,
                                                      std::span<const std::string> names);

/// Seams with the names that a product file gives them: those between two pieces in the order of
/// their numbers. A note says which names are left over.
std::vector<MeasuredSeam> with_names(std::vector<MeasuredSeam> seams,
                                     const std::vector<PatchResult>& patches,
                                     const std::vector<NamedSeam>& names, Session& session);

/// What the one patch of a run gets, with what is drawn on the model and the notches on its seams
/// with itself, as far as that can be known before it is flat.
/// @throws Error as notches_on_seams() and check_pattern_options()
PatternOptions annotations_on(PatternOptions annotations, const Arguments& arguments,
                              const Patch& patch, const std::string& name, Session& session);

/// Says how many notches of patterns are not as asked: on the seam line, where there is no cut line
/// for them, or less deep, where there is less allowance than that.
void note_notches(Session& session, std::span<const PatternGeometry> patterns);
/// Says where the allowance of a pattern fills slits, darts or bays, so that no cut line runs
/// there.
void note_filled(Session& session, const PatternGeometry& pattern);
/// Says which notches and allowances do not fit and are left out.
void note_left_out(Session& session, const PatternGeometry& pattern);
/// All three.
void note_pattern(Session& session, const PatternGeometry& pattern);

}  // namespace planish::cli
