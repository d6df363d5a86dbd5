#include "product/parts.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include <planish/measure/material.h>

#include "mesh/split.h"
#include "model/model_flags.h"
#include "output/pattern_output.h"
#include "platform/path.h"
#include "product/orient.h"
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

/// The patches of one file.
std::vector<ProductPatch> patches_of(const Model& model, const std::string& path) {
  std::vector<ProductPatch> patches;
  patches.reserve(model.pieces.size());
  if (model.pieces.size() == 1) patches.push_back({model.pieces.front(), model.mesh});
  if (model.pieces.size() > 1) {
    for (NamedPatch& piece : split(model.mesh, model.piece_of, model.pieces))
      patches.push_back({std::move(piece.name), std::move(piece.mesh)});
  }
  for (ProductPatch& patch : patches)
    patch.words.source = path;
  return patches;
}

/// What stands for the patches of a file that cannot be read. To be called in a handler.
ProductPatch unreadable(std::string name, const std::string& path) {
  ProductPatch patch{std::move(name), {}, {}, current_failure()};
  patch.words.source = path;
  return patch;
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

/// Names that the pieces of several files have.
class KnownNames {
 public:
  void add(const Model& model) {
    names_.insert(names_.end(), model.names.begin(), model.names.end());
  }
  /// @throws Error unknown_name where a flag has one that none of the files knows
  void check(const Arguments& arguments) const {
    if (!names_.empty()) check_names(model_options_from(arguments), names_);
  }

 private:
  std::vector<std::string> names_;
};

ProductInput read_files(Session& session, const std::vector<std::string>& paths,
                        const Arguments& arguments, bool as_product) {
  ProductInput input;
  std::vector<MeshFormat> formats;
  std::vector<std::size_t> groups;  // number of the file, of each patch
  const std::vector<std::string> files = mesh_files(session, paths);
  KnownNames known;
  for (const std::string& file : files) {
    try {
      Model whole = read_model_of_several(file, stem_of(file), {}, arguments, session);
      known.add(whole);
      std::vector<ProductPatch> patches = patches_of(whole, file);
      std::move(patches.begin(), patches.end(), std::back_inserter(input.patches));
      formats.resize(input.patches.size(), whole.format);
      if (whole.pieces.empty()) continue;
      input.whole = std::move(whole);
      input.path = file;
    } catch (const Error& error) {
      if (files.size() == 1 || is_of_usage(error)) throw;
      input.patches.push_back(unreadable(stem_of(file), file));
      formats.push_back(MeshFormat::obj);
    }
    groups.resize(input.patches.size(), groups.empty() ? 0 : groups.back() + 1);
  }
  known.check(arguments);
  input.places = places_of(input.patches, formats);
  input.is_batch = files.size() > 1 && !as_product;
  for (std::size_t p = 0; input.is_batch && p < groups.size(); ++p)
    input.patches[p].group = groups[p];
  return input;
}

ProductInput read_file(Session& session, const std::string& path, const Arguments& arguments) {
  ProductInput input;
  input.path = path;
  input.whole = read_model(path, arguments, session);
  input.patches = patches_of(input.whole, path);
  input.places = places_of(input.patches, std::vector(input.patches.size(), input.whole.format));
  if (input.patches.size() > 1) {
    const std::string& kind = input.whole.divided_by;
    session.note(path + ": " + std::to_string(input.patches.size()) + " patches" +
                 (kind.empty() ? "" : ", divided by " + kind));
  }
  return input;
}

/// The patches of the file of a piece under the names of the piece, in the unit of the product.
std::vector<ProductPatch> patches_of(const RequestedPiece& piece, Session& session,
                                     const Arguments& arguments, KnownNames& known) {
  const std::string name = piece.name.value_or(stem_of(piece.file));
  const Model model = read_model_of_several(piece.file, name, piece.unit, arguments, session);
  known.add(model);
  std::vector<ProductPatch> patches = patches_of(model, piece.file);
  const std::vector<std::string> names = numbered_names(name, patches.size());
  for (std::size_t k = 0; piece.name && k < patches.size(); ++k)
    patches[k].name = names[k];
  return patches;
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
ProductPatch mirrored(ProductPatch patch, std::size_t group) {
  patch.name += ", mirrored";
  for (Vec3& p : patch.mesh.positions)
    p.x = -p.x;
  for (Triangle& t : patch.mesh.triangles)
    std::swap(t[1], t[2]);
  patch.group = group;
  return patch;
}

void check_seams(const ProductInput& input, const std::string& path) {
  std::set<std::string> names;
  for (const ProductPatch& patch : input.patches)
    names.insert(patch.name);
  for (std::size_t s = 0; s < input.seams.size(); ++s) {
    for (const std::string& name : input.seams[s].between) {
      if (names.contains(name)) continue;
      throw Error(ErrorCode::malformed_file,
                  "seams[" + std::to_string(s) + "].between: no piece is called \"" + name +
                      "\"; there are " +
                      list_of(std::vector<std::string>(names.begin(), names.end())),
                  {.path = path});
    }
  }
}

ProductInput read_described(Session& session, const std::string& path, const Arguments& arguments) {
  const ProductFile product = read_product_file(path);
  ProductInput input;
  input.path = path;
  input.is_described = true;
  input.seams = product.seams;
  KnownNames known;
  for (const RequestedPiece& piece : product.pieces) {
    std::vector<ProductPatch> patches;
    try {
      patches = patches_of(piece, session, arguments, known);
    } catch (const Error& error) {
      if (is_of_usage(error)) throw;
      patches.push_back(unreadable(piece.name.value_or(stem_of(piece.file)), piece.file));
    }
    for (ProductPatch& patch : patches) {
      input.patches.push_back(with_words(std::move(patch), piece));
      if (!piece.mirrored || input.patches.back().failure) continue;
      input.patches.push_back(mirrored(input.patches.back(), input.patches.size()));
    }
  }
  known.check(arguments);
  input.places = places_of(input.patches, std::vector(input.patches.size(), MeshFormat::obj));
  check_seams(input, path);
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

/// The names with a number behind those that are there already, whatever their capitals.
std::vector<std::string> distinct(const std::vector<std::string>& names) {
  std::set<std::string> taken;
  std::map<std::string, int> next;  // number to try, where names are alike: many may be
  std::vector<std::string> result;
  result.reserve(names.size());
  for (const std::string& name : names) {
    std::string given = name;
    int& k = next.try_emplace(in_small_letters(name), 2).first->second;
    while (!taken.insert(in_small_letters(given)).second)
      given = name + "-" + std::to_string(k++);
    result.push_back(std::move(given));
  }
  return result;
}

ProductInput with_distinct_names(ProductInput input) {
  std::vector<std::string> names;
  names.reserve(input.patches.size());
  for (const ProductPatch& patch : input.patches)
    names.push_back(patch.name);
  names = distinct(names);
  for (std::size_t p = 0; p < names.size(); ++p)
    input.patches[p].name = std::move(names[p]);
  return input;
}

}  // namespace

std::vector<std::string> safe_names(const std::vector<std::string>& names) {
  std::vector<std::string> safe(names.size());
  std::transform(names.begin(), names.end(), safe.begin(), safe_name);
  return distinct(safe);
}

ProductInput read_product(Session& session, const std::vector<std::string>& paths,
                          const Arguments& arguments, bool as_product) {
  const std::string& path = paths.front();
  ProductInput input;
  if (paths.size() > 1 || is_folder(path))
    input = with_distinct_names(read_files(session, paths, arguments, as_product));
  else if (is_product_file(path))
    input = read_described(session, path, arguments);
  else
    input = with_distinct_names(read_file(session, path, arguments));
  if (input.patches.empty())
    throw Error(ErrorCode::no_triangles, "the flags leave nothing of the files", {.path = path});
  if (input.patches.size() > 1 && !arguments.has("--strict"))
    turn_inside_out(input.patches, seam_tolerance_from(arguments), session);
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
  }
  input.places = places_of(input.patches, std::vector(input.patches.size(), input.whole.format));
  if (input.patches.size() > 1) {
    session.note(input.path + ": the cut makes " + std::to_string(input.patches.size()) +
                 " patches");
  }
  return cut.cut;
}

}  // namespace planish::cli
