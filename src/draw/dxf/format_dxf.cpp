#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <planish/draw/format_drawing.h>

#include "draw/cutting_order.h"
#include "draw/dxf/apparel_dxf.h"
#include "draw/dxf/dxf_entities.h"
#include "draw/dxf/dxf_profile.h"
#include "draw/dxf/dxf_r2000.h"
#include "draw/dxf/dxf_tags.h"
#include "draw/dxf/dxf_unit.h"
#include "draw/text/stroke_text.h"

namespace planish {

namespace {

DxfEntities entities_of(const Drawing& drawing, const DxfOptions& options) {
  DxfEntities entities;
  for (const Layer& layer : in_cutting_order(drawing))
    entities.add(layer, *dxf_layer_name(layer.name, options));
  return entities;
}

void add_corner(DxfTags& tags, std::string_view variable, Vec2 corner) {
  tags.add(9, variable);
  tags.add_real(10, corner.x);
  tags.add_real(20, corner.y);
}

void add_header(DxfTags& tags, const Drawing& drawing, const DxfEntities& entities) {
  const Vec2 sheet = {drawing.width, drawing.height};
  const auto box = entities.box().value_or(std::pair{Vec2{}, sheet});
  tags.begin_section("HEADER");
  tags.add(9, "$ACADVER");
  tags.add(1, "AC1009");
  tags.add(9, "$INSUNITS");
  tags.add(70, k_millimetres);
  tags.add(9, "$MEASUREMENT");
  tags.add(70, 1);  // metric
  add_corner(tags, "$EXTMIN", box.first);
  add_corner(tags, "$EXTMAX", box.second);
  add_corner(tags, "$LIMMIN", {});
  add_corner(tags, "$LIMMAX", sheet);
  tags.end_section();
}

void begin_table(DxfTags& tags, std::string_view name, std::size_t entries) {
  tags.add(0, "TABLE");
  tags.add(2, name);
  tags.add(70, static_cast<int>(entries));
}

// @param dashes of the line: drawn lengths are positive, gaps negative; millimetres
void add_line_type(DxfTags& tags, std::string_view name, std::string_view picture,
                   const std::vector<double>& dashes) {
  double length = 0.0;
  for (const double dash : dashes)
    length += dash < 0.0 ? -dash : dash;
  tags.add(0, "LTYPE");
  tags.add(2, name);
  tags.add(70, 0);
  tags.add(3, picture);
  tags.add(72, 65);  // aligned at the ends, the only kind there is
  tags.add(73, static_cast<int>(dashes.size()));
  tags.add_real(40, length);
  for (const double dash : dashes)
    tags.add_real(49, dash);
}

void add_tables(DxfTags& tags, const DxfEntities& entities) {
  tags.begin_section("TABLES");
  begin_table(tags, "LTYPE", 2);
  add_line_type(tags, "CONTINUOUS", "Solid line", {});
  add_line_type(tags, "DASHED", "__ __ __ __", {3.0, -1.5});
  tags.add(0, "ENDTAB");

  const std::vector<DxfLayer> layers = entities.layers().with_layer_0();
  begin_table(tags, "LAYER", layers.size());
  for (const DxfLayer& layer : layers) {
    tags.add(0, "LAYER");
    tags.add(2, layer.name);
    tags.add(70, 0);
    tags.add(62, layer.visible ? layer.color : -layer.color);
    tags.add(6, "CONTINUOUS");
  }
  tags.add(0, "ENDTAB");

  begin_table(tags, "STYLE", 1);
  tags.add(0, "STYLE");
  tags.add(2, "STANDARD");
  tags.add_text_style();
  tags.add(0, "ENDTAB");
  tags.end_section();
}

std::string format_r12(const Drawing& drawing, const DxfOptions& options) {
  const DxfEntities entities =
      entities_of(options.stroked_text ? with_stroked_text(drawing) : drawing, options);
  DxfTags tags;
  add_header(tags, drawing, entities);
  add_tables(tags, entities);
  tags.begin_section("ENTITIES");
  tags.append(entities.tags());
  tags.end_section();
  tags.add(0, "EOF");
  return tags.text();
}

}  // namespace

namespace {

std::string format_in_millimetres(const Drawing& drawing, const DxfOptions& options) {
  if (dialect_of(options.profile).family != DxfFamily::none)
    return format_apparel_dxf(drawing, options);
  return options.version == DxfVersion::r12 ? format_r12(drawing, options)
                                            : format_dxf_r2000(drawing, options);
}

}  // namespace

std::string format_dxf(const Drawing& drawing, const DxfOptions& options) {
  check_layer_names(drawing, options);
  return dxf_in_unit(format_in_millimetres(drawing, options), options.unit);
}

}  // namespace planish
