#include "product/parts.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include <planish/measure/material.h>
#include <planish/mesh/repair.h>

#include "mesh/split.h"
#include "model/model_flags.h"
#include "output/pattern_output.h"
#include "platform/path.h"
#include "product/read_pieces.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/safe_names.h"
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
    input.styles.push_back(piece.style);
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
  patch.words.material = piece.material ? piece.material->name : "";
  patch.words.quantity = piece.mirrored ? all / 2 : all;
  if (piece.material) patch.limits = limits_of(*piece.material);
  return patch;
}

/// Its mirror image, which is sewn to nothing: where it will lie is not known.
ReadPiece mirrored(ReadPiece piece, std::size_t group) {
  ProductPatch& patch = piece.patch;
  piece.asked_as.push_back(patch.name);
  patch.name += k_mirrored_piece;
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
      if (std::find(input.left_out.begin(), input.left_out.end(), name) != input.left_out.end())
        continue;
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
    if (piece.mirrored) names.push_back(name + k_mirrored_piece);
  }
  return names;
}

NamedSettings settings_of(const RequestedPiece& piece, const std::string& path) {
  const std::string name = piece.name.value_or(stem_of(piece.file));
  return {name, piece.settings, path + ", piece " + name};
}

/// Refuses sizes of one piece whose meshes differ in more than their places.
void check_sizes(const std::vector<ReadPiece>& pieces, const std::string& path) {
  std::map<std::string, const ReadPiece*> first;
  for (const ReadPiece& piece : pieces) {
    if (piece.style.empty() || piece.is_image || piece.patch.failure) continue;
    const ReadPiece& other = *first.try_emplace(piece.style, &piece).first->second;
    const TriMesh &mesh = piece.patch.mesh, &mesh_of_other = other.patch.mesh;
    if (mesh.triangles == mesh_of_other.triangles &&
        mesh.positions.size() == mesh_of_other.positions.size())
      continue;
    throw Error(ErrorCode::malformed_file,
                "\"" + piece.patch.name + "\" has other triangles than \"" + other.patch.name +
                    "\": meshes of one piece in several sizes must have the same vertices and "
                    "triangles in the same order, as notches and marks are given once for all",
                {.path = path});
  }
}

ProductInput read_described(Session& session, const std::string& path, const Arguments& arguments) {
  const ProductFile product = read_product_file(path);
  const std::vector<std::string> known = names_with_commas(product);
  AllPieces all;
  std::vector<NamedSettings> asked;
  for (const RequestedPiece& piece : product.pieces) {
    AllPieces own;
    try {
      own = pieces_of(piece, known, session, arguments);
    } catch (const Error& error) {
      if (is_of_usage(error)) throw;
      own.pieces.push_back(unreadable(piece.name.value_or(stem_of(piece.file)), piece.file, 0));
    }
    all.known.insert(all.known.end(), own.known.begin(), own.known.end());
    const NamedSettings settings = settings_of(piece, path);
    if (!settings.settings.empty()) asked.push_back(settings);
    const bool is_out = stays_out(settings, arguments);
    for (std::size_t k = 0; k < own.pieces.size(); ++k) {
      ReadPiece& read = own.pieces[k];
      read.is_taken = read.is_taken && !is_out;
      read.patch.group = piece.size;
      read.style = own.pieces.size() == 1 || piece.style.empty()
                       ? piece.style
                       : piece.style + "-" + std::to_string(k + 1);
      read.patch = with_words(std::move(read.patch), piece);
      all.pieces.push_back(std::move(read));
      if (!piece.mirrored || all.pieces.back().patch.failure) continue;
      all.pieces.push_back(mirrored(all.pieces.back(), product.sizes.size() + all.pieces.size()));
    }
  }
  check_sizes(all.pieces, path);
  ProductInput input = input_of(std::move(all), arguments, session);
  input.path = path;
  input.is_described = true;
  input.settings = std::move(asked);
  input.seams = seams_of(product.seams, input, path, session);
  return input;
}

}  // namespace

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

}  // namespace planish::cli
