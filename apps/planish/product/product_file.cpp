#include "product/product_file.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <planish/core/error.h>
#include <planish/measure/material.h>

#include "flags/units.h"
#include "model/json_file.h"
#include "model/material_file.h"
#include "piece/piece_keys.h"
#include "platform/path.h"
#include "shell/file_name.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

constexpr long long k_most_pieces_to_cut = 1'000'000;

/// One of materials(), or one of its own file, which is relative to the folder.
std::optional<Material> material_of(const JsonEntry& entry, const fs::path& folder) {
  const auto word = entry.text("material");
  if (!word) return std::nullopt;
  if (is_material_file(*word)) return read_material_file(utf8_of(folder / path_of(*word)));
  const std::vector<std::string> names = material_names();
  if (std::find(names.begin(), names.end(), *word) == names.end()) {
    refuse(entry.where("material"),
           "is \"" + *word + "\" but must be " + list_of(names) + ", or a .json file of your own");
  }
  return material_named(*word);
}

std::optional<int> quantity_of(const JsonEntry& entry) {
  const Json* value = entry.find("quantity");
  if (value == nullptr) return std::nullopt;
  const bool is_count = value->is_number_unsigned() && value->get<unsigned long long>() >= 1 &&
                        value->get<unsigned long long>() <= k_most_pieces_to_cut;
  if (!is_count) {
    refuse(entry.where("quantity"),
           "must be a whole number from 1 to " + std::to_string(k_most_pieces_to_cut));
  }
  return value->get<int>();
}

std::optional<Unit> unit_of(const JsonEntry& entry) {
  const auto word = entry.text("unit");
  if (!word) return std::nullopt;
  const auto unit = unit_of_word(*word);
  if (!unit) refuse(entry.where("unit"), "is \"" + *word + "\" but must be mm, cm, dm, m or in");
  return unit;
}

/// Keys that have places of their own in RequestedPiece.
const std::vector<std::string>& own_keys() {
  static const std::vector<std::string> keys = {"file",     "name", "material", "quantity",
                                                "mirrored", "unit", "sizes"};
  return keys;
}

bool is_own_key(const std::string& key) {
  return std::find(own_keys().begin(), own_keys().end(), key) != own_keys().end();
}

/// Those of every piece, and those of edges that this one has.
std::vector<std::string> keys_of(const Json& json) {
  std::vector<std::string> keys = own_keys();
  for (const std::string& key : piece_keys()) {
    if (!is_own_key(key)) keys.push_back(key);
  }
  if (!json.is_object()) return keys;
  for (const auto& [key, value] : json.items()) {
    if (is_edge_key(key)) keys.push_back(key);
  }
  return keys;
}

/// A text, a number, or yes and no, as it would be typed.
std::string typed(const JsonEntry& entry, const std::string& key, const Json& value) {
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number_integer()) return std::to_string(value.get<long long>());
  if (value.is_number()) return plain(value.get<double>());
  return *entry.text(key);
}

std::vector<PieceSetting> settings_of(const Json& json, const JsonEntry& entry,
                                      const fs::path& folder) {
  std::vector<PieceSetting> settings;
  for (const auto& [key, value] : json.items()) {
    const bool is_count = key == "mirrored" && value.is_number_unsigned();
    if (is_own_key(key) && !is_count) continue;
    std::string text = typed(entry, key, value);
    if (is_file_key(key) && text != "none") text = utf8_of(folder / path_of(text));
    settings.push_back({key, std::move(text)});
  }
  return settings;
}

RequestedPiece piece_of(const Json& json, const JsonEntry& entry, const std::string& file,
                        const fs::path& folder) {
  const Json* mirrored = entry.find("mirrored");
  const bool is_count = mirrored != nullptr && mirrored->is_number_unsigned();
  RequestedPiece piece{.file = utf8_of(folder / path_of(file)),
                       .name = entry.text("name"),
                       .material = material_of(entry, folder),
                       .unit = unit_of(entry),
                       .quantity = quantity_of(entry),
                       .mirrored = !is_count && entry.yes("mirrored"),
                       .settings = settings_of(json, entry, folder)};
  if (piece.mirrored && piece.quantity.value_or(2) % 2 != 0)
    refuse(entry.where("quantity"), "must be even where half of the pieces are mirrored");
  return piece;
}

