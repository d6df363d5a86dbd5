#include <utility>

#include <planish/mesh/patch.h>
#include <planish/pattern/notches.h>
#include <planish/sheet/nest_sheet.h>
#include <planish/sheet/product_sheet.h>

namespace planish {

namespace {

/// Whose places a pattern has; nothing for others, nor where remeshing gave vertices other numbers.
std::optional<PatchTwin> drawn_twin(const ProductReport& report, std::size_t p) {
  const auto& finished = report.patches[p].finished;
  const auto& twin = report.twins[p];
  if (!finished || !finished->twin_of || !twin) return std::nullopt;
  const auto& other = report.patches[twin->patch].finished;
  const std::size_t vertices = twin->vertex.size();
  const bool are_numbered_so = other && finished->processed.positions.size() == vertices &&
                               other->processed.positions.size() == vertices;
  return are_numbered_so ? twin : std::nullopt;
}

bool is_mirror_image(const PatchResult& patch) {
  return patch.finished && patch.finished->twin_of && patch.finished->twin_of->mirrored;
}

std::vector<Seam> seams_of(const ProductReport& report) {
  std::vector<Seam> seams;
  seams.reserve(report.seams.size());
  for (const MeasuredSeam& seam : report.seams)
    seams.push_back(seam.seam);
  return seams;
}

}  // namespace

Drawing product_sheet(const ProductReport& report, const std::string& title) {
  std::vector<ProductPiece> pieces;
  pieces.reserve(report.patches.size());
  for (std::size_t p = 0; p < report.patches.size(); ++p) {
    const PatchResult& patch = report.patches[p];
    ProductPiece& piece = pieces.emplace_back();
    piece.name = patch.name;
    if (!patch.finished) continue;
    piece.mesh = patch.finished->processed;
    piece.pattern = patch.finished->unfold.pattern.positions;
    piece.twin = drawn_twin(report, p);
  }
  return product_sheet(pieces, seams_of(report), report.unit, title);
}

PatternOptions annotations_of_twin(PatternOptions own, const TriMesh& of, const PatchTwin& twin) {
  if (twin.mirrored) own = for_mirror_image(std::move(own));
  // Where piece_outline() begins.
  own.like = MirrorReference{twin.mirrored, twin.vertex[Patch(of).border_loops().front().front()]};
  return own;
}

std::vector<NestPatch> patches_to_cut(std::span<const ProductPatch> patches,
                                      const ProductReport& report,
                                      std::vector<PatternOptions> annotations,
                                      std::span<const SeamNotch> on_seams) {
  std::vector<TriMesh> meshes = meshes_now(patches, report);
  std::vector<std::string> names;
  names.reserve(patches.size());
  for (const ProductPatch& patch : patches)
    names.push_back(patch.name);
  const auto notches =
      notches_of_patches(on_seams, seams_of(report), meshes, names, millimetres_per(report.unit));
  std::vector<NestPatch> to_cut;
  to_cut.reserve(patches.size());
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const PatchResult& result = report.patches[p];
    PatternOptions& own = annotations[p];
    if (is_mirror_image(result)) own = for_mirror_image(std::move(own));
    own.notches.insert(own.notches.end(), notches[p].begin(), notches[p].end());
    std::vector<Vec2> pattern;
    if (result.finished) {
      own.overlaps = result.finished->unfold.pattern.overlaps;
      pattern = result.finished->unfold.pattern.positions;
    }
    NestPatch& patch = to_cut.emplace_back(
        NestPatch{names[p], std::move(meshes[p]), std::move(pattern), std::move(own)});
    if (is_mirror_image(result)) patch.mirror_image_of = report.twins[p]->patch;
  }
  return to_cut;
}

}  // namespace planish
