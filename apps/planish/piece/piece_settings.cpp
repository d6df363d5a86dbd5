#include "piece/piece_settings.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <string_view>
#include <utility>

#include <planish/core/error.h>
#include <planish/measure/material.h>

#include "core/fnv_hash.h"
#include "flags/annotation_flags.h"
#include "flags/material_flag.h"
#include "flags/quantities.h"
#include "flags/units.h"
#include "layout/nest.h"
#include "piece/piece_keys.h"
#include "platform/path.h"
#include "product/parts.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/nearest.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

constexpr const char* k_flag = "--piece";

/// "front:allowance=12mm"
NamedSettings setting_of(const std::string& text) {
  const std::size_t sign = text.find('=');
  const std::size_t colon = text.rfind(':', sign);
  const std::string key = colon == std::string::npos
                              ? ""
                              : text.substr(colon + 1, std::min(sign, text.size()) - colon - 1);
  const bool has_value = sign != std::string::npos && sign + 1 < text.size();
  if (colon == std::string::npos || colon == 0 || key.empty() || (!has_value && key != "out")) {
    throw UsageError(std::string(k_flag) + " has \"" + text +
                     "\" but must be NAME:KEY=VALUE, as front:allowance=12mm, or NAME:out");
  }
  const std::string name = text.substr(0, colon);
  const std::string where = std::string(k_flag) + " " + name;
  check_piece_key(key, where);
  return {name, {{key, has_value ? text.substr(sign + 1) : "yes"}}, where};
}

/// Whether a patch is what a name stands for, or made of it.
bool is_made_of(const std::string& patch, const std::string& name) {
  return patch == name || patch == name + k_mirrored_piece || patch.starts_with(name + "-");
}

/// The patches that a name means: the one of that name, with its mirror image, else all that are
/// made of it.
std::vector<std::size_t> patches_called(const std::string& name,
                                        std::span<const ProductPatch> patches) {
  const bool is_one = std::any_of(patches.begin(), patches.end(),
                                  [&](const ProductPatch& patch) { return patch.name == name; });
  std::vector<std::size_t> numbers;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const std::string& own = patches[p].name;
    if (is_one ? own == name || own == name + k_mirrored_piece : is_made_of(own, name))
      numbers.push_back(p);
  }
  return numbers;
}

[[noreturn]] void refuse_name(const NamedSettings& asked, std::span<const ProductPatch> patches) {
  std::vector<std::string> names;
  for (const ProductPatch& patch : patches)
    names.push_back(patch.name);
  throw Error(ErrorCode::unknown_name, asked.from + ": no piece is called \"" + asked.piece + "\"" +
                                           nearest_hint(asked.piece, names) + " (there are " +
                                           list_of_some(names) + ")");
}

/// All settings of a patch, of each key the last one, and where that was asked for.
struct OwnSettings {
  std::map<std::string, std::string> values;
  std::map<std::string, std::string> places;

  void add(const NamedSettings& asked) {
    for (const PieceSetting& setting : asked.settings) {
      if (setting.key == "out") continue;
      values[setting.key] = setting.value;
      places[setting.key] = asked.from;
    }
  }
  /// Where the first of them was asked for.
  std::string place() const { return places.empty() ? "" : places.begin()->second; }
  const std::string* find(const std::string& key) const {
    const auto found = values.find(key);
    return found == values.end() ? nullptr : &found->second;
  }
};

int edge_number(const std::string& text, const std::string& key) {
  if (text.empty() || text.size() > 6 || text.find_first_not_of("0123456789") != std::string::npos)
    throw UsageError(key + " must have the number of an edge behind the point, as edge.2=hem");
  return std::stoi(text);
}

/// The edge that has the name or the number; of a number it may be new.
PatternEdge& edge_called(const std::string& edge, const std::string& key,
                         std::vector<PatternEdge>& edges) {
  for (PatternEdge& known : edges) {
    if (known.name == edge) return known;
  }
  if (edge.find_first_not_of("0123456789") != std::string::npos) {
    std::vector<std::string> names;
    names.reserve(edges.size());
    for (const PatternEdge& known : edges)
      names.push_back(known.name);
    throw Error(ErrorCode::unknown_name, "no edge is called \"" + edge + "\"" +
                                             nearest_hint(edge, names) +
                                             "; give it a name, as edge.2=" + edge);
  }
  const int number = edge_number(edge, key);
  for (PatternEdge& known : edges) {
    if (known.number == number) return known;
  }
  return edges.emplace_back(PatternEdge{number});
}

