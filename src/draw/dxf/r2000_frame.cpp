#include "draw/dxf/r2000_frame.h"

#include <array>

namespace planish {

std::string DxfHandles::next() {
  std::string text;
  for (std::size_t rest = ++last_; rest > 0; rest >>= 4U)
    text.insert(text.begin(), "0123456789ABCDEF"[rest & 15U]);
  return text;
}

std::string R2000Frame::begin_table(DxfTags& tags, std::string_view name, std::size_t entries) {
  tags.add(0, "TABLE");
  tags.add(2, name);
  std::string handle = handles_.next();
  tags.add(5, handle);
  tags.add(330, "0");
  tags.add(100, "AcDbSymbolTable");
  tags.add(70, static_cast<int>(entries));
  return handle;
}

void R2000Frame::begin_entry(DxfTags& tags, std::string_view kind, const std::string& table,
                             std::string_view subclass, std::string_view name,
                             const std::optional<std::string>& handle) {
  tags.add(0, kind);
  tags.add(5, handle ? *handle : handles_.next());
  tags.add(330, table);
  tags.add(100, "AcDbSymbolTableRecord");
  tags.add(100, subclass);
  tags.add(2, name);
}

void R2000Frame::add_line_types(DxfTags& tags) {
  const std::string table = begin_table(tags, "LTYPE", 4);
  struct Dashes {
    std::string_view name, picture;
    double drawn, gap;
  };
  constexpr std::array<Dashes, 4> kinds = {{{"ByBlock", "", 0.0, 0.0},
                                            {"ByLayer", "", 0.0, 0.0},
                                            {"Continuous", "Solid line", 0.0, 0.0},
                                            {"DASHED", "__ __ __ __", 3.0, 1.5}}};
  for (const Dashes& dashes : kinds) {
    begin_entry(tags, "LTYPE", table, "AcDbLinetypeTableRecord", dashes.name);
    tags.add(70, 0);
    tags.add(3, dashes.picture);
    tags.add(72, 65);
    tags.add(73, dashes.drawn > 0.0 ? 2 : 0);
    tags.add_real(40, dashes.drawn + dashes.gap);
    if (!(dashes.drawn > 0.0)) continue;
    tags.add_real(49, dashes.drawn);
    tags.add(74, 0);
    tags.add_real(49, -dashes.gap);
    tags.add(74, 0);
  }
  tags.add(0, "ENDTAB");
}

void R2000Frame::add_layers(DxfTags& tags, const std::vector<DxfLayer>& layers) {
  const std::string table = begin_table(tags, "LAYER", layers.size());
  for (const DxfLayer& layer : layers) {
    begin_entry(tags, "LAYER", table, "AcDbLayerTableRecord", layer.name);
    tags.add(70, 0);
    tags.add(62, layer.visible ? layer.color : -layer.color);
    tags.add(6, "Continuous");
  }
  tags.add(0, "ENDTAB");
}

void R2000Frame::add_styles(DxfTags& tags) {
  std::string table = begin_table(tags, "STYLE", 1);
  begin_entry(tags, "STYLE", table, "AcDbTextStyleTableRecord", "Standard");
  tags.add_text_style();
  tags.add(0, "ENDTAB");
  for (const char* empty : {"VIEW", "UCS"}) {
    begin_table(tags, empty, 0);
    tags.add(0, "ENDTAB");
  }
  table = begin_table(tags, "APPID", 1);
  begin_entry(tags, "APPID", table, "AcDbRegAppTableRecord", "ACAD");
  tags.add(70, 0);
  tags.add(0, "ENDTAB");
  begin_table(tags, "DIMSTYLE", 0);
  tags.add(100, "AcDbDimStyleTable");
  tags.add(0, "ENDTAB");
}

void R2000Frame::begin_block_entity(DxfTags& tags, std::string_view kind, const std::string& record,
                                    std::string_view subclass) {
  tags.add(0, kind);
  tags.add(5, handles_.next());
  tags.add(330, record);
  tags.add(100, "AcDbEntity");
  tags.add(8, "0");
  tags.add(100, subclass);
}

void R2000Frame::add_block(DxfTags& tags, std::string_view name, const std::string& record) {
  begin_block_entity(tags, "BLOCK", record, "AcDbBlockBegin");
  tags.add(2, name);
  tags.add(70, 0);
  tags.add_point(10, {});
  tags.add(3, name);
  tags.add(1, "");
  begin_block_entity(tags, "ENDBLK", record, "AcDbBlockEnd");
}

DxfTags R2000Frame::tables_and_blocks(const std::vector<DxfLayer>& layers) {
  DxfTags tags;
  tags.begin_section("TABLES");
  begin_table(tags, "VPORT", 0);
  tags.add(0, "ENDTAB");
  add_line_types(tags);
  add_layers(tags, layers);
  add_styles(tags);
  const std::string table = begin_table(tags, "BLOCK_RECORD", 2);
  begin_entry(tags, "BLOCK_RECORD", table, "AcDbBlockTableRecord", "*Model_Space", model_space_);
  begin_entry(tags, "BLOCK_RECORD", table, "AcDbBlockTableRecord", "*Paper_Space", paper_space_);
  tags.add(0, "ENDTAB");
  tags.end_section();
  tags.begin_section("BLOCKS");
  add_block(tags, "*Model_Space", model_space_);
  add_block(tags, "*Paper_Space", paper_space_);
  tags.end_section();
  return tags;
}

DxfTags R2000Frame::objects_section() {
  DxfTags tags;
  tags.begin_section("OBJECTS");
  const std::string root = handles_.next(), groups = handles_.next();
  const auto add_dictionary = [&](const std::string& handle, const std::string& owner) {
    tags.add(0, "DICTIONARY");
    tags.add(5, handle);
    tags.add(330, owner);
    tags.add(100, "AcDbDictionary");
    tags.add(281, 1);
  };
  add_dictionary(root, "0");
  tags.add(3, "ACAD_GROUP");
  tags.add(350, groups);
  add_dictionary(groups, root);
  tags.end_section();
  return tags;
}

}  // namespace planish
