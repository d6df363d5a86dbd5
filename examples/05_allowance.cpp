// A pattern with a seam allowance as a DXF file in the form that apparel programs read.
#include <array>
#include <iostream>

#include <planish/planish.h>

int main() {
  using namespace planish;
  FlattenOptions options;
  options.unit = Unit::mm;
  options.method = Auto{.limits = {.rms = 0.01}};
  const auto report = flatten(Patch(make_shape("panel", 1000)), "panel", options);

  PatternOptions pattern;
  pattern.allowance = Allowance{.width = 10.0};
  pattern.grain = Vec3{0.0, 0.0, 1.0};
  const Drawing sheet = pattern_sheet(report.processed, report.unfold, report.name, pattern);
  write_files(
      std::array{OutputFile{"panel.dxf", format_dxf(sheet, {.profile = DxfProfile::aama})}});
  std::cout << "rms strain " << 100.0 * report.unfold.strain.rms << " %, written to panel.dxf\n";
}
