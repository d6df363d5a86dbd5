// A pattern as polygons in millimetres, for a CAD program: cut line, notches and grain.
#include <iostream>

#include <planish/planish.h>

int main() {
  using namespace planish;
  FlattenOptions options;
  options.unit = Unit::mm;
  options.limits.max = 0.02;
  const FlattenReport report = flatten(Patch(make_shape("panel", 1000)), "panel", options);

  PatternOptions wanted;
  wanted.allowance = Allowance{.width = 8.0};
  wanted.notches = {Notch::at_vertex(0), Notch::at_fraction(0.25, NotchKind::v)};
  wanted.grain = 90.0;
  const PatternGeometry pattern = pattern_geometry(report, wanted);
  for (const Polygon& loop : pattern.cut) {
    std::cout << "cut, " << signed_area(loop) << " mm2:";
    for (const Vec2 p : loop)
      std::cout << ' ' << p.x << ',' << p.y;
    std::cout << '\n';
  }
  for (const PlacedNotch& notch : pattern.notches)
    std::cout << to_string(notch.kind) << " at " << notch.at.x << ',' << notch.at.y << '\n';
}
