#include "draw/dxf/apparel_dxf.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include <planish/core/version.h>

#include "draw/dxf/apparel_piece.h"
#include "draw/dxf/dxf_profile.h"
#include "draw/dxf/dxf_tags.h"
#include "draw/text/ascii_text.h"

namespace planish {

namespace {

constexpr double k_note_height = 3.0;  // of the texts that programs read

struct Piece {
  DrawingPiece facts;
  std::string block;  // different for every piece
  ApparelPiece entities;
};

/// A text that programs look for by what stands before the colon.
struct Note {
  std::string key, value;
};

std::string size_of(const DrawingPiece& piece) {
  return piece.size.empty() ? "ONE" : ascii_text(piece.size);
}

/// "front_38", unlike all names that are taken; a number makes it different.
std::string block_name(const DrawingPiece& piece, std::set<std::string>& taken) {
  const std::string size = "_" + dxf_name(size_of(piece));
  for (int copy = 1;; ++copy) {
    const std::string end = (copy > 1 ? "_" + std::to_string(copy) : "") + size;
    const std::size_t room = end.size() < k_longest_dxf_name ? k_longest_dxf_name - end.size() : 1;
    std::string name =
        (dxf_name(ascii_text(piece.name)).substr(0, room) + end).substr(0, k_longest_dxf_name);
    if (taken.insert(name).second) return name;
  }
}

std::vector<Piece> pieces_of(const Drawing& drawing, const DxfOptions& options) {
  // Files of such programs have the boundary first.
  std::vector<const Layer*> layers;
  for (const Layer& layer : drawing.layers)
    layers.push_back(&layer);
  std::stable_partition(layers.begin(), layers.end(), [&](const Layer* layer) {
    return dxf_layer_name(layer->name, options) == k_boundary_layer;
  });
  std::map<std::size_t, ApparelPiece> entities;
  for (const Layer* layer : layers) {
    for (const DrawingShape& shape : layer->shapes) {
      std::visit(
          [&](const auto& some) {
            entities.try_emplace(some.piece, options).first->second.add(*layer, some);
          },
          shape);
    }
  }
  std::vector<Piece> pieces;
  std::set<std::string> taken;
  for (auto& [number, some] : entities) {
    if (some.tags().is_empty()) continue;
    DrawingPiece facts;
    if (number < drawing.pieces.size()) facts = drawing.pieces[number];
    if (facts.name.empty()) facts.name = drawing.title;
    std::string block = block_name(facts, taken);
    pieces.push_back({std::move(facts), std::move(block), std::move(some)});
  }
  return pieces;
}

std::string in_capitals(std::string text) {
  for (char& c : text) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return text;
}

/// Notes under each other, the last one at the place.
void add_notes(DxfTags& tags, Vec2 at, const std::vector<Note>& notes, const DxfDialect& dialect) {
  for (std::size_t i = 0; i < notes.size(); ++i) {
    const auto above = static_cast<double>(notes.size() - 1 - i);
    const std::string key = dialect.in_capitals ? in_capitals(notes[i].key) : notes[i].key;
    tags.add_text(std::string(k_boundary_layer), {at.x, at.y + 2.0 * k_note_height * above},
                  k_note_height, key + ": " + ascii_text(notes[i].value));
  }
}

std::string quantity_text(const DrawingPiece& piece, const DxfDialect& dialect) {
  if (dialect.family == DxfFamily::astm)
    return std::to_string(piece.quantity) + "," + std::to_string(piece.mirrored);
  return std::to_string(piece.quantity + piece.mirrored);
}

std::vector<Note> notes_of(const DrawingPiece& piece, const DxfDialect& dialect) {
  std::vector<Note> notes = {{"Piece Name", piece.name}};
  if (!piece.material.empty()) notes.push_back({std::string(dialect.material), piece.material});
  notes.push_back({"Size", size_of(piece)});
  if (!piece.note.empty()) notes.push_back({"Annotation", piece.note});
  if (piece.mirrored > 0 && dialect.family != DxfFamily::astm) {
    notes.push_back({"Annotation", std::to_string(piece.quantity) + " as drawn, " +
                                       std::to_string(piece.mirrored) + " mirrored"});
  }
  notes.push_back({"Quantity", quantity_text(piece, dialect)});
  return notes;
}

std::vector<Note> style_notes(const Drawing& drawing, const std::vector<Piece>& pieces,
                              const DxfDialect& dialect) {
  const std::string version(k_version);
  const bool is_astm = dialect.family == DxfFamily::astm;
  std::vector<Note> notes = {
      {"Style Name", drawing.title}, {"Creation Date", drawing.date}, {"Creation Time", ""}};
  if (is_astm) {
    notes.push_back({"Author", "PLANISH ; PLANISH ; " + version});
  } else {
    notes.insert(notes.end(),
                 {{"Author", "PLANISH"}, {"PRODUCT", "PLANISH"}, {"VERSION", version}});
  }
  notes.push_back({"Sample Size", pieces.empty() ? "ONE" : size_of(pieces.front().facts)});
  notes.push_back({"Units", "METRIC"});
  notes.push_back({is_astm ? "Curve Tolerance" : "TOLERANCE", ".15"});
  if (is_astm) notes.push_back({"ASTM/D13Proposal 1 Version", "D 6673-04"});
  return notes;
}

/// What CLO writes; other programs leave the header empty.
void add_header(DxfTags& tags, const std::vector<Piece>& pieces, const DxfDialect& dialect) {
  tags.begin_section("HEADER");
  if (!dialect.version.empty()) {
    std::pair<Vec2, Vec2> box;
    bool is_first = true;
    for (const Piece& piece : pieces) {
      const auto own = piece.entities.box();
      if (!own) continue;
      box.first =
          is_first ? own->first
                   : Vec2{std::min(box.first.x, own->first.x), std::min(box.first.y, own->first.y)};
      box.second = is_first ? own->second
                            : Vec2{std::max(box.second.x, own->second.x),
                                   std::max(box.second.y, own->second.y)};
      is_first = false;
    }
    tags.add(9, "$ACADVER");
    tags.add(1, dialect.version);
    tags.add(9, "$INSBASE");
    tags.add_point(10, {});
    for (const auto& [name, corner] :
         {std::pair("$EXTMIN", box.first), std::pair("$EXTMAX", box.second)}) {
      tags.add(9, name);
      tags.add_real(10, corner.x);
      tags.add_real(20, corner.y);
    }
  }
  tags.end_section();
}

void add_blocks(DxfTags& tags, const std::vector<Piece>& pieces, const DxfDialect& dialect) {
  tags.begin_section("BLOCKS");
  for (const Piece& piece : pieces) {
    tags.add(0, "BLOCK");
    tags.add(8, "0");
    tags.add(2, piece.block);
    tags.add(70, 64);  // inserted somewhere
    tags.add_real(10, 0.0);
    tags.add_real(20, 0.0);
    const auto box = piece.entities.box().value_or(std::pair<Vec2, Vec2>{});
    add_notes(tags, 0.5 * (box.first + box.second), notes_of(piece.facts, dialect), dialect);
    tags.append(piece.entities.tags());
    tags.add(0, "ENDBLK");
    tags.add(8, "0");
  }
  tags.end_section();
}

}  // namespace

std::string format_apparel_dxf(const Drawing& drawing, const DxfOptions& options) {
  const DxfDialect& dialect = dialect_of(options.profile);
  const std::vector<Piece> pieces = pieces_of(drawing, options);
  DxfTags tags;
  add_header(tags, pieces, dialect);
  add_blocks(tags, pieces, dialect);
  tags.begin_section("ENTITIES");
  for (const Piece& piece : pieces) {
    tags.add(0, "INSERT");
    tags.add(8, k_boundary_layer);
    tags.add(2, piece.block);
    tags.add_real(10, 0.0);
    tags.add_real(20, 0.0);
  }
  add_notes(tags, {}, style_notes(drawing, pieces, dialect), dialect);
  tags.end_section();
  tags.add(0, "EOF");
  return tags.text();
}

}  // namespace planish
