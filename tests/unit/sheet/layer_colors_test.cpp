#include <array>
#include <map>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include <planish/draw/format_drawing.h>
#include <planish/sheet/nest_sheet.h>
#include <planish/sheet/pattern_sheet.h>
#include <planish/sheet/product_sheet.h>

#include <gtest/gtest.h>

#include "oracle/drawn_lines.h"
#include "support/sample_report.h"

namespace planish {
namespace {

PatternOptions all_that_a_piece_can_carry() {
  return {.allowance = Allowance{.width = 8.0},
          .fold = FoldLine{0, 4},
          .notches = {Notch::at_fraction(0.4)},
          .grain = 90.0,
          .marks = {{.vertex = 7}},
          .inner_lines = {{6, 7, 12}},
          .seam_numbers = {{9, 1}},
          .label = {.name = "panel", .quantity = 2},
          .edge_lengths = true};
}

TriMesh cells() {
  return meshes::flat_grid(4, 4);
}

UnfoldReport laid_flat() {
  UnfoldReport unfold = samples::plane_below(cells(), 200.0, 200.0);
  for (Vec2& p : unfold.pattern.positions)
    p = 50.0 * p;
  return unfold;
}

Drawing full_pattern(const UnfoldReport& unfold) {
  return pattern_sheet(Patch(cells()), unfold, "panel", all_that_a_piece_can_carry());
}

Drawing full_layout() {
  const NestJob job{
      {{"panel", cells(), laid_flat().pattern.positions, all_that_a_piece_can_carry()}},
      Unit::mm,
      {.width = 700.0}};
  return nest_sheet(job, nest(nest_pieces(job), job.sheets), 0, "coat");
}

Drawing full_product() {
  std::vector<ProductPiece> pieces(2);
  for (std::size_t p = 0; p < 2; ++p) {
    pieces[p] = {std::string(1, static_cast<char>('a' + p)), cells(),
                 laid_flat().pattern.positions};
    for (Vec3& q : pieces[p].mesh.positions)
      q.x += 4.0 * static_cast<double>(p);
  }
  std::vector<Seam> seams = find_seams(std::vector{pieces[0].mesh, pieces[1].mesh});
  EXPECT_EQ(seams.size(), 1U);
  seams.resize(6, seams.front());  // one of each colour
  return product_sheet(pieces, seams, Unit::mm, "coat");
}

/// Of lines and words.
std::set<std::array<int, 3>> colors_of(const Layer& layer) {
  std::set<std::array<int, 3>> colors;
  const auto add = [&](Color color) { colors.insert({color.r, color.g, color.b}); };
  for (const DrawingShape& shape : layer.shapes) {
    if (const auto* text = std::get_if<Text>(&shape)) {
      add(text->color);
    } else if (const auto& stroke = std::get<Path>(shape).stroke) {
      add(stroke->color);
    }
  }
  return colors;
}

/// Layer -> AutoCAD's colours of all entities on it.
std::map<std::string, std::set<std::string>> dxf_colors(const std::string& dxf) {
  std::map<std::string, std::set<std::string>> colors;
  std::map<std::string, std::string> of_layer;
  std::string entity, name, own;
  const auto end_entity = [&] {
    if (entity == "LAYER") {
      of_layer[name] = own;
    } else if (entity == "POLYLINE" || entity == "TEXT") {
      colors[name].insert(own.empty() ? of_layer.at(name) : own);
    }
  };
  for (const auto& [code, value] : oracle::tags_of_dxf(dxf)) {
    if (code == 0) {
      end_entity();
      entity = value;
      name.clear();
      own.clear();
    }
    if (code == (entity == "LAYER" ? 2 : 8)) name = value;
    if (code == 62) own = value;
  }
  return colors;
}

template <class Colors>
void expect_apart(const std::map<std::string, std::set<Colors>>& colors, std::size_t layers) {
  EXPECT_EQ(colors.size(), layers);
  std::map<Colors, std::string> owner;
  for (const auto& [layer, own] : colors) {
    for (const Colors& color : own) {
      const auto [found, is_new] = owner.try_emplace(color, layer);
      EXPECT_TRUE(is_new) << layer << " has a colour of " << found->second;
    }
  }
}

void expect_layers_apart(const Drawing& drawing, std::size_t layers) {
  std::map<std::string, std::set<std::array<int, 3>>> colors;
  for (const Layer& layer : drawing.layers) {
    if (auto own = colors_of(layer); !own.empty()) colors[layer.name] = std::move(own);
  }
  expect_apart(colors, layers);
  expect_apart(dxf_colors(format_dxf(drawing)), layers);
}

TEST(LayerColors, TellTheLayersOfAPatternApart) {
  expect_layers_apart(full_pattern(laid_flat()), 10);
}

TEST(LayerColors, TellThemApartWhereThePatternIsNotToBeCut) {
  UnfoldReport unfold = laid_flat();
  unfold.pattern.flipped_triangles = 1;
  unfold.limits = {{Criterion::strain, 0.01, 0.02}};
  expect_layers_apart(full_pattern(unfold), 10);
  unfold.pattern.positions[2] = {110.0, 230.0};
  unfold.pattern.overlaps = true;
  PatternOptions options = all_that_a_piece_can_carry();
  options.notches.clear();
  options.fold.reset();
  expect_layers_apart(pattern_sheet(Patch(cells()), unfold, "panel", options), 8);
}

TEST(LayerColors, TellTheLayersOfALayoutApart) {
  expect_layers_apart(full_layout(), 9);
}

TEST(LayerColors, TellTheLayersOfAProductApart) {
  expect_layers_apart(full_product(), 3);
}

}  // namespace
}  // namespace planish
