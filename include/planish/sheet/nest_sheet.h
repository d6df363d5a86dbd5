#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <planish/core/context.h>
#include <planish/core/unit.h>
#include <planish/draw/drawing.h>
#include <planish/draw/format_drawing.h>
#include <planish/flatten/product.h>
#include <planish/mesh/tri_mesh.h>
#include <planish/pattern/nest.h>
#include <planish/sheet/pattern_geometry.h>

namespace planish {

/// A patch laid flat, to be cut from a sheet.
struct NestPatch {
  std::string name;           ///< written on each copy
  TriMesh mesh;               ///< that was laid flat
  std::vector<Vec2> pattern;  ///< model units; empty where the patch has none: then it is left out
  PatternOptions annotations = {};  ///< it is cut as often as the label says, at least once;
                                    ///< none of these is mirrored
  std::optional<Turns> turns = {};  ///< as NestPiece has them
  std::optional<std::size_t> mirror_image_of = {};  ///< number of the patch that it mirrors
};

/// The patches, those with a fold opened out to the whole: the half and its mirror image in the
/// fold, with the notches, allowances, marks and lines of both. The fold is a line inside then.
/// @throws Error as fold_stretch(); misplaced_notch for a notch on the fold
std::vector<NestPatch> with_folds_opened(std::vector<NestPatch> patches, Unit unit);

/// The patches, and behind each one the mirror image of it that its label asks for, which is a
/// patch by itself.
std::vector<NestPatch> with_mirror_images(std::vector<NestPatch> patches);

/// Patches for cloth that lies double.
struct DoubleCloth {
  /// Of which more, or fewer, are mirror images than are not.
  struct Single {
    std::string name;  ///< of the patch
    int copies = 0;    ///< that are cut from one of the two layers alone
  };
  std::vector<NestPatch> patches;   ///< that are laid
  std::vector<Single> single = {};  ///< pieces without as many mirror images
};

/// The patches as they are laid on cloth that is folded along its length: each copy gives a piece
/// and its mirror image, a half with its fold on that of the cloth one whole piece. Mirror images
/// are left out.
DoubleCloth on_double_cloth(std::vector<NestPatch> patches);

/// Patches, and the sheets to cut them from.
struct NestJob {
  std::vector<NestPatch> patches;  ///< by number from 0
  Unit unit = Unit::mm;            ///< one unit of the models
  NestOptions sheets = {};         ///< their size, and how pieces may lie on them
};

/// The patches of a product as they are to be cut, by their numbers; those that are not finished
/// have no pattern. Mirror images of others get mirrored annotations.
/// @param annotations one for each patch, as for a patch that is no twin; all that they name is
///   numbered as in the processed patches
/// @param on_seams put on the seams of the processed patches, besides other notches
/// @throws Error as notches_of_patches()
std::vector<NestPatch> patches_to_cut(std::span<const ProductPatch> patches,
                                      const ProductReport& report,
                                      std::vector<PatternOptions> annotations,
                                      std::span<const SeamNotch> on_seams = {});

/// The pattern of a patch, where laying it flat put it.
/// @pre it has one
/// @throws Error as pattern_geometry()
PatternGeometry pattern_geometry(const NestPatch& patch, Unit unit);

/// The patches by their numbers as nest() takes them: what is cut, with its allowance, and the turn
/// that lays the grain along the length of the sheet; without a grain the pattern's x axis. On
/// folded cloth the fold of a half lies on that of the cloth.
/// @throws Error as offset_outline() and grain_direction(); misplaced_allowance on folded cloth for
///   a grain that does not run along the fold of its half
std::vector<NestPiece> nest_pieces(const NestJob& job);

/// One sheet with its pieces as they are laid on it, at true size: (0, 0) is a corner of the sheet
/// itself, its length is along x. Layers as pattern_sheet() has them but for the strain map: each
/// copy has its cut line and all that the annotations asks for, and is a piece of its own;
/// "annotation" has its name, and "label" the border of the sheet and above it the title, what is
/// used of it, and a square of 50 mm.
/// @param nesting of the job's nest_pieces() on the job's sheets
/// @param number of the sheet, from 0
/// @throws Error as pattern_sheet()
Drawing nest_sheet(const NestJob& job, const Nesting& nesting, std::size_t number,
                   const std::string& title);

/// All pieces laid for pages to be joined, as many in a row as take the fewest pages that were
/// found. The layer "label" is for a drawing that fits on one page: see PageOptions::one_page.
/// @param job of whose sheets the gap and the turns count
/// @throws Error as nest(), format_tiled_pdf() and pattern_sheet(); Cancelled
Drawing page_sheet(NestJob job, const PageOptions& pages, const std::string& title,
                   const Context& context = {});

/// Sizes of one piece over each other, each moved onto the middle one so that the sum of the
/// squares of the distances between vertices of one number is least. Each has a layer of its size's
/// name with its lines in one colour; "label" has the title, the sizes in their colours, and a
/// square of 50 mm.
/// @param sizes in their order, of meshes with the same triangles, each with a pattern
/// @throws Error option_out_of_range for other triangles; as pattern_geometry()
Drawing size_nest(std::span<const NestPatch> sizes, Unit unit, const std::string& title);

/// A layout on which nothing is cut twice: where cut lines lie on each other to 0.001 mm, as
/// without a gap, that of the piece drawn first stays, and the border of the sheet is left out
/// where a cut line lies on it. What is left of a closed line is open lines, so formats whose
/// pieces have closed boundaries take the layout as it is.
Drawing without_common_lines(Drawing layout);

/// Every piece once, side by side, with all that its annotations ask for and how many are
/// cut: for formats that keep pieces as blocks. A twin is no piece by itself but a copy, or a
/// mirror image, of the other one.
/// @param twins one for each patch
/// @throws Error as pattern_sheet()
Drawing pieces_sheet(const NestJob& job, std::span<const std::optional<PatchTwin>> twins,
                     const std::string& title);

}  // namespace planish
