#include <utility>

#include <planish/measure/fairness.h>
#include <planish/measure/flattenability.h>
#include <planish/report/json_report.h>

#include "measure/normals.h"
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

/// How far vertices went: along the normals of the input, and in all.
std::pair<MeshField, MeshField> moves_of(const Patch& input, const Patch& processed) {
  const double scale = input.unit_scale();
  MeshField offset{"offset", normal_offsets(input, processed.positions())}, move{"move", {}};
  for (std::size_t v = 0; v < offset.values.size(); ++v) {
    const Vec3 moved = scale * processed.positions()[v] - scale * input.positions()[v];
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
  MeshFields input = fields_of(report.input, report.design_least_stretch.pattern.positions);
  input.vertices.erase(input.vertices.begin());  // the same vertices are inner
  append(fields.vertices, std::move(input.vertices), "input_");
  append(fields.triangles, std::move(input.triangles), "input_");
  auto [offset, move] = moves_of(report.input, report.processed);
  fields.vertices.push_back(std::move(offset));
  fields.vertices.push_back(std::move(move));
  return fields;
}

}  // namespace planish