/// What is asked for edges by number or by name.
std::vector<PatternEdge> edges_of(const OwnSettings& own, const Arguments& arguments) {
  std::vector<PatternEdge> edges;
  std::vector<std::string> names;
  for (const auto& [key, value] : own.values) {
    if (!key.starts_with(k_edge)) continue;
    if (value.find_first_of(",\"") != std::string::npos)
      throw UsageError(key + " must be a name without commas and quotation marks");
    if (std::find(names.begin(), names.end(), value) != names.end())
      throw UsageError("two edges are called \"" + value + "\": give each a name of its own");
    edges.push_back({edge_number(key.substr(k_edge.size()), key), value});
    names.push_back(value);
  }
  for (const auto& [key, value] : own.values) {
    const bool is_hem = key.starts_with(k_hem_of);
    if (!is_hem && !key.starts_with(k_allowance_of)) continue;
    const std::string edge = key.substr(is_hem ? k_hem_of.size() : k_allowance_of.size());
    PatternEdge& found = edge_called(edge, key, edges);
    if (found.allowance) throw UsageError("edge \"" + edge + "\" has two allowances");
    found.is_hem = is_hem;
    found.allowance =
        value == "none" ? 0.0
                        : millimetres_per(unit_from(arguments)) *
                              quantity_value(key, value, Quantity::length, {.min = 0.0}, arguments);
  }
  for (const auto& [key, value] : own.values) {
    if (!key.starts_with(k_ends_of)) continue;
    const std::vector<std::string> kinds = {"mirrored", "none"};
    const bool is_mirrored = known_name("way to end allowances", value, kinds) == kinds.front();
    edge_called(key.substr(k_ends_of.size()), key, edges).mirrors_ends = is_mirrored;
  }
  const std::string* darts = own.find("darts");
  if (darts != nullptr && *darts != "none") edge_called(*darts, "darts", edges).takes_darts = true;
  return edges;
}

/// The flags as they hold for one piece.
Arguments arguments_for(const OwnSettings& own, const Arguments& all) {
  Arguments some = all;
  for (const auto& [key, value] : own.values) {
    const std::string flag = "--" + key;
    if (!is_flag_of_piece(key)) continue;
    some.rows.erase(flag);
    some.meshes.erase(flag);
    if (value == "none")
      some.flags.erase(flag);
    else
      some.flags[flag] = {value};
  }
  // What the flags of all say of an allowance is idle where this piece has none.
  for (const char* key : {"corners", "hole-allowance", "edge-allowances"}) {
    if (!some.has("--allowance") && own.find(key) == nullptr)
      some.flags.erase(std::string("--") + key);
  }
  const bool has_notches = some.has("--notches") || some.has("--seam-notches");
  if (!has_notches && own.find("notch-depth") == nullptr) some.flags.erase("--notch-depth");
  return some;
}

void refuse_contradictions(const OwnSettings& own, const PieceRequest& request, bool is_image) {
  const auto has = [&](const char* key) { return own.find(key) != nullptr; };
  const bool has_widths = std::any_of(own.values.begin(), own.values.end(), [](const auto& some) {
    return some.first.starts_with(k_allowance_of) || some.first.starts_with(k_ends_of);
  });
  if (has_widths && !request.annotations.allowance)
    throw UsageError("an edge has an allowance and the piece has none: give the piece one too");
  if (has("darts") && !request.annotations.allowance)
    throw UsageError(
        "darts are folded where the piece has an allowance: give it one, as allowance=10mm");
  if (is_image && has("mirrored"))
    throw UsageError("\"mirrored\" is true in the product file: half of the pieces are mirrored");
}

/// Those of files with what the file holds now.
std::map<std::string, std::string> hashed_settings(std::map<std::string, std::string> values) {
  for (auto& [key, value] : values) {
    if (!is_file_key(key) && lower_extension(value) != ".json") continue;
    std::ifstream file(path_of(value), std::ios::binary);
    FnvHash hash;
    hash.add(std::string{std::istreambuf_iterator<char>(file), {}});
    value += " " + hash_text(hash.value());
  }
  return values;
}

/// What is asked for one patch.
PieceRequest request_for(ProductPatch& patch, const OwnSettings& own, const PatternOptions& usual,
                         bool is_image, bool shares_quantity, const Arguments& arguments,
                         Session& session) {
  PieceRequest request{.annotations = usual, .own = hashed_settings(own.values)};
  if (own.values.empty()) return request;
  const Arguments some = arguments_for(own, arguments);
  request.annotations = annotations_from(some, true);
  request.annotations.edges = edges_of(own, some);
  refuse_contradictions(own, request, is_image);
  if (const std::string* turn = own.find("turn"))
    request.turns = value_named("turn", *turn, k_turns);
  if (const std::string* name = own.find("name")) request.name = *name;
  if (const std::string* material = own.find("material")) {
    const Material made = material_of_word(*material);
    patch.words.material = made.name;
    patch.limits = limits_of(made);
  }
  if (own.find("quantity") != nullptr) {
    int& quantity = request.annotations.label.quantity;
    if (shares_quantity && quantity % 2 != 0)
      throw UsageError("quantity must be even where half of the pieces are mirrored");
    if (shares_quantity) quantity /= 2;
    patch.words.quantity = quantity;
  }
  if (const auto fold = request.annotations.fold) patch.fold = {fold->from, fold->to};
  if (patch.failure) return request;
  const Patch surface(patch.mesh);
  request.annotations =
      with_drawn_annotations(std::move(request.annotations), some, surface, session);
  check_pattern_options(request.annotations, surface.vertex_count(), surface.border_loops(),
                        patch.name);
  if (is_image) request.annotations = on_mirrored_border(std::move(request.annotations));
  return request;
}

}  // namespace

