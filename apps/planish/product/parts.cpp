#include "product/parts.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <set>
#include <string_view>
#include <utility>

#include <planish/measure/material.h>
#include <planish/mesh/repair.h>

#include "mesh/split.h"
#include "model/model_flags.h"
#include "model/orient.h"
#include "output/pattern_output.h"
#include "platform/path.h"
#include "product/seams.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/text.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

bool is_mesh_file(const fs::path& path) {
  const std::string extension = lower_extension(utf8_of(path));
  return std::any_of(k_mesh_formats.begin(), k_mesh_formats.end(), [&](MeshFormat format) {
    return extension == "." + std::string(to_string(format));
  });
}

/// "a.glb, b.step and 3 more"
std::string names_of(const std::vector<fs::path>& files) {
  constexpr std::size_t k_most = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(files.size(), k_most); ++i)
    text += (i > 0 ? ", " : "") + utf8_of(files[i].filename());
  if (files.size() > k_most) text += " and " + std::to_string(files.size() - k_most) + " more";
  return text;
}

}  // namespace

std::vector<std::string> mesh_files_in(Session& session, const std::string& folder) {
  std::error_code failure;
  std::vector<fs::path> files, others;
  for (const fs::path& entry : entries_of(path_of(folder), failure)) {
    std::error_code ignored;
    if (!fs::is_regular_file(entry, ignored)) continue;
    if (is_mesh_file(entry)) files.push_back(entry);
    if (is_other_model(entry)) others.push_back(entry);
  }
  if (failure) throw Error(ErrorCode::file_unreadable, failure.message(), {.path = folder});
  std::sort(others.begin(), others.end());
  const std::string advice = "export a mesh as OBJ or STL from the program that made it";
  if (files.empty()) {
    throw Error(ErrorCode::file_unreadable,
                "the folder holds no mesh file: .obj, .ply, .stl or .off" +
                    (others.empty() ? "" : "; of " + names_of(others) + " " + advice),
                {.path = folder});
  }
  if (!others.empty()) {
    session.note(folder + ": skipped " + names_of(others) + ", which cannot be read; of each " +
                 advice);
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> names;
  names.reserve(files.size());
  for (const fs::path& file : files)
    names.push_back(utf8_of(file));
  return names;
}

namespace {

/// A piece of a file, with those that are left out: they tell how the others have to lie.
struct ReadPiece {
  ProductPatch patch;
  bool is_taken = true;
  MeshFormat format = MeshFormat::obj;
  std::string in_file = {};  ///< its name there; in the product it may have another
  /// Names that several pieces have together, as a piece and its mirror image.
  std::vector<std::string> asked_as = {};
  bool is_image = false;  ///< the mirror image of the one before it
};

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

/// What stands for the pieces of a file that cannot be read. To be called in a handler.
ReadPiece unreadable(std::string name, const std::string& path, std::size_t group) {
  ReadPiece piece{{std::move(name), {}, {}, current_failure(), group}};
  piece.patch.words.source = path;
  return piece;
}

/// Safe folders for all patches.
std::vector<PatchPlace> places_of(const std::vector<ProductPatch>& patches,
                                  const std::vector<MeshFormat>& formats) {
  std::vector<std::string> names;
  names.reserve(patches.size());
  for (const ProductPatch& patch : patches)
    names.push_back(patch.name);
  const std::vector<std::string> folders = safe_names(names);
  std::vector<PatchPlace> places;
  places.reserve(patches.size());
  for (std::size_t p = 0; p < patches.size(); ++p)
    places.push_back({folders[p], formats[p]});
  return places;
}

bool is_folder(const std::string& path) {
  std::error_code ignored;
  return fs::is_directory(path_of(path), ignored);
}

/// The files that are named, and those in folders that are.
std::vector<std::string> mesh_files(Session& session, const std::vector<std::string>& paths) {
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    if (is_product_file(path)) {
      throw UsageError("a product file lists its files itself: give " + path +
                       " without any others");
    }
    const std::vector<std::string> here =
        is_folder(path) ? mesh_files_in(session, path) : std::vector<std::string>{path};
    files.insert(files.end(), here.begin(), here.end());
  }
  return files;
}

bool is_among(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The pieces of all files, before flags choose among them by the names that they get in the
/// product.
struct AllPieces {
  std::vector<ReadPiece> pieces = {};
  std::vector<std::string> known = {};  ///< names in the files, by which each file was read
  Model last = {};                      ///< of the last file of which something was taken
  std::string path = {};                ///< of that

  void add(Model model, const std::string& from, std::size_t group) {
    std::vector<ReadPiece> some = pieces_of(model, from, group);
    std::move(some.begin(), some.end(), std::back_inserter(pieces));
    known.insert(known.end(), model.names.begin(), model.names.end());
    if (model.pieces.empty()) return;
    last = std::move(model);
    path = from;
  }

  std::size_t taken() const {
    return static_cast<std::size_t>(std::count_if(
        pieces.begin(), pieces.end(), [](const ReadPiece& piece) { return piece.is_taken; }));
  }
};

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

/// Takes and leaves out what flags call by names that no file has: "Front-2" of the second file
/// with a piece Front, "Front, mirrored".
/// @throws UsageError where a name could mean two pieces, Error unknown_name
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

/// The mirror image of a piece; null where it has none.
ReadPiece* image_of(std::vector<ReadPiece>& pieces, std::size_t p) {
  return p + 1 < pieces.size() && pieces[p + 1].is_image ? &pieces[p + 1] : nullptr;
}

void turn_over(ProductPatch& patch) {
  patch.mesh = turned_over(std::move(patch.mesh));
  patch.turned = true;
}

/// Turns over the pieces that are inside out against a neighbour, with their mirror images.
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

/// The model of an input of one patch.
Model model_of_one(AllPieces all, const ReadPiece& piece) {
  Model model = std::move(all.last);
  const bool is_its_own =
      model.pieces.size() == 1 && model.mesh.positions == piece.patch.mesh.positions;
  if (!is_its_own) {
    model.mesh = piece.patch.mesh;
    model.format = piece.format;
    model.piece_of.assign(model.mesh.triangles.size(), 0);
  } else if (piece.patch.turned) {
    model.mesh = turned_over(std::move(model.mesh));
  }
  model.pieces = {piece.patch.name};
  model.turned = piece.patch.turned;
  model.left_out.clear();
  return model;
}

/// What is taken of the pieces.
ProductInput input_of(AllPieces all, const Arguments& arguments, Session& session) {
  choose_by_names_of_product(all, arguments);
  turn_inside_out(all, arguments, session);
  ProductInput input;
  std::vector<MeshFormat> formats;
  for (const ReadPiece& piece : all.pieces) {
    if (!piece.is_taken) {
      input.left_out.push_back(piece.patch.name);
      continue;
    }
    input.patches.push_back(piece.patch);
    formats.push_back(piece.format);
  }
  input.places = places_of(input.patches, formats);
  if (input.patches.size() != 1) return input;
  const ReadPiece one = *std::find_if(all.pieces.begin(), all.pieces.end(),
                                      [](const ReadPiece& piece) { return piece.is_taken; });
  input.path = one.patch.words.source;
  input.whole = model_of_one(std::move(all), one);
  return input;
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

ProductInput read_files(Session& session, const std::vector<std::string>& paths,
                        const Arguments& arguments, bool as_product) {
  const std::vector<std::string> files = mesh_files(session, paths);
  const bool is_batch = files.size() > 1 && !as_product;
  AllPieces all;
  for (std::size_t f = 0; f < files.size(); ++f) {
    const std::string& file = files[f];
    const std::size_t group = is_batch ? f : 0;
    try {
      all.add(read_model_of_several({file, stem_of(file)}, arguments, session), file, group);
    } catch (const Error& error) {
      if (files.size() == 1 || is_of_usage(error)) throw;
      all.pieces.push_back(unreadable(stem_of(file), file, group));
    }
  }
  ProductInput input = input_of(with_distinct_names(std::move(all)), arguments, session);
  input.is_batch = is_batch;
  return input;
}

ProductInput read_file(Session& session, const std::string& path, const Arguments& arguments) {
  AllPieces all;
  all.add(read_model_of_several({path, stem_of(path)}, arguments, session), path, 0);
  const std::string divided_by = all.last.divided_by;
  ProductInput input = input_of(std::move(all), arguments, session);
  input.path = path;
  if (input.patches.size() > 1) {
    session.note(path + ": " + std::to_string(input.patches.size()) + " patches" +
                 (divided_by.empty() ? "" : ", divided by " + divided_by));
  }
  return input;
}

constexpr const char* k_mirrored = ", mirrored";

/// The pieces of the file of a piece under the names of the piece, in the unit of the product.
AllPieces pieces_of(const RequestedPiece& piece, const std::vector<std::string>& known,
                    Session& session, const Arguments& arguments) {
  const std::string name = piece.name.value_or(stem_of(piece.file));
  AllPieces all;
  all.add(read_model_of_several({piece.file, name, piece.unit, known}, arguments, session),
          piece.file, 0);
  if (!piece.name) return all;
  const std::vector<std::string> names = numbered_names(name, all.pieces.size());
  for (std::size_t k = 0; k < names.size(); ++k) {
    all.pieces[k].patch.name = names[k];
    all.pieces[k].asked_as = {name};
  }
  return all;
}

/// What a product file says of a piece besides its form.
ProductPatch with_words(ProductPatch patch, const RequestedPiece& piece) {
  const int all = piece.quantity.value_or(piece.mirrored ? 2 : 0);
  patch.words.material = piece.material.value_or("");
  patch.words.quantity = piece.mirrored ? all / 2 : all;
  if (piece.material)
    patch.limits = StrainLimits{.p99 = material_named(*piece.material).max_strain};
  return patch;
}

/// Its mirror image, which is sewn to nothing: where it will lie is not known.
ReadPiece mirrored(ReadPiece piece, std::size_t group) {
  ProductPatch& patch = piece.patch;
  piece.asked_as.push_back(patch.name);
  patch.name += k_mirrored;
  for (Vec3& p : patch.mesh.positions)
    p.x = -p.x;
  for (Triangle& t : patch.mesh.triangles)
    std::swap(t[1], t[2]);
  patch.group = group;
  piece.is_image = true;
  return piece;
}

/// The seams between pieces that are there.
std::vector<NamedSeam> seams_of(const std::vector<NamedSeam>& asked, const ProductInput& input,
                                const std::string& path, Session& session) {
  std::set<std::string> names;
  for (const ProductPatch& patch : input.patches)
    names.insert(patch.name);
  std::vector<NamedSeam> seams;
  std::vector<std::string> dropped;
  for (std::size_t s = 0; s < asked.size(); ++s) {
    bool is_there = true;
    for (const std::string& name : asked[s].between) {
      if (names.contains(name)) continue;
      is_there = false;
      if (is_among(input.left_out, name)) continue;
      names.insert(input.left_out.begin(), input.left_out.end());
      throw Error(ErrorCode::malformed_file,
                  "seams[" + std::to_string(s) + "].between: no piece is called \"" + name +
                      "\"; there are " +
                      list_of(std::vector<std::string>(names.begin(), names.end())),
                  {.path = path});
    }
    if (is_there)
      seams.push_back(asked[s]);
    else
      dropped.push_back(asked[s].name);
  }
  if (!dropped.empty())
    session.note(path +
                 ": without the seams to pieces that are left out: " + list_of_some(dropped));
  return seams;
}

/// The names with commas that pieces of a product get.
std::vector<std::string> names_with_commas(const ProductFile& product) {
  std::vector<std::string> names;
  for (const RequestedPiece& piece : product.pieces) {
    const std::string name = piece.name.value_or(stem_of(piece.file));
    names.push_back(name);
    if (piece.mirrored) names.push_back(name + k_mirrored);
  }
  return names;
}

ProductInput read_described(Session& session, const std::string& path, const Arguments& arguments) {
  const ProductFile product = read_product_file(path);
  const std::vector<std::string> known = names_with_commas(product);
  AllPieces all;
  for (const RequestedPiece& piece : product.pieces) {
    AllPieces own;
    try {
      own = pieces_of(piece, known, session, arguments);
    } catch (const Error& error) {
      if (is_of_usage(error)) throw;
      own.pieces.push_back(unreadable(piece.name.value_or(stem_of(piece.file)), piece.file, 0));
    }
    all.known.insert(all.known.end(), own.known.begin(), own.known.end());
    for (ReadPiece& read : own.pieces) {
      read.patch = with_words(std::move(read.patch), piece);
      all.pieces.push_back(std::move(read));
      if (!piece.mirrored || all.pieces.back().patch.failure) continue;
      all.pieces.push_back(mirrored(all.pieces.back(), all.pieces.size()));
    }
  }
  ProductInput input = input_of(std::move(all), arguments, session);
  input.path = path;
  input.is_described = true;
  input.seams = seams_of(product.seams, input, path, session);
  return input;
}

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
         c == '_' || c == '.';
}

/// Shows nothing, or turns what stands around it: a name could look like another one.
bool is_invisible(char32_t c) {
  return c < 0xA0 || (c >= 0x200B && c <= 0x200F) || (c >= 0x2028 && c <= 0x202E) ||
         (c >= 0x2060 && c <= 0x206F) || c == 0xFEFF || c == 0xAD || c == 0x61C;
}

/// Length of the letter beyond ASCII that begins there; 0 where there is none, or none to be seen.
std::size_t letter_length(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return 0;
  char32_t value = lead & (0xFFU >> (length + 1));
  for (const char c : text.substr(1, length - 1)) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0U) != 0x80U) return 0;
    value = value << 6U | (byte & 0x3FU);
  }
  constexpr std::array<char32_t, 5> smallest = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_letter = value >= smallest.at(length) && value <= 0x10FFFF &&
                         (value < 0xD800 || value > 0xDFFF) && !is_invisible(value);
  return is_letter ? length : 0;
}

