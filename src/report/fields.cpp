#include <utility>

#include <planish/measure/fairness.h>
#include <planish/measure/flattenability.h>
#include <planish/report/json_report.h>

#include "unfold/strain/vertex_strain.h"

namespace planish {

namespace {

MeshField inner_of(const Patch& patch) {
  MeshField field{"inner", {}};
  field.values.reserve(patch.vertex_count());
  for (Index v = 0; v < patch.vertex_count(); ++v)
    field.values.push_back(patch.is_inner(v) ? 1.0 : 0.0);
  return field;
}

/// The normals of all vertices, also of the border, triangles weighing as their areas; zero where
/// they cancel. Of a surface times its unit scale, so that no area overflows.
std::vector<Vec3> vertex_normals(const Patch& patch) {
  const double scale = patch.unit_scale();
  std::vector<Vec3> normals(patch.vertex_count());
  for (const Triangle& t : patch.triangles()) {
    const Vec3 a = scale * patch.positions()[t[0]];
    const Vec3 normal =
        cross(scale * patch.positions()[t[1]] - a, scale * patch.positions()[t[2]] - a);
    for (const Index v : t)
      normals[v] += normal;
  }
  for (Vec3& normal : normals) {
    const double length = norm(normal);
    normal = length > 0.0 ? (1.0 / length) * normal : Vec3{};
  }
  return normals;
}

/// How far vertices went: along the normals of the input, and in all.
std::pair<MeshField, MeshField> moves_of(const Patch& input, const Patch& processed) {
  const double scale = input.unit_scale();
  const std::vector<Vec3> normals = vertex_normals(input);
  MeshField offset{"offset", {}}, move{"move", {}};
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const Vec3 moved = scale * processed.positions()[v] - scale * input.positions()[v];
    offset.values.push_back(dot(moved, normals[v]) / scale);
    move.values.push_back(norm(moved) / scale);
  }
  return {std::move(offset), std::move(move)};
}

void append(std::vector<MeshField>& fields, std::vector<MeshField> more,
            const std::string& before) {
  for (MeshField& field : more) {
    field.name = before + field.name;
    fields.push_back(std::move(field));
  }
}

}  // namespace

MeshFields fields_of(const Patch& patch, std::span<const Vec2> pattern) {
  MeshFields fields;
  fields.vertices = {inner_of(patch),
                     {"defect", angle_defects(patch)},
                     {"mean_curvature", vertex_mean_curvatures(patch)}};
  if (pattern.empty()) return fields;
  fields.vertices.push_back({"edge_strain", largest_edge_strains(patch, pattern)});
  MeshField largest{"strain_max", {}}, smallest{"strain_min", {}};
  for (const PrincipalStretch& stretch : principal_stretches(patch.mesh(), pattern)) {
    largest.values.push_back(stretch.max - 1.0);
    smallest.values.push_back(stretch.min - 1.0);
  }
  fields.triangles = {std::move(largest), std::move(smallest)};
  return fields;
}

MeshFields fields_of(const FlattenReport& report) {
  MeshFields fields = fields_of(report.processed, report.unfold.pattern.positions);
  MeshFields input = fields_of(report.input, report.unfold_before.pattern.positions);
  input.vertices.erase(input.vertices.begin());  // the same vertices are inner
  append(fields.vertices, std::move(input.vertices), "input_");
  append(fields.triangles, std::move(input.triangles), "input_");
  auto [offset, move] = moves_of(report.input, report.processed);
  fields.vertices.push_back(std::move(offset));
  fields.vertices.push_back(std::move(move));
  return fields;
}

}  // namespace planish
