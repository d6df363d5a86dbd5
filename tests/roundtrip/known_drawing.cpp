// Writes a drawing whose every place is known in all formats, for the scripts beside this file.

#include <cmath>
#include <filesystem>
#include <iostream>
#include <numbers>

#include <planish/draw/format_drawing.h>
#include <planish/io/write_file.h>

namespace {

using planish::Color;
using planish::Drawing;
using planish::DrawingPiece;
using planish::Layer;
using planish::Path;
using planish::Stroke;
using planish::Text;
using planish::Vec2;

constexpr Color k_red = {255, 0, 0}, k_blue = {0, 0, 255};

Path square(Vec2 low, double side, Color color) {
  const Vec2 high = low + Vec2{side, side};
  return {{{low, {high.x, low.y}, high, {low.x, high.y}}}, true, Stroke{color, 0.2}};
}

Path disk(Vec2 middle, double radius, std::size_t corners) {
  Path path{{{}}, true, Stroke{k_red, 0.2}};
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
    path.lines[0].push_back(middle + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return path;
}

// A square of 100 mm at (20, 30) with a hole, a piece beside it, dashes, texts, an area without an
// outline, a hidden layer.
Drawing known_drawing() {
  Drawing drawing{"Größe – 1", 300.0, 200.0, {}, {DrawingPiece{"front"}, DrawingPiece{"back"}}};
  Path cut = square({20.0, 30.0}, 100.0, k_red);
  cut.lines.push_back(disk({70.0, 80.0}, 20.0, 250).lines[0]);
  Path other = disk({220.0, 100.0}, 60.0, 720);
  other.piece = 1;
  Path area{{{{10, 10}, {290, 10}, {290, 15}, {10, 15}}}, true, {}, Color{200, 220, 240}};
  Path seam = square({25.0, 35.0}, 90.0, k_blue);
  seam.stroke->dashed = true;
  const Path grain{{{{40.0, 40.0}, {40.0, 120.0}}}, false, Stroke{}};
  drawing.layers = {
      {"strain", {area}},
      {"cut", {cut, other}},
      {"seam", {seam}},
      {"grain", {grain}},
      {"notes, hidden", {square({1.0, 1.0}, 5.0, k_blue)}, false},
      {"label",
       {Text{{20.0, 150.0}, 6.0, "Größe 38 (100%%) \\ ± 0.5° × €"},
        Text{{150.0, 180.0}, 8.0, "middle − half", k_blue, true},
        Text{{20.0, 170.0}, 5.0, "Łódź 布"}}},
  };
  return drawing;
}

// A panel of 6.5 m, longer than a page of a PDF can be.
Drawing long_drawing() {
  const Path panel{{{{10, 10}, {6510, 10}, {6510, 110}, {10, 110}}}, true, Stroke{k_red, 2.0}};
  return {"long", 6520.0, 120.0, {{"cut", {panel}}}};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: " << argv[0] << " FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  const Drawing drawing = known_drawing();
  Drawing large = drawing;
  large.width = 7000.0;
  std::vector<planish::OutputFile> files = {
      {folder / "known.svg", planish::format_svg(drawing)},
      {folder / "known.pdf", planish::format_pdf(drawing)},
      {folder / "long.pdf", planish::format_pdf(long_drawing())},
      {folder / "known-a4.pdf", planish::format_tiled_pdf(drawing, {planish::paper_named("a4")})},
      {folder / "known-letter.pdf",
       planish::format_tiled_pdf(large, {planish::paper_named("letter")})},
      {folder / "known.plt", planish::format_plt(drawing)},
      {folder / "strokes.dxf", planish::format_dxf(drawing, {.stroked_text = true})},
      {folder / "renamed.dxf",
       planish::format_dxf(drawing, {.layer_names = {{"cut", "LASER"}, {"seam", "LASER"}}})}};
  for (const planish::DxfProfile profile : planish::k_dxf_profiles) {
    files.push_back({folder / (std::string(to_string(profile)) + ".dxf"),
                     planish::format_dxf(drawing, {.profile = profile})});
  }
  planish::write_files(files);
}
