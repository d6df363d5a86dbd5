#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include <planish/core/error.h>
#include <planish/core/range.h>
#include <planish/io/model.h>
#include <planish/mesh/weld.h>

#include "io/model/part.h"
#include "mesh/redundant/lying.h"
#include "mesh/repair/sheets.h"
#include "mesh/split.h"

namespace planish {

std::string_view to_string(Divide divide) {
  switch (divide) {
    case Divide::objects:
      return "objects";
    case Divide::materials:
      return "materials";
    case Divide::parts:
      break;
  }
  return "parts";
}

std::string_view to_string(Side side) {
  return side == Side::outer ? "outer" : "inner";
}

namespace {

using Names = std::vector<std::string>;

bool has(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

const FaceGroups& dividing_groups(const ReadResult& file, Divide divide) {
  static const FaceGroups none;
  switch (divide) {
    case Divide::objects:
      return file.groups;
    case Divide::materials:
      return file.materials;
    case Divide::parts:
      break;
  }
  return none;
}

/// Of each name whether it is among those.
std::vector<unsigned char> flags_of(const FaceGroups& groups, const Names& chosen) {
  std::vector<unsigned char> flags;
  flags.reserve(groups.names.size());
  for (const std::string& name : groups.names)
    flags.push_back(has(chosen, name) ? 1 : 0);
  return flags;
}

/// Of each triangle whether its object, group or material is among the names.
std::vector<unsigned char> named_triangles(const ReadResult& file, const Names& names) {
  std::vector<unsigned char> named(file.mesh.triangles.size(), 0);
  for (const FaceGroups* groups : {&file.groups, &file.materials}) {
    const std::vector<unsigned char> flags = flags_of(*groups, names);
    for (std::size_t t = 0; t < groups->of_triangle.size(); ++t)
      named[t] |= flags[groups->of_triangle[t]];
  }
  return named;
}

/// What names of objects, groups and materials choose of a file; those of pieces come later.
struct Choice {
  std::vector<unsigned char> only;     ///< of each triangle of the file: --only names its group
  std::vector<unsigned char> without;  ///< the same of --without
  bool only_groups = false;            ///< no piece is named: what is not chosen may go at once

  bool takes(std::size_t t) const { return without[t] == 0 && (!only_groups || only[t] != 0); }
};

Choice choice_of(const ReadResult& file, const ModelOptions& options) {
  const auto is_group = [&](const std::string& name) {
    return has(file.groups.names, name) || has(file.materials.names, name);
  };
  return {named_triangles(file, options.only), named_triangles(file, options.without),
          !options.only.empty() && std::all_of(options.only.begin(), options.only.end(), is_group)};
}

/// The parts of a file that have names, or the file as one, of the triangles that are taken. Of
/// one part the vertices keep their numbers.
std::vector<ModelPart> parts_of(const ReadResult& file, const Choice& choice, Divide divide,
                                const std::string& name) {
  const FaceGroups& groups = dividing_groups(file, divide);
  const Names names = groups.names.empty() ? Names{name} : groups.names;
  const std::vector<double> areas = unit_areas(file.mesh);
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
  std::vector<ModelPart> parts(names.size());
  std::vector<Triangle> taken;
  std::vector<Index> part_of;
  for (std::size_t t = 0; t < file.mesh.triangles.size(); ++t) {
    if (!choice.takes(t)) continue;
    const Index p = groups.names.empty() ? 0 : groups.of_triangle[t];
    taken.push_back(file.mesh.triangles[t]);
    part_of.push_back(p);
    parts[p].triangles.push_back(static_cast<Index>(t));
    parts[p].area_share += areas[t];
  }
  TriMesh mesh = {file.mesh.positions, std::move(taken)};
  std::vector<NamedPatch> patches;
  if (names.size() > 1) {
    patches = split(mesh, part_of, names);
  } else {
    std::vector<Index> all(mesh.positions.size());
    std::iota(all.begin(), all.end(), Index{0});
    patches.push_back({names.front(), std::move(mesh), std::move(all)});
  }
  for (std::size_t p = 0; p < parts.size(); ++p) {
    parts[p].name = std::move(patches[p].name);
    parts[p].mesh = std::move(patches[p].mesh);
    parts[p].vertices = std::move(patches[p].vertices);
    parts[p].area_share = area > 0.0 ? parts[p].area_share / area : 0.0;
  }
  std::erase_if(parts, [](const ModelPart& part) { return part.triangles.empty(); });
  return parts;
}

/// The connected pieces of a part; one where no two triangles share an edge: such a part was
/// written without joining its triangles.
Sheets pieces_in(const ModelPart& part) {
  if (part.is_one_piece) return {std::vector<Index>(part.mesh.triangles.size(), 0), 1};
  Sheets pieces = find_sheets(part.mesh);
  if (pieces.count == part.mesh.triangles.size()) pieces = {std::vector<Index>(pieces.count, 0), 1};
  return pieces;
}

/// A triangle of a model in the making.
struct PlacedTriangle {
  Index file = ModelPart::none;  ///< its number in the file
  Index piece = 0;
  Triangle corners = {};
};

/// Puts parts together again: vertices of the file under their numbers, new ones behind.
class Assembly {
 public:
  explicit Assembly(std::vector<Vec3> positions) : positions_(std::move(positions)) {}

  /// @param chosen of each piece of the part: its number in the model, or none
  void add(const ModelPart& part, const std::vector<Index>& piece_of,
           const std::vector<Index>& chosen) {
    std::vector<Index> number = part.vertices;
    for (std::size_t v = number.size(); v < part.mesh.positions.size(); ++v) {
      number.push_back(static_cast<Index>(positions_.size()));
      positions_.push_back(part.mesh.positions[v]);
    }
    for (std::size_t t = 0; t < part.mesh.triangles.size(); ++t) {
      const Index piece = chosen[piece_of[t]];
      if (piece == ModelPart::none) continue;
      const Triangle& corners = part.mesh.triangles[t];
      triangles_.push_back(
          {part.triangles[t], piece, {number[corners[0]], number[corners[1]], number[corners[2]]}});
    }
  }

  /// Triangles in the order of the file, new ones behind, and vertices without those that the file
  /// uses and the model does not.
  /// @return of each triangle the one of the file, or none
  std::vector<Index> finish(const TriMesh& file, Model& model) && {
    const auto comes_before = [](const PlacedTriangle& a, const PlacedTriangle& b) {
      return a.file < b.file;
    };
    if (!std::is_sorted(triangles_.begin(), triangles_.end(), comes_before))
      std::stable_sort(triangles_.begin(), triangles_.end(), comes_before);
    std::vector<unsigned char> gone(positions_.size(), 0);
    for (std::size_t v = file.positions.size(); v < positions_.size(); ++v)
      gone[v] = 1;
    for (const Triangle& t : file.triangles) {
      for (const Index v : t)
        gone[v] = 1;
    }
    for (const PlacedTriangle& t : triangles_) {
      for (const Index v : t.corners)
        gone[v] = 0;
    }
    std::vector<Index> number(positions_.size(), 0);
    for (std::size_t v = 0; v < positions_.size(); ++v) {
      if (gone[v] != 0) continue;
      number[v] = static_cast<Index>(model.mesh.positions.size());
      model.work.renumbered |= v < file.positions.size() && number[v] != v;
      model.mesh.positions.push_back(positions_[v]);
    }
    std::vector<Index> source;
    source.reserve(triangles_.size());
    for (const PlacedTriangle& t : triangles_) {
      model.mesh.triangles.push_back(
          {number[t.corners[0]], number[t.corners[1]], number[t.corners[2]]});
      model.piece_of.push_back(t.piece);
      source.push_back(t.file);
    }
    return source;
  }

 private:
  std::vector<Vec3> positions_;
  std::vector<PlacedTriangle> triangles_;
};

/// The pieces of the parts of a file.
struct PiecesOfParts {
  std::vector<Sheets> sheets;  ///< of each part
  Names numbered;              ///< a name for each piece: "sleeve-2"
  Names shown;                 ///< the same, no two alike
};

PiecesOfParts pieces_of(const std::vector<ModelPart>& parts) {
  PiecesOfParts pieces;
  for (const ModelPart& part : parts) {
    pieces.sheets.push_back(pieces_in(part));
    const Names names = numbered_names(part.name, pieces.sheets.back().count);
    pieces.numbered.insert(pieces.numbered.end(), names.begin(), names.end());
  }
  pieces.shown = distinct_names(pieces.numbered);
  return pieces;
}

/// Of the pieces of a part those that names choose: the number that each gets, or none.
/// @param first number of the first one among all pieces
std::vector<Index> chosen_pieces(const ModelPart& part, const Sheets& sheets, std::size_t first,
                                 const PiecesOfParts& all, const Choice& choice,
                                 const ModelOptions& options, Names& pieces) {
  std::vector<unsigned char> is_named(sheets.count, 1);  // all of it, by its groups
  for (std::size_t t = 0; t < sheets.of_triangle.size(); ++t) {
    const Index of_file = part.triangles[t];
    if (of_file == ModelPart::none || choice.only[of_file] == 0)
      is_named[sheets.of_triangle[t]] = 0;
  }
  std::vector<Index> chosen(sheets.count, ModelPart::none);
  for (std::size_t k = 0; k < sheets.count; ++k) {
    const std::string& shown = all.shown[first + k];
    const auto names_it = [&](const Names& asked) {
      return has(asked, all.numbered[first + k]) || has(asked, shown) || has(asked, part.name);
    };
    const bool is_asked =
        options.only.empty() || choice.only_groups || is_named[k] != 0 || names_it(options.only);
    if (!is_asked || names_it(options.without)) continue;
    chosen[k] = static_cast<Index>(pieces.size());
    pieces.push_back(shown);
  }
  return chosen;
}

/// Each name once, in order.
Names distinct(const Names& names) {
  Names result;
  std::set<std::string> seen;
  for (const std::string& name : names) {
    if (seen.insert(name).second) result.push_back(name);
  }
  return result;
}

void look_for_touching_pieces(Model& model) {
  const TouchingPieces touching =
      find_touching_pieces(divided(model), default_weld_length(model.mesh));
  model.work.touching = touching.pieces;
  model.work.welded = touching.joined;
}

/// With names a piece may be meant to lie on a part of another one, as a facing does.
void look_for_lying_pieces(Model& model) {
  const Lying way = model.divided_by.empty() ? Lying::meshed : Lying::closely;
  for (const auto& [piece, on] :
       find_lying_pieces(model.mesh, model.piece_of, model.pieces.size(), way))
    model.work.lying.push_back({model.pieces[piece], model.pieces[on]});
}

/// What there is to tell of welding that joined nothing.
ModelWork::NothingJoined unjoined_gap(const Model& model, double length) {
  const double within = length > 0.0 ? length : default_weld_length(model.mesh);
  const auto gap = nearest_border_gap(divided(model));
  return {gap, gap && *gap <= within && !model.divided_by.empty()};
}

/// A model and where its triangles come from.
struct Prepared {
  Model model;
  std::vector<Index> source;  ///< of each triangle the one of the file, or none
};

Prepared prepared(const ReadResult& file, const ModelOptions& options, const std::string& name) {
  Prepared result;
  Model& model = result.model;
  const Choice choice = choice_of(file, options);
  std::vector<ModelPart> parts = parts_of(file, choice, options.divide, name);
  for (ModelPart& part : parts)
    prepare_part(part, options, model.work);
  model.work.clashing_sides = find_clashing_sides(parts);
  std::erase_if(parts, [](const ModelPart& part) { return part.mesh.triangles.empty(); });
  const PiecesOfParts pieces = pieces_of(parts);
  Assembly assembly(file.mesh.positions);
  std::size_t first = 0;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const Sheets& sheets = pieces.sheets[p];
    const auto chosen =
        chosen_pieces(parts[p], sheets, first, pieces, choice, options, model.pieces);
    assembly.add(parts[p], sheets.of_triangle, chosen);
    first += sheets.count;
  }
  model.names = pieces.numbered;
  model.names.insert(model.names.end(), pieces.shown.begin(), pieces.shown.end());
  result.source = std::move(assembly).finish(file.mesh, model);
  return result;
}

/// Of each piece of the model the first one of the whole file that it has a triangle of.
std::vector<std::size_t> places_in_file(const Prepared& taken, const Prepared& whole,
                                        std::size_t triangles) {
  std::vector<Index> piece_at(triangles, ModelPart::none);
  for (std::size_t t = 0; t < whole.source.size(); ++t) {
    if (whole.source[t] != ModelPart::none) piece_at[whole.source[t]] = whole.model.piece_of[t];
  }
  std::vector<std::size_t> places(taken.model.pieces.size(), whole.model.pieces.size());
  for (std::size_t t = 0; t < taken.source.size(); ++t) {
    if (taken.source[t] == ModelPart::none || piece_at[taken.source[t]] == ModelPart::none)
      continue;
    std::size_t& place = places[taken.model.piece_of[t]];
    place = std::min<std::size_t>(place, piece_at[taken.source[t]]);
  }
  return places;
}

/// The model with the names that its pieces have in the whole file, and with what is left out.
Model with_left_out(Prepared taken, const Prepared& whole, std::size_t triangles) {
  const std::vector<std::size_t> places = places_in_file(taken, whole, triangles);
  const std::size_t count = whole.model.pieces.size();
  std::vector<std::size_t> uses(count + 1, 0);
  for (const std::size_t place : places)
    ++uses[place];
  Model model = std::move(taken.model);
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (places[k] < count && uses[places[k]] == 1) model.pieces[k] = whole.model.pieces[places[k]];
  }
  model.pieces = distinct_names(model.pieces);
  std::vector<NamedPatch> all = split(whole.model.mesh, whole.model.piece_of, whole.model.pieces);
  std::size_t before = 0;
  for (std::size_t place = 0; place < count; ++place) {
    before += uses[place];
    if (uses[place] > 0) continue;
    model.left_out.push_back({std::move(all[place].name), std::move(all[place].mesh), before});
  }
  model.work.clashing_sides = whole.model.work.clashing_sides;
  std::erase_if(model.work.clashing_sides, [&](const ModelWork::ClashingSides& sides) {
    return !has(model.pieces, sides.one) && !has(model.pieces, sides.other);
  });
  model.names.insert(model.names.begin(), whole.model.names.begin(), whole.model.names.end());
  return model;
}

}  // namespace

