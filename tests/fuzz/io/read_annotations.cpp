// The readers of notches, marks, inner lines, allowances of edges and notches on seams, and of
// those that are drawn on a patch.

#include <cmath>

#include <planish/mesh/patch.h>
#include <planish/pattern/pattern_options.h>
#include <planish/pattern/read_annotations.h>

#include "fuzz/check.h"
#include "support/meshes.h"

using namespace planish;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  fuzz::allow_refusal_of("file", [&] {
    for (const Notch& notch : notches_in(parse_rows(bytes, "file"))) {
      fuzz::check(std::isfinite(notch.fraction), "fractions are finite");
      fuzz::check(!notch.edge || notch.vertex(), "files name no edges");
    }
  });
  fuzz::allow_refusal_of("file", [&] { marks_in(parse_rows(bytes, "file")); });
  fuzz::allow_refusal_of("file", [&] {
    for (const InnerLine& line : inner_lines_in(parse_rows(bytes, "file")))
      fuzz::check(line.size() >= 2, "inner lines have two ends");
  });
  fuzz::allow_refusal_of("file", [&] {
    for (const EdgeAllowance& edge : edge_allowances_in(parse_rows(bytes, "file")))
      fuzz::check(edge.width >= 0.0 && std::isfinite(edge.width), "widths are at least 0");
  });
  fuzz::allow_refusal_of("file", [&] {
    for (const SeamNotch& notch : seam_notches_in(parse_rows(bytes, "file")))
      fuzz::check(std::isfinite(notch.place), "positions are finite");
  });
  const Patch patch(meshes::rough_grid(5, 4, 3));
  for (const auto parse : {parse_drawn_notches, parse_drawn_marks, parse_drawn_lines}) {
    fuzz::allow_refusal_of("file", [&] {
      const DrawnAnnotations drawn = parse(bytes, patch, "file");
      const PatternOptions options{
          .notches = drawn.notches, .marks = drawn.marks, .drawn_lines = drawn.lines};
      check_pattern_options(options, patch.vertex_count(), patch.border_loops(), "patch");
      fuzz::check(std::isfinite(drawn.farthest) && std::isfinite(drawn.outside_length),
                  "lengths are finite");
    });
  }
  return 0;
}
