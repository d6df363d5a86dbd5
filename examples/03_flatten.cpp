// The whole job in C++: measure, evolve, lay flat, write the pattern at true size and the report.
#include <array>
#include <iostream>

#include <planish/draw/format_drawing.h>
#include <planish/io/write_file.h>
#include <planish/mesh/shapes.h>
#include <planish/report/html_report.h>
#include <planish/sheet/pattern_sheet.h>

int main() {
  planish::FlattenOptions options;
  options.unit = planish::Unit::mm;
  options.limits.rms = 0.005;
  const auto report =
      planish::flatten(planish::Patch(planish::make_shape("panel", 1000)), "panel", options);

  const planish::EdgeStrain& before = report.design_least_stretch.strain;
  const planish::EdgeStrain& after = report.unfold.strain;
  std::cout << "rms strain of the pattern " << 100 * before.rms << " % -> " << 100 * after.rms
            << " %\nlargest move " << report.evolve.deviation.max << " mm\n";

  const planish::Drawing sheet = pattern_sheet(report.processed, report.unfold, report.name);
  planish::write_files(std::array{planish::OutputFile{"panel.svg", format_svg(sheet)},
                                  planish::OutputFile{"panel.html", planish::html_report(report)}});
}