Model prepare_model(ReadResult file, const ModelOptions& options, const std::string& name) {
  check_range("weld", options.weld.value_or(0.0), {.min = 0.0});
  check_range("fill_holes", options.fill_holes, {.min = 0.0});
  Prepared taken = prepared(file, options, name);
  Model model;
  if (options.only.empty() && options.without.empty()) {
    model = std::move(taken.model);
  } else {
    ModelOptions all = options;
    all.only.clear();
    all.without.clear();
    model = with_left_out(std::move(taken), prepared(file, all, name), file.mesh.triangles.size());
  }
  model.format = file.format;
  model.notes = std::move(file.notes);
  model.divided_by = dividing_groups(file, options.divide).kind;
  for (const FaceGroups* groups : {&file.groups, &file.materials})
    model.names.insert(model.names.end(), groups->names.begin(), groups->names.end());
  model.names = distinct(model.names);
  if (options.weld && model.work.joined + model.work.unjoined == 0)
    model.work.nothing_joined = unjoined_gap(model, *options.weld);
  const bool is_unnamed = model.divided_by.empty() && !options.strict && !options.weld;
  if (model.work.walls.empty()) look_for_lying_pieces(model);
  // Borders of sheets that lie on each other are not to be joined.
  const bool may_touch = is_unnamed && model.pieces.size() > 1 && model.work.lying.empty();
  if (may_touch) look_for_touching_pieces(model);
  return model;
}