/// Of each size one, called "NAME-SIZE".
std::vector<RequestedPiece> sizes_of(const Json& json, const JsonEntry& entry,
                                     const fs::path& folder, std::vector<std::string>& sizes) {
  const Json& files = *entry.find("sizes");
  if (!files.is_object() || files.empty())
    refuse(entry.where("sizes"), "must name a file for each size: {\"54\": \"tip-54.obj\"}");
  if (entry.find("file") != nullptr)
    refuse(entry.where("file"), "and sizes are both given: leave one of them away");
  const std::string style = entry.required_text("name");
  std::vector<RequestedPiece> pieces;
  for (const auto& [size, file] : files.items()) {
    if (!file.is_string()) refuse(entry.where("sizes") + "." + size, "must be the path of a file");
    RequestedPiece& piece =
        pieces.emplace_back(piece_of(json, entry, file.get<std::string>(), folder));
    piece.name = style + "-" + size;
    piece.style = style;
    piece.size =
        static_cast<std::size_t>(std::find(sizes.begin(), sizes.end(), size) - sizes.begin());
    if (piece.size == sizes.size()) sizes.push_back(size);
    piece.settings.push_back({"size", size});
  }
  return pieces;
}

/// One, or of several sizes one of each.
std::vector<RequestedPiece> pieces_of(const Json& json, const std::string& where,
                                      const fs::path& folder, std::vector<std::string>& sizes) {
  const JsonEntry entry(json, where, keys_of(json));
  if (entry.find("sizes") != nullptr) return sizes_of(json, entry, folder, sizes);
  return {piece_of(json, entry, entry.required_text("file"), folder)};
}

/// A seam between pieces of several sizes is one in each size.
std::vector<NamedSeam> seams_in_sizes(const NamedSeam& seam,
                                      const std::vector<RequestedPiece>& pieces,
                                      const std::vector<std::string>& sizes) {
  const auto is_called = [&](const std::string& name) {
    return std::any_of(pieces.begin(), pieces.end(),
                       [&](const RequestedPiece& piece) { return piece.name == name; });
  };
  std::vector<NamedSeam> seams;
  for (const std::string& size : sizes) {
    NamedSeam own = seam;
    for (std::string& name : own.between)
      name += "-" + size;
    if (is_called(own.between[0]) && is_called(own.between[1])) seams.push_back(std::move(own));
  }
  return seams.empty() ? std::vector<NamedSeam>{seam} : seams;
}

NamedSeam seam_of(const Json& json, const std::string& where) {
  static const std::vector<std::string> keys = {"name", "between"};
  const JsonEntry entry(json, where, keys);
  NamedSeam seam{entry.required_text("name"), {}};
  const Json* between = entry.find("between");
  const bool are_two = between != nullptr && between->is_array() && between->size() == 2 &&
                       (*between)[0].is_string() && (*between)[1].is_string();
  if (!are_two) refuse(entry.where("between"), "must be the names of two pieces: [\"A\", \"B\"]");
  seam.between = {(*between)[0].get<std::string>(), (*between)[1].get<std::string>()};
  return seam;
}

const Json& list_in(const JsonEntry& entry, std::string_view key) {
  static const Json none = Json::array();
  const Json* list = entry.find(key);
  if (list == nullptr) return none;
  if (!list->is_array()) refuse(std::string(key), "must be a list: [...]");
  return *list;
}

/// "pieces[1]"
std::string place_in(std::string_view list, std::size_t k) {
  return std::string(list) + "[" + std::to_string(k) + "]";
}

void refuse_equal_names(const std::vector<RequestedPiece>& pieces) {
  std::set<std::string> names;
  for (const RequestedPiece& piece : pieces) {
    if (piece.name && !names.insert(*piece.name).second)
      refuse(place_in("pieces", piece.entry) + ".name", "\"" + *piece.name + "\" is already taken");
  }
}

ProductFile product_of(const Json& json, const fs::path& folder) {
  static const std::vector<std::string> keys = {"pieces", "seams"};
  const JsonEntry entry(json, "product", keys);
  const Json& pieces = list_in(entry, "pieces");
  const Json& seams = list_in(entry, "seams");
  if (pieces.empty()) refuse("pieces", "must list at least one piece");
  ProductFile product;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    for (RequestedPiece& piece :
         pieces_of(pieces[k], place_in("pieces", k), folder, product.sizes)) {
      piece.entry = k;
      product.pieces.push_back(std::move(piece));
    }
  }
  for (std::size_t k = 0; k < seams.size(); ++k) {
    const NamedSeam seam = seam_of(seams[k], place_in("seams", k));
    for (NamedSeam& own : seams_in_sizes(seam, product.pieces, product.sizes))
      product.seams.push_back(std::move(own));
  }
  refuse_equal_names(product.pieces);
  return product;
}

}  // namespace

bool is_product_file(const std::string& path) {
  return lower_extension(path) == ".json";
}

ProductFile read_product_file(const std::string& path) try {
  return product_of(read_json_file(path, "a product file"), path_of(path).parent_path());
} catch (const Error& error) {
  // Of a material file the place is there already.
  SourceLocation place = error.place();
  if (place.path.empty()) place.path = path;
  throw Error(error.code(), error.message(), place);
}

}  // namespace planish::cli