Flag piece_flag() {
  return {k_flag,
          "NAME:KEY=VALUE",
          "a setting of one piece, which replaces the flag there, as front:allowance=12mm; keys: " +
              list_of(piece_keys()) +
              ", allowance.N, hem.N or ends.N for edge N, and edge.N for its name; the value none "
              "leaves the flag out",
          0,
          false,
          {.repeats = true}};
}

std::vector<NamedSettings> piece_settings_from(const Arguments& arguments) {
  std::vector<NamedSettings> all;
  const auto found = arguments.flags.find(k_flag);
  if (found == arguments.flags.end()) return all;
  for (const Field& field : found->second)
    all.push_back(setting_of(field_text(field)));
  return all;
}

namespace {

/// The last that --piece says of a piece being left out; nothing where it says none of it.
std::optional<bool> said_of_out(const std::string& piece, const Arguments& arguments) {
  std::optional<bool> out;
  for (const NamedSettings& asked : piece_settings_from(arguments)) {
    const PieceSetting& setting = asked.settings.front();
    if (asked.piece != piece || setting.key != "out") continue;
    const std::vector<std::string> answers = {"yes", "no"};
    out = known_name("answer of out", setting.value, answers) == "yes";
  }
  return out;
}

}  // namespace

Arguments without_pieces_out(const Arguments& arguments) {
  Arguments some = arguments;
  const std::vector<NamedSettings> all = piece_settings_from(arguments);
  std::set<std::string> out;
  for (const NamedSettings& asked : all) {
    if (said_of_out(asked.piece, arguments).value_or(false)) out.insert(asked.piece);
  }
  for (const NamedSettings& asked : all) {
    const PieceSetting& setting = asked.settings.front();
    if (setting.key == "out" || !out.contains(asked.piece)) continue;
    throw UsageError(asked.from + ": the piece is left out, so " + setting.key +
                     " has no meaning: leave one of them away");
  }
  for (const std::string& name : out)
    some.flags["--without"].emplace_back(name);
  return some;
}

bool stays_out(const NamedSettings& in_file, const Arguments& arguments) {
  const bool is_out = std::any_of(
      in_file.settings.begin(), in_file.settings.end(),
      [](const PieceSetting& some) { return some.key == "out" && some.value == "yes"; });
  return said_of_out(in_file.piece, arguments).value_or(is_out);
}

std::vector<PieceRequest> piece_requests(std::vector<ProductPatch>& patches,
                                         std::span<const NamedSettings> in_file,
                                         const PatternOptions& usual, const Arguments& arguments,
                                         Session& session) {
  std::vector<NamedSettings> all(in_file.begin(), in_file.end());
  for (NamedSettings& asked : piece_settings_from(arguments)) {
    const bool is_out = asked.settings.front().key == "out";
    if (!is_out && patches_called(asked.piece, patches).empty()) refuse_name(asked, patches);
    if (asked.settings.front().key == "turn" && !arguments.has("--sheet"))
      throw UsageError(asked.from + ": turn goes with --sheet only");
    if (!is_out) all.push_back(std::move(asked));
  }
  std::vector<OwnSettings> own(patches.size());
  std::vector<bool> shares(patches.size(), false);
  for (const NamedSettings& asked : all) {
    const std::vector<std::size_t> numbers = patches_called(asked.piece, patches);
    const bool has_image = std::any_of(numbers.begin(), numbers.end(), [&](std::size_t p) {
      return patches[p].name.ends_with(k_mirrored_piece);
    });
    const bool is_image_alone = asked.piece.ends_with(k_mirrored_piece);
    for (const std::size_t p : numbers) {
      own[p].add(asked);
      if (asked.settings.front().key == "quantity") shares[p] = has_image && !is_image_alone;
    }
  }
  std::vector<PieceRequest> requests;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const bool is_image = patches[p].name.ends_with(k_mirrored_piece);
    requests.push_back(asked_in(own[p].place(), [&] {
      return request_for(patches[p], own[p], usual, is_image, shares[p], arguments, session);
    }));
  }
  return requests;
}

}  // namespace planish::cli
