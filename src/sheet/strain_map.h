#pragma once

#include <functional>
#include <span>
#include <vector>

#include <planish/draw/drawing.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// Bands on each side of the middle one: 21 in all, of equal width, from -limit to limit; what lies
/// beyond belongs to the last.
inline constexpr int k_bands_a_side = 10;

/// The band, -10 to 10, of a strain. NaN counts as none.
int strain_band(double strain, double limit);

/// The colour of a band: the diverging map's where the band lies.
Color band_color(int band);

/// Triangles of a flat mesh coloured by band, with the joint outline of neighbours of one colour in
/// place of the triangles, so that the size follows the form of the map and not the mesh. First
/// the whole pattern in the colour of band 0; then, over it, for band 1 all that is in it or in one
/// above, for band 2 likewise, and the same for the bands below 0. Each path so lies wholly on its
/// neighbour in colour and no seam can show at any zoom.
/// @param corners the pattern in millimetres, one per vertex
/// @param strains one per triangle
std::vector<DrawingShape> strain_map(const TriMesh& mesh, std::span<const Vec2> corners,
                                     std::span<const double> strains,
                                     const std::function<int(double)>& band_of,
                                     const std::function<Color(int)>& color);

}  // namespace planish
