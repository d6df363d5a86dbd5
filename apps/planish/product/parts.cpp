#include "product/parts.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <string_view>
#include <utility>

#include <planish/measure/material.h>
#include <planish/mesh/repair.h>

#include "cut/requested_lines.h"
#include "cut/symmetric_design.h"
#include "mesh/split.h"
#include "model/model_flags.h"
#include "output/pattern_output.h"
#include "platform/path.h"
#include "product/read_pieces.h"
#include "product/safe_names.h"
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
  patch.words.material = piece.material ? piece.material->name : "";
  patch.words.quantity = piece.mirrored ? all / 2 : all;
  if (piece.material) patch.limits = limits_of(*piece.material);
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

namespace {

constexpr std::size_t k_most_pieces = 64;  // that --cut open makes of a part

/// Why a sound surface has to be divided before it is laid flat; nothing where it need not.
std::string reason_to_divide(const Patch& patch) {
  const Inspection& inspection = patch.inspection();
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

/// The pieces that a patch is cut into; to what was done to all is added what was done to it.
std::vector<ProductPatch> cut_patch(ProductPatch patch, const std::string& path,
                                    bool is_one_of_several, const Arguments& arguments,
                                    Session& session, CutInput& all) {
  CutInput cut = {};
  if (arguments.has("--cut") || asks_for_symmetry(arguments)) {
    cut = cut_as_asked(std::move(patch.mesh), path, arguments, session,
                       {.most_pieces = k_most_pieces, .match_seams = is_one_of_several});
  } else {
    const Patch whole(std::move(patch.mesh));
    if (const std::string reason = reason_to_divide(whole); !reason.empty()) {
      session.note(path + ": " + reason +
                   "; it is divided, as by --cut auto. Of a wall with a thickness --side takes one "
                   "side");
      cut = divided_into_panels(whole, path, arguments, session);
    } else {
      cut.mesh = whole.mesh();
    }
  }
  if (cut.cut) *all.cut += *cut.cut;
  all.symmetric_in = cut.symmetric_in;
  std::vector<ProductPatch> pieces;
  for (NamedPatch& piece : split(cut.mesh, patch.name)) {
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

std::optional<CutOutcome> cut_product(ProductInput& input, const Arguments& arguments,
                                      Session& session) {
  const bool is_cut = arguments.has("--cut"), is_symmetric = asks_for_symmetry(arguments);
  if (!is_symmetric && !is_cut) return std::nullopt;
  const bool are_several = input.patches.size() > 1 || input.is_described;
  if (are_several && (is_symmetric || asks_for_lines(arguments))) {
    throw UsageError(
        "flag " + std::string(is_symmetric ? "--symmetric" : "--cut") +
        " goes with one patch only, but for --cut open; the input has several: "
        "take one with --only NAME, or what hangs together as one with --divide parts");
  }
  CutInput all{{}, CutOutcome{}};
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
      pieces = cut_patch(std::move(input.patches[p]), path, are_several, arguments, session, all);
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
  return is_cut ? all.cut : std::nullopt;
}

}  // namespace planish::cli
