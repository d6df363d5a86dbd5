#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <planish/mesh/tri_mesh.h>

#include <planish_json/json.h>

#include "report/pictures/view.h"

namespace planish {

// What the data of all pages are made of.

Json view_json(const View& view);
/// Numbers of 16 bits where they suffice for the vertices.
Json triangles_json(std::span<const Triangle> triangles, std::size_t vertices);
/// The positions of all vertices in each state, on one grid.
/// @param shown as PageInput has it
Json states_json(std::span<const std::string> names, std::size_t shown,
                 std::span<const std::vector<Vec3>> positions);
/// The element that the script of a page looks for. It is never run.
std::string data_element(const Json& json);

}  // namespace planish
