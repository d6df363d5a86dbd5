#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/split.h"

namespace planish::cli {

/// Where each piece of a product lies, by the axes of its file: "xmin", "xmax", ... "zmax". Which
/// way is up or front no file says. Empty where a piece does not face that way and lie on that
/// side, and where two would be called the same (docs/panels.md).
std::vector<std::string> places_of_pieces(std::span<const NamedPatch> pieces);

/// The connected parts of what was cut: of several each is "NAME-" with its place, else with its
/// number, from 1.
std::vector<NamedPatch> pieces_by_place(const TriMesh& cut, const std::string& name);

/// Whether it is one of those six.
bool is_place(std::string_view word);

}  // namespace planish::cli
