#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

#include <planish/draw/format_drawing.h>

#include "draw/dxf/dxf_entities.h"
#include "draw/dxf/dxf_profile.h"
#include "draw/dxf/dxf_tags.h"
#include "draw/text/stroke_text.h"

namespace planish {

namespace {

constexpr int k_millimetres = 4;       // as $INSUNITS counts units
constexpr double k_note_height = 3.0;  // of the texts that apparel CAD reads

DxfEntities entities_of(const Drawing& drawing, const DxfOptions& options) {
  const auto names = dxf_layer_names(drawing, options);
  DxfEntities entities(dialect_of(options.profile).has_pieces);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i]) entities.add(drawing.layers[i], *names[i]);
  }
  return entities;
}

void begin_section(DxfTags& tags, std::string_view name) {
  tags.add(0, "SECTION");
  tags.add(2, name);
}

void end_section(DxfTags& tags) {
  tags.add(0, "ENDSEC");
}

void add_corner(DxfTags& tags, std::string_view variable, Vec2 corner) {
  tags.add(9, variable);
  tags.add_real(10, corner.x);
  tags.add_real(20, corner.y);
}

void add_header(DxfTags& tags, const Drawing& drawing, const DxfEntities& entities,
                const DxfDialect& dialect) {
  const Vec2 sheet = {drawing.width, drawing.height};
  const auto box = entities.box().value_or(std::pair{Vec2{}, sheet});
  begin_section(tags, "HEADER");
  tags.add(9, "$ACADVER");
  tags.add(1, dialect.version);
  tags.add(9, "$INSUNITS");
  tags.add(70, k_millimetres);
  tags.add(9, "$MEASUREMENT");
  tags.add(70, 1);  // metric
  add_corner(tags, "$EXTMIN", box.first);
  add_corner(tags, "$EXTMAX", box.second);
  add_corner(tags, "$LIMMIN", {});
  add_corner(tags, "$LIMMAX", sheet);
  end_section(tags);
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

// The layers that there are, and those that are there whatever is drawn.
std::vector<DxfLayer> table_of(const DxfEntities& entities, bool numbered) {
  std::vector<DxfLayer> layers = entities.layers();
  const auto require = [&](std::string_view name) {
    const auto is_it = [&](const DxfLayer& layer) { return layer.name == name; };
    if (std::none_of(layers.begin(), layers.end(), is_it)) {
      layers.insert(layers.begin(), DxfLayer{std::string(name), 7, true});
    }
  };
  if (numbered) require(k_boundary_layer);
  require("0");
  return layers;
}

void add_tables(DxfTags& tags, const DxfEntities& entities, bool numbered) {
  begin_section(tags, "TABLES");
  begin_table(tags, "LTYPE", 2);
  add_line_type(tags, "CONTINUOUS", "Solid line", {});
  add_line_type(tags, "DASHED", "__ __ __ __", {3.0, -1.5});
  tags.add(0, "ENDTAB");

  const std::vector<DxfLayer> layers = table_of(entities, numbered);
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
  tags.add(70, 0);
  tags.add_real(40, 0.0);  // no height of its own
  tags.add_real(41, 1.0);
  tags.add_real(50, 0.0);
  tags.add(71, 0);
  tags.add_real(42, k_note_height);
  tags.add(3, "txt");
  tags.add(4, "");
  tags.add(0, "ENDTAB");
  end_section(tags);
}

struct Piece {
  std::size_t number;
  DrawingPiece facts;
  std::string block;  // different for every piece
};

std::string size_of(const DrawingPiece& piece) {
  return piece.size.empty() ? "ONE" : piece.size;
}

std::vector<Piece> pieces_of(const Drawing& drawing, const DxfEntities& entities) {
  std::vector<Piece> pieces;
  std::set<std::string> taken;
  for (const auto& [number, tags] : entities.pieces()) {
    DrawingPiece facts;
    if (number < drawing.pieces.size()) facts = drawing.pieces[number];
    if (facts.name.empty()) facts.name = drawing.title;
    std::string block = dxf_name(facts.name);
    for (int copy = 2; !taken.insert(block).second; ++copy) {
      const std::string end = "_" + std::to_string(copy);
      block = dxf_name(facts.name);
      block = block.substr(0, 31 - end.size()) + end;
    }
    pieces.push_back({number, std::move(facts), std::move(block)});
  }
  return pieces;
}

void add_note(DxfTags& tags, Vec2 at, const std::string& text) {
  tags.add(0, "TEXT");
  tags.add(8, k_boundary_layer);
  tags.add_point(10, at);
  tags.add_real(40, k_note_height);
  tags.add(1, dxf_text(text));
}

// Notes under each other, from a corner upwards.
void add_notes(DxfTags& tags, Vec2 at, const std::vector<std::string>& notes) {
  for (std::size_t i = 0; i < notes.size(); ++i) {
    const auto above = static_cast<double>(notes.size() - 1 - i);
    add_note(tags, {at.x, at.y + 2.0 * k_note_height * above}, notes[i]);
  }
}

void add_blocks(DxfTags& tags, const std::vector<Piece>& pieces, const DxfEntities& entities) {
  begin_section(tags, "BLOCKS");
  for (const Piece& piece : pieces) {
    tags.add(0, "BLOCK");
    tags.add(8, k_boundary_layer);
    tags.add(2, piece.block);
    tags.add(70, 0);
    tags.add_point(10, {});
    tags.add(3, piece.block);
    const auto box = entities.box_of(piece.number).value_or(std::pair<Vec2, Vec2>{});
    const Vec2 middle = 0.5 * (box.first + box.second);
    add_notes(tags, middle,
              {"PIECE NAME: " + piece.facts.name, "SIZE: " + size_of(piece.facts),
               "QUANTITY: " + std::to_string(piece.facts.quantity)});
    tags.append(entities.pieces().at(piece.number));
    tags.add(0, "ENDBLK");
    tags.add(8, k_boundary_layer);
  }
  end_section(tags);
}

void add_inserts(DxfTags& tags, const std::vector<Piece>& pieces) {
  for (const Piece& piece : pieces) {
    tags.add(0, "INSERT");
    tags.add(8, k_boundary_layer);
    tags.add(2, piece.block);
    tags.add_point(10, {});
  }
}

std::vector<std::string> style_notes(const Drawing& drawing, const DxfDialect& dialect) {
  return {
      std::string(dialect.norm), "STYLE NAME: " + drawing.title, "AUTHOR: PLANISH",
      "SAMPLE SIZE: " + size_of(drawing.pieces.empty() ? DrawingPiece{} : drawing.pieces.front()),
      "UNITS: METRIC"};
}

}  // namespace

std::string format_dxf(const Drawing& drawing, const DxfOptions& options) {
  const DxfDialect& dialect = dialect_of(options.profile);
  const DxfEntities entities =
      entities_of(options.stroked_text ? with_stroked_text(drawing) : drawing, options);
  DxfTags tags;
  add_header(tags, drawing, entities, dialect);
  add_tables(tags, entities, dialect.has_pieces);
  if (dialect.has_pieces) {
    const std::vector<Piece> pieces = pieces_of(drawing, entities);
    add_blocks(tags, pieces, entities);
    begin_section(tags, "ENTITIES");
    add_notes(tags, {}, style_notes(drawing, dialect));
    add_inserts(tags, pieces);
  } else {
    begin_section(tags, "ENTITIES");
    for (const auto& [piece, shapes] : entities.pieces())
      tags.append(shapes);
  }
  end_section(tags);
  tags.add(0, "EOF");
  return tags.text();
}

}  // namespace planish
