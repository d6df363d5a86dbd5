// Every writer of pattern files with any drawing: files are well-formed, and lines that are read
// back are as long as they were.

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <planish/draw/format_drawing.h>

#include "draw/text/stroke_text.h"
#include "fuzz/bytes.h"
#include "fuzz/check.h"
#include "oracle/drawn_lines.h"

using namespace planish;

namespace {

/// On a sheet of 2 m, or anywhere at all.
Vec2 point_from(fuzz::Bytes& bytes, bool anywhere) {
  if (anywhere) return {bytes.any_double(), bytes.any_double()};
  return {1000.0 + 1000.0 * bytes.fraction(), 1000.0 + 1000.0 * bytes.fraction()};
}

std::optional<Stroke> stroke_from(fuzz::Bytes& bytes) {
  if (bytes.whole(0, 4) == 0) return std::nullopt;
  return Stroke{{bytes.byte(), bytes.byte(), 0}, 0.25, bytes.flag()};
}

DrawingShape shape_from(fuzz::Bytes& bytes, bool anywhere) {
  const std::size_t piece = bytes.whole(0, 3);
  if (bytes.whole(0, 3) == 0) {
    Text text{point_from(bytes, anywhere), 0.1 * (1.0 + bytes.byte()), {}};
    text.text = bytes.text(bytes.whole(0, 20));
    text.centred = bytes.flag();
    text.piece = piece;
    return text;
  }
  Path path{{}, bytes.flag(), stroke_from(bytes), {}, piece};
  if (bytes.flag()) path.fill = Color{1, 2, bytes.byte()};
  for (std::size_t lines = bytes.whole(0, 3); lines > 0; --lines) {
    path.lines.emplace_back();
    for (std::size_t points = bytes.whole(0, 12); points > 0; --points)
      path.lines.back().push_back(point_from(bytes, anywhere));
  }
  return path;
}

Drawing drawing_from(fuzz::Bytes& bytes, bool anywhere) {
  constexpr std::array<const char*, 4> known = {"cut", "notch", "internal", "annotation"};
  Drawing drawing{std::string(bytes.text(bytes.whole(0, 8))), 2000.0, 2000.0, {}};
  for (std::size_t layers = bytes.whole(0, 4); layers > 0; --layers) {
    Layer layer{known[bytes.whole(0, 3)], {}, bytes.whole(0, 4) > 0};
    if (bytes.whole(0, 3) == 0) layer.name = bytes.text(bytes.whole(0, 40));
    for (std::size_t shapes = bytes.whole(0, 3); shapes > 0; --shapes)
      layer.shapes.push_back(shape_from(bytes, anywhere));
    drawing.layers.push_back(std::move(layer));
  }
  for (std::size_t pieces = bytes.whole(0, 2); pieces > 0; --pieces)
    drawing.pieces.push_back({std::string(bytes.text(bytes.whole(0, 8))), "M", bytes.byte()});
  return drawing;
}

/// What is drawn, as lines: closed ones end where they begin.
struct Drawn {
  double length = 0.0;
  std::size_t points = 0;
};

enum class Wanted { all, stroked, stroked_and_visible };

Drawn drawn_in(const Drawing& drawing, Wanted wanted) {
  oracle::Lines lines;
  for (const Layer& layer : drawing.layers) {
    if (wanted == Wanted::stroked_and_visible && !layer.visible) continue;
    for (const DrawingShape& shape : layer.shapes) {
      const auto* path = std::get_if<Path>(&shape);
      if (path == nullptr || (wanted != Wanted::all && !path->stroke)) continue;
      for (auto line : path->lines) {
        if (path->closed && !line.empty()) line.push_back(line.front());
        lines.push_back(std::move(line));
      }
    }
  }
  Drawn drawn{oracle::length_of(lines)};
  for (const auto& line : lines)
    drawn.points += line.size();
  return drawn;
}

/// @param step to which coordinates are rounded, millimetres
void check_length(const oracle::Lines& lines, const Drawn& drawn, double step) {
  // Both ends of an edge may move by half the diagonal of a step.
  const double tolerance = static_cast<double>(drawn.points) * 1.5 * step + 1e-6;
  fuzz::check(std::abs(oracle::length_of(lines) - drawn.length) <= tolerance,
              "lines that are read back are as long as they were");
}

void check_svg(const Drawing& drawing, bool anywhere) {
  const oracle::Lines lines = oracle::lines_of_svg(format_svg(drawing));
  if (!anywhere) check_length(lines, drawn_in(drawing, Wanted::all), 0.001);
}

void check_dxf(const Drawing& drawing, bool anywhere) {
  for (const DxfProfile profile : k_dxf_profiles) {
    for (const bool stroked_text : {false, true}) {
      const DxfOptions options{.profile = profile, .stroked_text = stroked_text};
      const oracle::Lines lines = oracle::lines_of_dxf(format_dxf(drawing, options));
      if (anywhere || profile != DxfProfile::generic) continue;
      check_length(lines,
                   drawn_in(stroked_text ? with_stroked_text(drawing) : drawing, Wanted::stroked),
                   0.001);
    }
  }
}

void check_plt(const Drawing& drawing, bool anywhere) {
  const oracle::Lines lines = oracle::lines_of_plt(format_plt(drawing));
  if (anywhere) return;
  check_length(lines, drawn_in(with_stroked_text(drawing), Wanted::stroked_and_visible), 0.025);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const bool anywhere = bytes.whole(0, 3) == 0;
  const Paper paper = papers()[bytes.whole(0, papers().size() - 1)];
  const Drawing drawing = drawing_from(bytes, anywhere);
  check_svg(drawing, anywhere);
  check_dxf(drawing, anywhere);
  check_plt(drawing, anywhere);
  oracle::check_pdf(format_pdf(drawing));
  fuzz::allow_refusal([&] { oracle::check_pdf(format_tiled_pdf(drawing, {paper})); });
  return 0;
}
