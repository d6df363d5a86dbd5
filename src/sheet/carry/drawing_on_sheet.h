#pragma once

#include <span>
#include <string>
#include <vector>

#include <planish/core/unit.h>
#include <planish/draw/drawing.h>
#include <planish/mesh/carry.h>

namespace planish {

/// Where the origin of a flat mesh lies on a sheet, found by the pattern's outline there: a place p
/// of the mesh is at the origin plus the millimetres of p. Known to about a thousandth of a
/// millimetre, also where curves were fitted, as these begin and end at vertices of the border.
/// @param outline lines of the border on the sheet, millimetres, y upwards
/// @param cut where the outline leaves out stretches without an allowance: the cut lines, which
///   are there; else empty
/// @param name of the sheet's file, for errors
/// @throws Error malformed_file where the outline is not that of the mesh: in another unit, scaled,
///   changed or of another pattern
Vec2 origin_on_sheet(std::vector<std::vector<Vec2>> outline, std::span<const std::vector<Vec2>> cut,
                     const Patch& flat, Unit unit, const std::string& name);

/// A sheet in millimetres with lines and points of a flat mesh, as layer "carried": points as
/// crosses. Layer "cut" has the border of the mesh, and lies where pattern_sheet() lays a pattern
/// without an allowance.
/// @throws Error malformed_file, with the title for a name, where the mesh has no border
Drawing carried_sheet(const Patch& flat, const DrawnLines& drawn, Unit unit,
                      const std::string& title);

}  // namespace planish
