// The reader of lines of SVG files, and carrying what it reads over a mesh.

#include <algorithm>
#include <array>
#include <cmath>

#include <planish/mesh/carry.h>

#include "fuzz/check.h"
#include "io/svg/svg_drawing.h"
#include "support/meshes.h"

using namespace planish;

namespace {

constexpr std::array<std::string_view, 2> k_layers = {"cut", "label"};

void check_traced(const TracedLines& traced, const TriMesh& mesh) {
  fuzz::check(std::isfinite(traced.outside_length) && traced.outside_length >= 0.0,
              "lengths are finite");
  const auto check_place = [&](const SurfacePoint& place) {
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      fuzz::check(place.corners[k] < mesh.positions.size(), "corners are vertices of the mesh");
      fuzz::check(place.shares[k] >= 0.0, "places lie on their triangles");
      sum += place.shares[k];
    }
    fuzz::check(std::abs(sum - 1.0) < 1e-12, "shares are of the whole");
  };
  for (const auto& line : traced.lines) {
    fuzz::check(line.size() > 1, "lines have two places");
    std::for_each(line.begin(), line.end(), check_place);
  }
  std::for_each(traced.points.begin(), traced.points.end(), check_place);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const TriMesh flat = meshes::flat_grid(5, 4), form = meshes::rough_grid(5, 4, 3);
  const std::string name = "drawn.svg";
  fuzz::allow_refusal_of(name, [&] {
    const SvgDrawing drawing = parse_svg(bytes, name, k_layers);
    DrawnLines drawn;
    for (const SvgLine& line : drawing.lines) {
      fuzz::check(!line.points.empty(), "lines have points");
      DrawnLine& some = drawn.lines.emplace_back(DrawnLine{{}, {name, line.line}});
      for (const Vec2 p : line.points) {
        fuzz::check(fuzz::is_finite(p), "points are finite");
        some.points.push_back({p.x, -p.y, 0.0});
      }
    }
    check_traced(trace_lines(Patch(flat), drawn), flat);
    check_traced(trace_lines(Patch(form), drawn), form);
  });
  return 0;
}
