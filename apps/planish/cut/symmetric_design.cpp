#include "cut/symmetric_design.h"

#include <algorithm>
#include <utility>

#include <planish/mesh/carry.h>
#include <planish/mesh/inspect.h>
#include <planish/mesh/surface_line.h>

#include "cut/placed_lines.h"
#include "flags/scale_flag.h"
#include "flags/units.h"
#include "mesh/split.h"
#include "mesh/symmetry/plane_text.h"
#include "shell/failures.h"
#include "shell/text.h"
#include "shell/values.h"
#include "text/lengths.h"

namespace planish::cli {

std::vector<Flag> symmetric_flags() {
  Flag symmetric = {"--symmetric", "PLANE",
                    "make left equal right, in lines and patterns: auto finds the plane, \"x=0\" "
                    "names it, no (default no)"};
  symmetric.accepts = {.type = ValueType::text, .standard = "no"};
  return {symmetric,
          {"--mirror-surface", "",
           "with --symmetric: replace one half of the surface by the mirror image of the other; "
           "the half that has the lines stays"}};
}

bool asks_for_symmetry(const Arguments& arguments) {
  if (arguments.text("--symmetric", "no") == "no") {
    if (arguments.has("--mirror-surface")) {
      throw UsageError(
          "flag --mirror-surface needs a plane: add --symmetric auto, or --symmetric x=0");
    }
    return false;
  }
  if (arguments.text("--cut-along", "triangles") != "triangles") {
    throw UsageError(
        "flag --symmetric does not go with --cut-along edges, as edges need not have mirror "
        "images");
  }
  if (asks_to_open(arguments)) {
    throw UsageError(
        "flag --symmetric does not go with --cut open: name the lines, as --cut \"plane x=0\", or "
        "let --cut auto divide it");
  }
  return true;
}

namespace {

/// Of the diagonal: what is nearer is equal.
constexpr double k_rounding = 1e-9;

/// "3.1 mm (0.35 % of its diagonal)"
std::string distance_text(double distance, const TriMesh& mesh, const ShownLengths& lengths) {
  return lengths.text(distance) + " (" + percent(distance / bounding_box_diagonal(mesh)) +
         " of its diagonal)";
}

bool are_equal(const TriMesh& a, const TriMesh& b) {
  return a.triangles == b.triangles && a.positions == b.positions;
}

TriMesh together(std::span<const TriMesh> pieces) {
  TriMesh all;
  for (const TriMesh& piece : pieces) {
    const auto first = static_cast<Index>(all.positions.size());
    all.positions.insert(all.positions.end(), piece.positions.begin(), piece.positions.end());
    for (const Triangle& t : piece.triangles)
      all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return all;
}

/// Parts of lines, on another surface near the one that they are on.
RequestedLines laid_on(const Patch& patch, std::span<const MirroredLine> parts,
                       const RequestedLines& asked, std::span<const Vec3> positions) {
  RequestedLines laid;
  laid.notes = asked.notes;
  for (const MirroredLine& part : parts) {
    DrawnLine drawn{{}, asked.places[part.of]};
    for (const SurfacePoint& place : part.line)
      drawn.points.push_back(position_of(place, positions));
    for (SurfaceLine& line : trace_lines(patch, {{std::move(drawn)}, {}}).lines) {
      laid.lines.push_back(std::move(line));
      laid.names.push_back(asked.names[part.of]);
      laid.places.push_back(asked.places[part.of]);
    }
  }
  return laid;
}

/// What is said of pieces and their mirror images; nothing of a single one that is exact.
std::string pieces_text(std::span<const MirrorPiece> found, const TriMesh& mesh,
                        const ShownLengths& lengths) {
  std::size_t images = 0, across = 0;
  double farthest = 0.0;
  std::vector<std::string> alone;
  for (std::size_t p = 0; p < found.size(); ++p) {
    farthest = std::max(farthest, found[p].distance);
    if (found[p].kind == MirrorPiece::Kind::image) ++images;
    if (found[p].kind == MirrorPiece::Kind::across) ++across;
    if (found[p].kind == MirrorPiece::Kind::alone) alone.push_back(std::to_string(p + 1));
  }
  const bool is_exact = farthest <= k_rounding * bounding_box_diagonal(mesh);
  std::vector<std::string> parts;
  if (found.size() > 1) {
    if (images > 0) {
      parts.push_back(counted(images, "piece") + (images == 1 ? " gets" : " get") +
                      " the mirrored pattern of another one");
    }
    if (across > 0) {
      parts.push_back(counted(across, "piece") + (across == 1 ? " is its" : " are their") +
                      " own mirror image");
    }
  } else if (across == 1 && !is_exact) {
    parts.emplace_back("one half stands for both");
  }
  if (!is_exact)
    parts.push_back("what is replaced is up to " + distance_text(farthest, mesh, lengths) +
                    " away");
  if (!alone.empty()) parts.push_back("no mirror image was found of piece " + list_of_some(alone));
  std::string text;
  for (const std::string& part : parts)
    text += (text.empty() ? "" : "; ") + part;
  return text;
}

}  // namespace

Symmetry requested_symmetry(const Patch& patch, const Arguments& arguments) {
  const std::string asked = arguments.text("--symmetric", "auto");
  if (asked == "auto") return find_symmetry(patch);
  Plane plane = axis_plane("--symmetric", "", asked, arguments);
  plane.offset *= scale_from(arguments);
  return symmetry_in(patch, plane);
}

void SymmetricDesign::keep_sound(std::span<const TriMesh> pieces,
                                 std::vector<TriMesh>& symmetric) const {
  const auto is_sound = [](const TriMesh& mesh) {
    return !blocking_problem(inspect(mesh), Purpose::unfold);
  };
  std::size_t kept = 0;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    if (are_equal(pieces[p], symmetric[p]) || is_sound(symmetric[p]) || !is_sound(pieces[p]))
      continue;
    symmetric[p] = pieces[p];
    ++kept;
  }
  if (kept > 0) {
    session_.note(path_ + ": " + counted(kept, "piece") +
                  " with slits along the plane cannot be mirrored exactly; left and right differ "
                  "there as much as the surface and its triangles do");
  }
}

SymmetricDesign::SymmetricDesign(const TriMesh& mesh, const std::string& path,
                                 const Arguments& arguments, Session& session)
    : mesh_(mesh), path_(path), arguments_(arguments), session_(session) {
  const Patch patch(mesh);
  const Symmetry symmetry = requested_symmetry(patch, arguments);
  plane_ = symmetry.plane;
  // Half of what is named is enough where it is to stand for both.
  if (arguments.text("--symmetric") == "auto" || !arguments.has("--mirror-surface"))
    require_symmetric(patch, symmetry);
  side_ = greater_side(mesh, plane_);
  const bool is_exact = symmetry.largest <= k_rounding * bounding_box_diagonal(mesh);
  const ShownLengths lengths(unit_from(arguments));
  session.note(path + ": symmetric in " + plane_text(plane_in_file()) + ": its sides " +
               (is_exact ? "are equal"
                         : "differ by at most " + distance_text(symmetry.largest, mesh, lengths)));
}

Plane SymmetricDesign::plane_in_file() const {
  return {plane_.normal, plane_.offset / scale_from(arguments_)};
}

TriMesh SymmetricDesign::surface_for(RequestedLines& asked) {
  const Patch in_file(as_in_file(mesh_, arguments_));
  const Symmetry here = {.plane = plane_in_file()};
  side_ = symmetric_lines(in_file, asked.lines, here, join_tolerance(in_file.mesh()))
              .drawn_side.value_or(side_);
  if (!arguments_.has("--mirror-surface")) return mesh_;
  TriMesh whole = symmetric_mesh(Patch(mesh_), plane_, side_).mesh;
  const auto parts = lines_on_side(in_file, asked.lines, here.plane, side_);
  asked = laid_on(Patch(as_in_file(whole, arguments_)), parts, asked, in_file.positions());
  return whole;
}

RequestedLines SymmetricDesign::with_images(RequestedLines asked, const TriMesh& surface) const {
  const Patch patch(as_in_file(surface, arguments_));
  SymmetricLines lines = symmetric_lines(patch, asked.lines, symmetry_in(patch, plane_in_file()),
                                         join_tolerance(patch.mesh()));
  RequestedLines all;
  all.notes = std::move(asked.notes);
  for (MirroredLine& line : lines.lines) {
    all.lines.push_back(std::move(line.line));
    all.names.push_back(asked.names[line.of] + (line.is_mirrored ? ", mirrored" : ""));
    all.places.push_back(asked.places[line.of]);
  }
  return all;
}

TriMesh SymmetricDesign::with_symmetric_pieces(const TriMesh& cut) const {
  std::vector<TriMesh> pieces;
  for (NamedPatch& piece : split(cut, ""))
    pieces.push_back(std::move(piece.mesh));
  const std::vector<MirrorPiece> found =
      mirror_pieces(pieces, plane_, side_, symmetry_tolerance(mesh_));
  const std::string text = pieces_text(found, mesh_, ShownLengths(unit_from(arguments_)));
  if (!text.empty()) session_.note(path_ + ": " + text);
  std::vector<TriMesh> symmetric = symmetric_pieces(pieces, found, plane_, side_);
  keep_sound(pieces, symmetric);
  const bool is_as_it_was =
      std::equal(pieces.begin(), pieces.end(), symmetric.begin(), symmetric.end(), are_equal);
  return is_as_it_was ? cut : together(symmetric);
}

}  // namespace planish::cli