std::string in_small_letters(std::string name) {
  for (char& c : name) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return name;
}

/// Windows takes these, whatever follows a dot, for devices.
bool is_device(const std::string& name) {
  const std::string stem = in_small_letters(name.substr(0, name.find('.')));
  if (stem == "con" || stem == "prn" || stem == "aux" || stem == "nul") return true;
  const std::string kind = stem.substr(0, 3);
  return stem.size() == 4 && (kind == "com" || kind == "lpt") && stem[3] >= '0' && stem[3] <= '9';
}

/// Whether a file beside the folders of patches could have the name: garment.json, layout-1.svg.
bool is_like_a_file(const std::string& name) {
  const std::string extension = lower_extension(name);
  constexpr std::array kinds = {".json", ".html", ".svg", ".dxf", ".pdf", ".plt"};
  return std::find(kinds.begin(), kinds.end(), extension) != kinds.end();
}

std::string safe_name(const std::string& name) {
  constexpr std::size_t k_longest_name = 80;
  std::string safe;
  safe.reserve(name.size());
  for (std::size_t i = 0; i < name.size();) {
    const std::size_t length =
        is_plain(name[i]) ? 1 : letter_length(std::string_view(name).substr(i));
    safe += length > 0 ? name.substr(i, length) : "_";
    i += std::max<std::size_t>(1, length);
  }
  safe = beginning(safe, k_longest_name);
  while (!safe.empty() && safe.back() == '.')
    safe.pop_back();  // Windows drops them
  if (!safe.empty() && (safe.front() == '.' || safe.front() == '-')) safe.front() = '_';
  if (safe.empty()) safe = "patch";
  return is_device(safe) || is_like_a_file(safe) ? safe + "_" : safe;
}

}  // namespace