void check_names(const ModelOptions& options, std::span<const std::string> names) {
  for (const Names* asked : {&options.only, &options.without}) {
    for (const std::string& name : *asked) {
      if (std::find(names.begin(), names.end(), name) != names.end()) continue;
      std::string known;
      for (const std::string& there : distinct({names.begin(), names.end()}))
        known += (known.empty() ? "" : ", ") + there;
      throw Error(ErrorCode::unknown_name, "no piece is called " + name + "; there are " + known);
    }
  }
}

TriMesh divided(const Model& model) {
  constexpr Index none = ModelPart::none;
  TriMesh mesh = model.mesh;
  if (model.pieces.size() < 2) return mesh;
  std::vector<Index> owner(mesh.positions.size(), none);
  std::map<std::pair<Index, Index>, Index> copies;  // piece, vertex -> its copy
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Index piece = model.piece_of[t];
    for (Index& v : mesh.triangles[t]) {
      if (owner[v] == none) owner[v] = piece;
      if (owner[v] == piece) continue;
      const auto [copy, is_new] =
          copies.try_emplace({piece, v}, static_cast<Index>(mesh.positions.size()));
      const Vec3 place = mesh.positions[v];
      if (is_new) mesh.positions.push_back(place);
      v = copy->second;
    }
  }
  return mesh;
}

}  // namespace planish
