#include "flags/scale_flag.h"

#include <cmath>
#include <utility>

#include "flags/quantities.h"
#include "flags/units.h"
#include "shell/failures.h"

namespace planish::cli {

namespace {

constexpr Range k_scales = {1e-9, 1e9};

}  // namespace

Flag scale_flag() {
  return {"--scale",
          "FACTOR",
          "multiply all coordinates by this when the mesh is read; for a unit of 0.5 m: --unit m "
          "--scale 0.5 (default 1)",
          0,
          false,
          {.type = ValueType::number, .range = k_scales, .standard = "1"}};
}

double scale_from(const Arguments& arguments) {
  if (!arguments.has("--scale")) return 1.0;
  return quantity_value("--scale", arguments.value("--scale"), Quantity::number, k_scales,
                        arguments);
}

TriMesh scaled(TriMesh mesh, double scale, const std::string& path) {
  if (scale == 1.0) return mesh;
  for (Vec3& p : mesh.positions) {
    p = scale * p;
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
    throw Error(ErrorCode::non_finite_coordinate,
                "scaled to --unit or by --scale, a coordinate is too large for a double",
                {.path = path});
  }
  return mesh;
}

TriMesh as_in_file(TriMesh mesh, const Arguments& arguments) {
  const double scale = scale_from(arguments);
  if (scale == 1.0) return mesh;
  for (Vec3& p : mesh.positions)
    p = {p.x / scale, p.y / scale, p.z / scale};
  return mesh;
}

Patch as_in_file(const Patch& patch, const Arguments& arguments) {
  if (scale_from(arguments) == 1.0) return patch;
  return patch.with_positions(as_in_file(patch.mesh(), arguments).positions);
}

}  // namespace planish::cli
