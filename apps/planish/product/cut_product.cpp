#include "product/cut_product.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <planish/flatten/flatten.h>
#include <planish/mesh/inspect.h>

#include "cut/panel_places.h"
#include "cut/panels.h"
#include "cut/requested_lines.h"
#include "cut/symmetric_design.h"
#include "flags/unfold_flags.h"
#include "mesh/split.h"
#include "model/model_flags.h"
#include "shell/failures.h"

namespace planish::cli {

namespace {

constexpr std::size_t k_most_pieces = 64;  // that --cut open makes of a part

/// Vertices less edges plus triangles: 1 of a disk.
std::ptrdiff_t euler_characteristic(const TriMesh& mesh) {
  std::vector<Index> vertices;
  std::vector<std::pair<Index, Index>> edges;
  for (const Triangle& t : mesh.triangles) {
    vertices.insert(vertices.end(), t.begin(), t.end());
    for (std::size_t k = 0; k < 3; ++k)
      edges.push_back(std::minmax({t[k], t[(k + 1) % 3]}));
  }
  const auto distinct = [](auto& all) {
    std::sort(all.begin(), all.end());
    return std::unique(all.begin(), all.end()) - all.begin();
  };
  return distinct(vertices) - distinct(edges) + std::ssize(mesh.triangles);
}

/// Why a sound surface has to be divided before it is laid flat; nothing where it need not.
std::string reason_to_divide(const TriMesh& mesh) {
  if (euler_characteristic(mesh) == 1) return {};  // which spares looking closer at most patches
  const Inspection inspection = inspect(mesh);
  if (blocking_problem(inspection, Purpose::measure)) return {};
  const auto problem = blocking_problem(inspection, Purpose::unfold);
  if (!problem) return {};
  switch (problem->code) {
    case ErrorCode::closed_surface:
      return "the surface is closed";
    case ErrorCode::handles:
      return "the surface has handles";
    case ErrorCode::several_border_loops:
      return "the surface is a tube or has open seams";
    default:
      return {};
  }
}

/// The reason for each patch of an input; all are empty where nothing has to be divided.
std::vector<std::string> reasons_to_divide(const ProductInput& input) {
  std::vector<std::string> reasons;
  reasons.reserve(input.patches.size());
  const bool is_whole = input.patches.size() == 1 && !input.is_described;
  for (const ProductPatch& patch : input.patches)
    reasons.push_back(patch.failure ? ""
                                    : reason_to_divide(is_whole ? input.whole.mesh : patch.mesh));
  return reasons;
}

/// Divides a mesh as --cut auto does. If that fails, returns the mesh as it was: flattening it then
/// reports the error.
CutInput divided_unasked(TriMesh mesh, const std::string& path, const std::string& reason,
                         const PanelRules& rules, const Arguments& arguments, Session& session) {
  try {
    CutInput cut = divided_into_panels(Patch(mesh), path, arguments, session, rules);
    session.note(
        path + ": " + reason +
        ", so it was divided, as by --cut auto. Of a wall with a thickness --side takes one "
        "side");
    return cut;
  } catch (const Error&) {
    return {std::move(mesh)};
  }
}

/// The pieces that a patch is cut into; to what was done to all is added what was done to it.
/// @param reason to divide it unasked; empty where there is none
std::vector<ProductPatch> cut_patch(ProductPatch patch, const std::string& path,
                                    const std::string& reason, bool is_one_of_several,
                                    const PanelRules& rules, const Arguments& arguments,
                                    Session& session, CutInput& all) {
  CutInput cut = {};
  if (arguments.has("--cut") || asks_for_symmetry(arguments)) {
    cut = cut_as_asked(
        std::move(patch.mesh), path, arguments, session,
        {.most_pieces = k_most_pieces, .match_seams = is_one_of_several, .panels = rules});
  } else if (!reason.empty()) {
    cut = divided_unasked(std::move(patch.mesh), path, reason, rules, arguments, session);
  } else {
    cut.mesh = std::move(patch.mesh);
  }
  if (cut.cut) {
    if (all.cut)
      *all.cut += *cut.cut;
    else
      all.cut = cut.cut;
  }
  all.symmetric_in = cut.symmetric_in;
  std::vector<ProductPatch> pieces;
  const bool is_automatic =
      cut.cut && (!reason.empty() || (asks_for_panels(arguments) && !asks_for_lines(arguments)));
  for (NamedPatch& piece :
       is_automatic ? pieces_by_place(cut.mesh, patch.name) : split(cut.mesh, patch.name)) {
    pieces.push_back(patch);
    pieces.back().name = std::move(piece.name);
    pieces.back().mesh = std::move(piece.mesh);
  }
  return pieces;
}

/// Takes those away that --without names.
/// @param whole the name of what was cut
/// @throws Error unknown_name, no_triangles
void leave_out(std::vector<ProductPatch>& pieces, const std::string& whole,
               const Arguments& arguments, std::vector<std::string>& left_out) {
  std::vector<std::string> names;
  names.reserve(pieces.size());
  for (const ProductPatch& piece : pieces)
    names.push_back(piece.name);
  ModelOptions options = model_options_from(arguments, names);
  options.only.clear();  // that was of the file
  std::erase_if(options.without, [&](const std::string& name) {
    const bool is_of_file = std::find(left_out.begin(), left_out.end(), name) != left_out.end();
    return is_of_file || !name.starts_with(whole + "-");
  });
  check_names(options, names);
  for (const std::string& name : options.without) {
    std::erase_if(pieces, [&](const ProductPatch& piece) { return piece.name == name; });
    left_out.push_back(name);
  }
  if (pieces.empty())
    throw Error(ErrorCode::no_triangles, "--without leaves nothing of what the cut makes");
}

}  // namespace

PanelRules panel_rules(const FlattenOptions& options, const Arguments& arguments) {
  PanelRules rules{.match_seams = matches_seams_of_product(arguments)};
  const bool has_tolerance =
      options.as_needed.max_deviation > 0.0 && std::isfinite(options.as_needed.max_deviation);
  if (options.method || !has_tolerance || !options.limits.any()) return rules;
  rules.can_change = [limits = options.limits, as_needed = options.as_needed](
                         const Patch& piece, const Context& context) {
    try {
      const Outcome outcome =
          flatten(piece, "", {.as_needed = as_needed, .limits = limits}, context).outcome();
      return std::all_of(outcome.missed.begin(), outcome.missed.end(),
                         [](Criterion what) { return what == Criterion::size; });
    } catch (const Cancelled&) {
      throw;
    } catch (const Error&) {
      return false;
    }
  };
  return rules;
}

std::optional<CutOutcome> cut_product(ProductInput& input, const FlattenOptions& options,
                                      const Arguments& arguments, Session& session) {
  const bool is_cut = arguments.has("--cut"), is_symmetric = asks_for_symmetry(arguments);
  panel_options_from(arguments);
  const bool is_asked = is_symmetric || is_cut;
  const std::vector<std::string> reasons =
      is_asked ? std::vector<std::string>(input.patches.size()) : reasons_to_divide(input);
  const auto is_none = [](const std::string& reason) { return reason.empty(); };
  if (!is_asked && std::all_of(reasons.begin(), reasons.end(), is_none)) {
    note_idle_panel_flags(arguments, session);
    return std::nullopt;
  }
  const bool are_several = input.patches.size() > 1 || input.is_described;
  if (are_several && (is_symmetric || asks_for_lines(arguments))) {
    throw UsageError(
        "flag " + std::string(is_symmetric ? "--symmetric" : "--cut") +
        " goes with one patch only, but for --cut open and auto; the input has several: "
        "take one with --only NAME, or what hangs together as one with --divide parts");
  }
  CutInput all;
  std::vector<ProductPatch> patches;
  std::vector<MeshFormat> formats;
  if (!are_several) {
    input.patches.front().mesh = input.whole.mesh;
    input.patches.front().name = input.whole.pieces.front();
    input.patches.front().turned = input.whole.turned;
  }
  const std::size_t before = input.patches.size();
  std::size_t made = before;
  for (std::size_t p = 0; p < input.patches.size(); ++p) {
    const MeshFormat format = input.places[p].format;
    const std::string path = input.patches[p].words.source;
    std::vector<ProductPatch> pieces;
    if (input.patches[p].failure) {
      pieces.push_back(std::move(input.patches[p]));
    } else {
      const std::string whole = input.patches[p].name;
      pieces = cut_patch(std::move(input.patches[p]), path, reasons[p], are_several,
                         panel_rules(options, arguments), arguments, session, all);
      made += pieces.size() - 1;
      if (pieces.size() > 1) leave_out(pieces, whole, arguments, input.left_out);
    }
    formats.insert(formats.end(), pieces.size(), format);
    std::move(pieces.begin(), pieces.end(), std::back_inserter(patches));
  }
  input.patches = std::move(patches);
  input.places = places_of(input.patches, formats);
  if (made > before)
    session.note(input.path + ": the cut makes " + std::to_string(made) + " patches");
  if (!are_several && input.patches.size() == 1) {
    input.whole.mesh = input.patches.front().mesh;
    input.whole.pieces = {input.patches.front().name};
    input.whole.piece_of.assign(input.whole.mesh.triangles.size(), 0);
  }
  input.symmetric_in = all.symmetric_in;
  return all.cut;
}

}  // namespace planish::cli