std::vector<std::string> safe_names(const std::vector<std::string>& names) {
  std::vector<std::string> safe(names.size());
  std::transform(names.begin(), names.end(), safe.begin(), safe_name);
  return distinct_names(safe);
}

ProductInput read_product(Session& session, const std::vector<std::string>& paths,
                          const Arguments& arguments, bool as_product) {
  const std::string& path = paths.front();
  ProductInput input;
  if (paths.size() > 1 || is_folder(path))
    input = read_files(session, paths, arguments, as_product);
  else if (is_product_file(path))
    input = read_described(session, path, arguments);
  else
    input = read_file(session, path, arguments);
  if (input.patches.empty())
    throw Error(ErrorCode::no_triangles, "the flags leave nothing of the files", {.path = path});
  return input;
}

std::optional<CutDone> cut_product(ProductInput& input, const Arguments& arguments,
                                   Session& session) {
  if (!arguments.has("--cut")) return std::nullopt;
  if (input.patches.size() > 1 || input.is_described) {
    throw UsageError(
        "flag --cut goes with one patch only; the input has several: take one with --only NAME");
  }
  CutInput cut = cut_as_asked(std::move(input.whole.mesh), input.path, arguments, session);
  input.whole.mesh = std::move(cut.mesh);
  input.patches.clear();
  for (NamedPatch& piece : split(input.whole.mesh, input.whole.pieces.front())) {
    input.patches.push_back({std::move(piece.name), std::move(piece.mesh)});
    input.patches.back().words.source = input.path;
    input.patches.back().turned = input.whole.turned;
  }
  input.places = places_of(input.patches, std::vector(input.patches.size(), input.whole.format));
  if (input.patches.size() > 1) {
    session.note(input.path + ": the cut makes " + std::to_string(input.patches.size()) +
                 " patches");
  }
  return cut.cut;
}

}  // namespace planish::cli
