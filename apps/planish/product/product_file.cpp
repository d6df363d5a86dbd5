#include "product/product_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <span>
#include <string_view>
#include <system_error>

#include <planish/core/error.h>
#include <planish/measure/material.h>

#include <planish_json/json.h>

#include "flags/units.h"
#include "platform/path.h"
#include "shell/file_name.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t k_largest_file = 4'000'000;  // bytes
constexpr long long k_most_pieces_to_cut = 1'000'000;

/// What is wrong, and where: "pieces[1]: ...".
[[noreturn]] void refuse(const std::string& where, const std::string& what) {
  throw Error(ErrorCode::malformed_file, where + ": " + what);
}

std::vector<std::string> names_of_materials() {
  std::vector<std::string> names;
  for (const Material& material : materials())
    names.emplace_back(material.name);
  return names;
}

/// An object of the file, with its place there.
class Entry {
 public:
  /// @throws Error for what is no object, and for a key that is none of those
  Entry(const Json& json, std::string where, std::span<const std::string> keys)
      : json_(json), where_(std::move(where)) {
    if (!json.is_object()) refuse(where_, "must be an object: {...}");
    for (const auto& [key, value] : json.items()) {
      if (std::find(keys.begin(), keys.end(), key) == keys.end())
        refuse(where_, "unknown key \"" + key + "\"; known are " + list_of(keys));
    }
  }

  const std::string& where() const { return where_; }
  std::string where(std::string_view key) const { return where_ + "." + std::string(key); }

  const Json* find(std::string_view key) const {
    const auto found = json_.find(std::string(key));
    return found == json_.end() ? nullptr : &*found;
  }

  /// Not empty.
  std::optional<std::string> text(std::string_view key) const {
    const Json* value = find(key);
    if (value == nullptr) return std::nullopt;
    if (!value->is_string() || value->get<std::string>().empty())
      refuse(where(key), "must be a text in quotes");
    return value->get<std::string>();
  }

  std::string required_text(std::string_view key) const {
    const auto value = text(key);
    if (!value) refuse(where_, "needs \"" + std::string(key) + "\"");
    return *value;
  }

  bool yes(std::string_view key) const {
    const Json* value = find(key);
    if (value == nullptr) return false;
    if (!value->is_boolean()) refuse(where(key), "must be true or false");
    return value->get<bool>();
  }

 private:
  const Json& json_;
  std::string where_;
};

std::string known(const Entry& entry, std::string_view key, const std::string& value,
                  std::span<const std::string> names) {
  if (std::find(names.begin(), names.end(), value) == names.end())
    refuse(entry.where(key), "is \"" + value + "\" but must be " + list_of(names));
  return value;
}

std::optional<int> quantity_of(const Entry& entry) {
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

std::optional<Unit> unit_of(const Entry& entry) {
  const auto word = entry.text("unit");
  if (!word) return std::nullopt;
  const auto unit = unit_of_word(*word);
  if (!unit) refuse(entry.where("unit"), "is \"" + *word + "\" but must be mm, cm, dm, m or in");
  return unit;
}

RequestedPiece piece_of(const Json& json, const std::string& where, const fs::path& folder) {
  static const std::vector<std::string> keys = {"file",     "name",     "material",
                                                "quantity", "mirrored", "unit"};
  const Entry entry(json, where, keys);
  RequestedPiece piece{.file = utf8_of(folder / path_of(entry.required_text("file"))),
                       .name = entry.text("name"),
                       .material = entry.text("material"),
                       .unit = unit_of(entry),
                       .quantity = quantity_of(entry),
                       .mirrored = entry.yes("mirrored")};
  if (piece.material) known(entry, "material", *piece.material, names_of_materials());
  if (piece.mirrored && piece.quantity.value_or(2) % 2 != 0)
    refuse(entry.where("quantity"), "must be even where half of the pieces are mirrored");
  return piece;
}

NamedSeam seam_of(const Json& json, const std::string& where) {
  static const std::vector<std::string> keys = {"name", "between"};
  const Entry entry(json, where, keys);
  NamedSeam seam{entry.required_text("name"), {}};
  const Json* between = entry.find("between");
  const bool are_two = between != nullptr && between->is_array() && between->size() == 2 &&
                       (*between)[0].is_string() && (*between)[1].is_string();
  if (!are_two) refuse(entry.where("between"), "must be the names of two pieces: [\"A\", \"B\"]");
  seam.between = {(*between)[0].get<std::string>(), (*between)[1].get<std::string>()};
  return seam;
}

const Json& list_in(const Entry& entry, std::string_view key) {
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
  const Entry entry(json, "product", keys);
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

std::string content_of(const std::string& path) {
  std::error_code failure;
  const std::uintmax_t size = fs::file_size(path_of(path), failure);
  if (failure) throw Error(ErrorCode::file_unreadable, failure.message());
  if (size > k_largest_file) throw Error(ErrorCode::too_large, "a product file has at most 4 MB");
  std::ifstream file(path_of(path), std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(file), {}};
  if (!file && !file.eof()) throw Error(ErrorCode::file_unreadable, "cannot be read");
  return content;
}

}  // namespace

bool is_product_file(const std::string& path) {
  return lower_extension(path) == ".json";
}

ProductFile read_product_file(const std::string& path) try {
  const Json json = parse_shallow(content_of(path));
  if (json.is_discarded()) throw Error(ErrorCode::malformed_file, "is no JSON");
  return product_of(json, path_of(path).parent_path());
} catch (const Error& error) {
  throw Error(error.code(), error.message(), {.path = path});
}

}  // namespace planish::cli
