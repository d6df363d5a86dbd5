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
  static const std::vector<std::string> keys = {"file",     "name",     "material",
                                                "quantity", "mirrored", "unit"};
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

RequestedPiece piece_of(const Json& json, const std::string& where, const fs::path& folder) {
  const JsonEntry entry(json, where, keys_of(json));
  const Json* mirrored = entry.find("mirrored");
  const bool is_count = mirrored != nullptr && mirrored->is_number_unsigned();
  RequestedPiece piece{.file = utf8_of(folder / path_of(entry.required_text("file"))),
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
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (pieces[k].name && !names.insert(*pieces[k].name).second)
      refuse(place_in("pieces", k) + ".name", "\"" + *pieces[k].name + "\" is already taken");
  }
}

ProductFile product_of(const Json& json, const fs::path& folder) {
  static const std::vector<std::string> keys = {"pieces", "seams"};
  const JsonEntry entry(json, "product", keys);
  const Json& pieces = list_in(entry, "pieces");
  const Json& seams = list_in(entry, "seams");
  if (pieces.empty()) refuse("pieces", "must list at least one piece");
  ProductFile product;
  for (std::size_t k = 0; k < pieces.size(); ++k)
    product.pieces.push_back(piece_of(pieces[k], place_in("pieces", k), folder));
  for (std::size_t k = 0; k < seams.size(); ++k)
    product.seams.push_back(seam_of(seams[k], place_in("seams", k)));
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
