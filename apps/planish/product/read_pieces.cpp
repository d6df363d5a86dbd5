#include "product/read_pieces.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <planish/mesh/repair.h>

#include "cut/panel_places.h"
#include "mesh/split.h"
#include "model/model_flags.h"
#include "model/orient.h"
#include "product/seams.h"
#include "shell/failures.h"

namespace planish::cli {

namespace {

/// The pieces of a file in its order.
std::vector<ReadPiece> pieces_of(const Model& model, const std::string& path, std::size_t group) {
  std::vector<ReadPiece> pieces;
  auto next = model.left_out.begin();
  const auto add = [&](std::string name, TriMesh mesh, bool is_taken) {
    ReadPiece piece{{std::move(name), std::move(mesh)}, is_taken, model.format};
    piece.patch.words.source = path;
    piece.patch.group = group;
    piece.in_file = piece.patch.name;
    pieces.push_back(std::move(piece));
  };
  const auto add_left_out = [&](std::size_t before) {
    for (; next != model.left_out.end() && next->before <= before; ++next)
      add(next->name, next->mesh, false);
  };
  if (model.pieces.size() == 1) {
    add_left_out(0);
    add(model.pieces.front(), model.mesh, true);
  } else {
    for (NamedPatch& piece : split(model.mesh, model.piece_of, model.pieces)) {
      add_left_out(pieces.size() - static_cast<std::size_t>(next - model.left_out.begin()));
      add(std::move(piece.name), std::move(piece.mesh), true);
    }
  }
  add_left_out(model.pieces.size());
  return pieces;
}

bool is_among(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Whether it has the name in the product.
bool is_called(const ReadPiece& piece, const std::string& name) {
  return piece.patch.name == name || is_among(piece.asked_as, name);
}

/// A name that is one piece's in the product and another one's in its file could mean either.
/// Pieces of one name that got numbers are all meant.
/// @throws UsageError
void refuse_names_of_two(const AllPieces& all, const std::vector<std::string>& asked) {
  for (const std::string& name : asked) {
    const ReadPiece *shown = nullptr, *in_file = nullptr, *both = nullptr;
    for (const ReadPiece& piece : all.pieces) {
      const bool is_shown = is_called(piece, name);
      const bool is_in_file = piece.in_file == name;
      const bool is_numbered = piece.patch.name.starts_with(name + "-");
      if (is_shown && is_in_file) both = &piece;
      if (is_shown && !is_in_file && !piece.in_file.empty()) shown = &piece;
      if (is_in_file && !is_shown && !is_numbered) in_file = &piece;
    }
    if (shown == nullptr) shown = in_file == nullptr ? nullptr : both;
    if (in_file == nullptr) in_file = both;
    if (shown == nullptr || in_file == nullptr) continue;
    throw UsageError("\"" + name + "\" could mean " + shown->patch.name + " of " +
                     shown->patch.words.source + " or " + in_file->patch.name + " of " +
                     in_file->patch.words.source +
                     ", which is called so in its file: name pieces by other names of theirs");
  }
}

/// The mirror image of a piece; null where it has none.
ReadPiece* image_of(std::vector<ReadPiece>& pieces, std::size_t p) {
  return p + 1 < pieces.size() && pieces[p + 1].is_image ? &pieces[p + 1] : nullptr;
}

void turn_over(ProductPatch& patch) {
  patch.mesh = turned_over(std::move(patch.mesh));
  patch.turned = true;
}

}  // namespace

ReadPiece unreadable(std::string name, const std::string& path, std::size_t group) {
  ReadPiece piece{{std::move(name), {}, {}, current_failure(), group}};
  piece.patch.words.source = path;
  return piece;
}

void AllPieces::add(Model model, const std::string& from, std::size_t group) {
  std::vector<ReadPiece> some = pieces_of(model, from, group);
  std::move(some.begin(), some.end(), std::back_inserter(pieces));
  known.insert(known.end(), model.names.begin(), model.names.end());
  if (model.pieces.empty()) return;
  last = std::move(model);
  path = from;
}

std::size_t AllPieces::taken() const {
  return static_cast<std::size_t>(std::count_if(
      pieces.begin(), pieces.end(), [](const ReadPiece& piece) { return piece.is_taken; }));
}

AllPieces with_distinct_names(AllPieces all) {
  std::vector<std::string> names;
  names.reserve(all.pieces.size());
  for (const ReadPiece& piece : all.pieces)
    names.push_back(piece.patch.name);
  names = distinct_names(names);
  for (std::size_t p = 0; p < names.size(); ++p)
    all.pieces[p].patch.name = std::move(names[p]);
  return all;
}

namespace {

/// Adds names of --without that exist only after the cut, as "body-3" and "body-zmax" of "body".
/// The cut checks them.
void add_names_of_cut(const ModelOptions& options, std::vector<std::string>& names) {
  const std::vector<std::string> whole = names;
  for (const std::string& name : options.without) {
    const std::size_t dash = name.rfind('-');
    const bool is_numbered = dash != std::string::npos && dash + 1 < name.size() &&
                             name.find_first_not_of("0123456789", dash + 1) == std::string::npos;
    const bool is_placed = dash != std::string::npos && is_place(name.substr(dash + 1));
    if ((is_numbered || is_placed) && is_among(whole, name.substr(0, dash)) &&
        !is_among(whole, name))
      names.push_back(name);
  }
}

}  // namespace

void choose_by_names_of_product(AllPieces& all, const Arguments& arguments) {
  const bool is_chosen = arguments.has("--only") || arguments.has("--without");
  if (!is_chosen || all.known.empty()) return;
  std::vector<std::string> names = all.known;
  for (const ReadPiece& piece : all.pieces) {
    if (!is_among(names, piece.patch.name)) names.push_back(piece.patch.name);
    for (const std::string& name : piece.asked_as) {
      if (!is_among(names, name)) names.push_back(name);
    }
  }
  const ModelOptions options = model_options_from(arguments, names);
  if (arguments.has("--cut")) add_names_of_cut(options, names);
  check_names(options, names);
  refuse_names_of_two(all, options.only);
  refuse_names_of_two(all, options.without);
  const auto is_named = [&](const ReadPiece& piece, const std::vector<std::string>& asked) {
    return std::any_of(asked.begin(), asked.end(), [&](const std::string& name) {
      return !is_among(all.known, name) && is_called(piece, name);
    });
  };
  for (ReadPiece& piece : all.pieces) {
    piece.is_taken =
        (piece.is_taken || is_named(piece, options.only)) && !is_named(piece, options.without);
  }
}

void turn_inside_out(AllPieces& all, const Arguments& arguments, Session& session) {
  const bool strict = arguments.has("--strict");
  if (all.pieces.size() < 2 || (strict && arguments.has("--flip") && all.taken() == 1)) return;
  std::vector<PlacedPiece> placed;
  placed.reserve(all.pieces.size());
  for (std::size_t p = 0; p < all.pieces.size(); ++p) {
    const ReadPiece& piece = all.pieces[p];
    const ReadPiece* image = image_of(all.pieces, p);
    const bool is_taken = piece.is_taken || (image != nullptr && image->is_taken);
    placed.push_back({piece.patch.name, piece.patch.mesh, piece.patch.group, is_taken});
  }
  const InsideOut found = pieces_inside_out(placed, seam_tolerance_from(arguments), strict);
  for (const std::size_t p : found.turned) {
    turn_over(all.pieces[p].patch);
    if (ReadPiece* image = image_of(all.pieces, p)) turn_over(image->patch);
  }
  for (const std::string& note : found.notes)
    session.note(note);
}

}  // namespace planish::cli
