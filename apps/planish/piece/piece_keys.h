#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace planish::cli {

/// Before the number or the name of an edge, as "allowance.2", "hem.2" and "ends.2"; "edge.2" gives
/// it its name.
inline constexpr std::string_view k_allowance_of = "allowance.", k_hem_of = "hem.",
                                  k_ends_of = "ends.", k_edge = "edge.";

/// Keys that settings of a piece have: names of flags without dashes, and "name", "material",
/// "turn", "darts", "out".
const std::vector<std::string>& piece_keys();

/// Whether the key is a flag of annotation_flags() that a piece may have for itself.
bool is_flag_of_piece(std::string_view key);

/// Whether the value is the path of a file.
bool is_file_key(std::string_view key);

/// Whether the key is one of an edge.
bool is_edge_key(std::string_view key);

/// @throws UsageError for a key that is none, naming the nearest one
void check_piece_key(const std::string& key, const std::string& where);

}  // namespace planish::cli
