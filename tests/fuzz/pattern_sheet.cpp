// Patterns with all that they may get besides their outline.

#include <array>
#include <cmath>
#include <string>

#include <planish/draw/format_drawing.h>
#include <planish/flatten/flatten.h>
#include <planish/sheet/pattern_sheet.h>

#include "fuzz/bytes_to_patch.h"
#include "fuzz/check.h"

using namespace planish;

namespace {

/// Mostly a vertex of the mesh.
Index vertex_from(fuzz::Bytes& bytes, const TriMesh& mesh) {
  return static_cast<Index>(bytes.whole(0, mesh.positions.size()));
}

Notch notch_from(fuzz::Bytes& bytes, const TriMesh& mesh) {
  Notch notch;
  const std::size_t kind = bytes.whole(0, 3);
  if (kind < 2) notch.fraction = 0.51 * (1.0 + bytes.fraction());
  if (kind == 2) notch = Notch::at_vertex(vertex_from(bytes, mesh));
  if (kind == 3) {
    const Index from = vertex_from(bytes, mesh), to = vertex_from(bytes, mesh);
    notch = Notch::on_edge(from, to, 0.5 * (1.0 + bytes.fraction()));
  }
  notch.kind = std::array{NotchKind::slit, NotchKind::v, NotchKind::t}[bytes.whole(0, 2)];
  notch.is_double = bytes.flag();
  return notch;
}

PatternOptions options_from(fuzz::Bytes& bytes, const TriMesh& mesh) {
  PatternOptions options;
  if (bytes.flag()) {
    options.allowance = Allowance{.width = 0.1 * static_cast<double>(bytes.whole(0, 60))};
    options.allowance->corners =
        std::array{Corners::mitre, Corners::square, Corners::round}[bytes.whole(0, 2)];
  }
  for (std::size_t k = bytes.whole(0, 3); k > 0; --k) {
    const Index from = vertex_from(bytes, mesh), to = vertex_from(bytes, mesh);
    options.edge_allowances.push_back({from, to, 0.1 * static_cast<double>(bytes.byte())});
  }
  for (std::size_t k = bytes.whole(0, 3); k > 0; --k)
    options.notches.push_back(notch_from(bytes, mesh));
  options.notch_sizes.depth = 0.02 * static_cast<double>(bytes.byte());
  if (bytes.flag()) options.grain = bytes.within(-360.0, 360.0);
  if (bytes.flag()) options.grain = Vec3{bytes.fraction(), bytes.fraction(), bytes.fraction()};
  for (std::size_t k = bytes.whole(0, 3); k > 0; --k)
    options.marks.push_back(
        {vertex_from(bytes, mesh), bytes.flag() ? MarkKind::cross : MarkKind::drill});
  for (std::size_t k = bytes.whole(0, 3); k > 1; --k)
    options.inner_lines.push_back({vertex_from(bytes, mesh), vertex_from(bytes, mesh)});
  options.label.name = bytes.text(bytes.whole(0, 12));
  options.label.note = bytes.text(bytes.whole(0, 12));
  options.label.quantity = static_cast<int>(bytes.byte());
  return options;
}

void check_shape(const Path& path) {
  for (const auto& line : path.lines) {
    for (const Vec2 p : line)
      fuzz::check(fuzz::is_finite(p), "what is drawn is somewhere");
  }
}
void check_shape(const Text& text) {
  fuzz::check(fuzz::is_finite(text.at) && std::isfinite(text.height) && text.height > 0.0,
              "texts are somewhere");
}

void check_sheet(const Drawing& sheet) {
  fuzz::check(std::isfinite(sheet.width) && std::isfinite(sheet.height), "sheets have a size");
  fuzz::check(sheet.layers.size() == k_sheet_layers.size(), "all layers are there");
  for (const Layer& layer : sheet.layers) {
    for (const DrawingShape& shape : layer.shapes)
      std::visit([](const auto& some) { check_shape(some); }, shape);
  }
  format_svg(sheet);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const Unit unit = std::array{Unit::mm, Unit::cm, Unit::m, Unit::in}[bytes.whole(0, 3)];
  const auto mesh = fuzz::patch_from(bytes, Purpose::unfold);
  if (!mesh) return 0;
  fuzz::allow_refusal([&] {
    const PatternOptions options = options_from(bytes, *mesh);
    const Patch surface(*mesh);
    check_pattern_options(options, mesh->positions.size(), surface.border_loops(), "patch");
    const auto unfolded = unfold_patch(Patch(*mesh), unit, {.max_iterations = 30});
    check_sheet(pattern_sheet(surface, unfolded, "patch", options));
  });
  return 0;
}
