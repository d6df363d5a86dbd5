// Lines on any patch: made single, joined, made edges, and cut open.

#include <algorithm>
#include <string>
#include <vector>

#include <planish/mesh/carry.h>
#include <planish/mesh/imprint.h>
#include <planish/mesh/repair.h>
#include <planish/mesh/surface_line.h>

#include "fuzz/bytes_to_patch.h"
#include "fuzz/check.h"
#include "lines/line_checks.h"

using namespace planish;

namespace {

/// Shares that may be none.
SurfacePoint point_from(fuzz::Bytes& bytes, const TriMesh& mesh) {
  SurfacePoint point{mesh.triangles[bytes.whole(0, mesh.triangles.size() - 1)], {1.0, 0.0, 0.0}};
  const std::size_t kind = bytes.whole(0, 5);
  if (kind == 0) {
    for (double& share : point.shares)
      share = bytes.any_double();
  } else if (kind > 1) {
    const double a = 0.5 + 0.5 * bytes.fraction(), b = (1.0 - a) * (0.5 + 0.5 * bytes.fraction());
    point.shares = kind == 2 ? std::array{a, 1.0 - a, 0.0} : std::array{a, b, 1.0 - a - b};
  }
  return point;
}

std::vector<SurfaceLine> lines_from(fuzz::Bytes& bytes, const Patch& patch) {
  const TriMesh& mesh = patch.mesh();
  std::vector<SurfaceLine> lines;
  for (std::size_t count = bytes.whole(0, 6); count > 0; --count) {
    const std::size_t points = bytes.whole(0, 6);
    SurfaceLine line;
    for (std::size_t k = 0; k < points; ++k)
      line.push_back(point_from(bytes, mesh));
    if (bytes.whole(0, 3) == 0) {  // most likely refused
      lines.push_back(std::move(line));
      continue;
    }
    DrawnLine drawn;
    for (const SurfacePoint& point : line)
      drawn.points.push_back(position_of(point, mesh.positions));
    if (drawn.points.size() > 2 && bytes.flag()) drawn.points.push_back(drawn.points.front());
    if (drawn.points.size() < 2) continue;
    fuzz::allow_refusal([&] {
      for (SurfaceLine& traced : trace_lines(patch, {{drawn}, {}}).lines)
        lines.push_back(std::move(traced));
    });
  }
  return lines;
}

/// Some have their long side at the border.
bool has_flat_triangles(const Patch& patch) {
  const auto& problems = patch.inspection().problems;
  return std::any_of(problems.begin(), problems.end(),
                     [](const Problem& problem) { return problem.code == ErrorCode::zero_area; });
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const bool is_tidied = bytes.flag();
  const auto given = fuzz::patch_from(bytes, Purpose::measure);
  if (!given) return 0;
  // Two edges of a cap have places in common, where a line gets two vertices.
  const TriMesh mesh = flip_caps(*given, 5e-6 * bounding_box_diagonal(*given)).mesh;
  const Patch patch(mesh);
  fuzz::allow_refusal([&] {
    std::vector<SurfaceLine> lines = lines_from(bytes, patch);
    imprint(patch, lines);  // refuses what is no line
    if (is_tidied) {
      lines = single_lines(patch, std::move(lines), 1e-3 * bounding_box_diagonal(mesh)).lines;
      lines = join_lines(patch, std::move(lines), join_tolerance(mesh)).lines;
    }
    const ImprintedMesh imprinted = imprint(patch, lines);
    // Shares of shorter edges are rounding errors, and squares of areas vanish or overflow.
    constexpr double shortest = 1e-5, smallest = 1e-50, largest = 1e50;
    const double scale = bounding_box_diagonal(mesh);
    if (fuzz::has_edges_below(shortest, mesh) || !(scale > smallest && scale < largest)) return;
    if (has_flat_triangles(patch)) return;
    lines::Figures figures;
    const std::string wrong = lines::wrong_imprint(patch, lines, imprinted, figures);
    fuzz::check(wrong.empty(), wrong.c_str());
  });
  return 0;
}
