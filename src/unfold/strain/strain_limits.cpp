#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <planish/core/error.h>
#include <planish/core/range.h>
#include <planish/unfold/strain.h>

#include "core/neumaier_sum.h"
#include "unfold/strain/strain_of_edges.h"

namespace planish {

namespace {

using Kind = StrainLimitKind;

/// The member of that kind.
template <class Figures>
auto& member(Figures& figures, Kind kind) {
  switch (kind) {
    case Kind::p99:
      return figures.p99;
    case Kind::rms:
      return figures.rms;
    case Kind::max_stretch:
      return figures.max_stretch;
    case Kind::p99_stretch:
      return figures.p99_stretch;
    case Kind::max_compression:
      return figures.max_compression;
    case Kind::p99_compression:
      return figures.p99_compression;
    case Kind::max:
      break;
  }
  return figures.max;
}

std::string words_of(Kind kind) {
  switch (kind) {
    case Kind::max:
      return "strain of every edge";
    case Kind::p99:
      return "strain on 99 % of the area";
    case Kind::rms:
      return "rms strain";
    case Kind::max_stretch:
      return "stretch of every edge";
    case Kind::p99_stretch:
      return "stretch on 99 % of the area";
    case Kind::max_compression:
      return "compression of every edge";
    case Kind::p99_compression:
      return "compression on 99 % of the area";
  }
  return {};
}

double share_beyond(const std::vector<StrainOfEdge>& edges, Kind kind, double limit) {
  NeumaierSum beyond, all;
  for (const StrainOfEdge& edge : edges) {
    all.add(edge.area);
    if (part_of(edge.strain, kind) > limit) beyond.add(edge.area);
  }
  return all.value() > 0.0 ? beyond.value() / all.value() : 0.0;
}

/// The first edge with most of what the limit is for.
std::array<Index, 2> worst_edge(const std::vector<StrainOfEdge>& edges, Kind kind) {
  const auto worst = std::max_element(edges.begin(), edges.end(),
                                      [kind](const StrainOfEdge& a, const StrainOfEdge& b) {
                                        return part_of(a.strain, kind) < part_of(b.strain, kind);
                                      });
  return worst == edges.end() ? std::array<Index, 2>{} : worst->edge;
}

/// The smaller of limits, 0 where there is none.
double smaller(double a, double b) {
  if (a == 0.0 || b == 0.0) return std::max(a, b);
  return std::min(a, b);
}

/// Half of the way between a limit of stretch and one of compression; 0 where one is free.
double mean_of(double stretch, double compression) {
  if (stretch == 0.0 || compression == 0.0) return 0.0;
  return stretch == compression ? stretch : 0.5 * (stretch + compression);
}

}  // namespace

double part_of(double strain, Kind kind) {
  switch (kind) {
    case Kind::max_stretch:
    case Kind::p99_stretch:
      return std::max(0.0, -strain);
    case Kind::max_compression:
    case Kind::p99_compression:
      return std::max(0.0, strain);
    default:
      return std::abs(strain);
  }
}

double& StrainLimits::of(Kind kind) {
  return member(*this, kind);
}

double StrainLimits::of(Kind kind) const {
  return member(*this, kind);
}

double figure_of(const EdgeStrain& strain, Kind kind) {
  return member(strain, kind);
}

bool StrainLimits::any() const {
  return rms > 0.0 || bounds_edges();
}

bool StrainLimits::bounds_edges() const {
  return std::any_of(k_strain_limit_kinds.begin(), k_strain_limit_kinds.end(),
                     [this](Kind kind) { return kind != Kind::rms && of(kind) > 0.0; });
}

double StrainLimits::both_ways() const {
  const double of_area = mean_of(smaller(p99, p99_stretch), smaller(p99, p99_compression));
  if (of_area > 0.0) return of_area;
  return mean_of(smaller(max, max_stretch), smaller(max, max_compression));
}

bool StrainLimits::kept_by(const EdgeStrain& strain) const {
  return std::all_of(k_strain_limit_kinds.begin(), k_strain_limit_kinds.end(), [&](Kind kind) {
    return of(kind) == 0.0 || figure_of(strain, kind) <= of(kind);
  });
}

void require(const StrainLimits& limits) {
  constexpr Range range = {0.0, k_largest_strain_limit};
  for (const Kind kind : k_strain_limit_kinds)
    check_range("the limit of " + words_of(kind), limits.of(kind), range);
}

std::string_view to_string(Kind kind) {
  switch (kind) {
    case Kind::max:
      return "max";
    case Kind::p99:
      return "p99";
    case Kind::rms:
      return "rms";
    case Kind::max_stretch:
      return "max_stretch";
    case Kind::p99_stretch:
      return "p99_stretch";
    case Kind::max_compression:
      return "max_compression";
    case Kind::p99_compression:
      return "p99_compression";
  }
  return "unknown";
}

std::vector<StrainLimitCheck> check_limits(const Patch& patch, std::span<const Vec2> pattern,
                                           const StrainLimits& limits) {
  require(limits);
  if (!limits.any()) return {};
  const std::vector<StrainOfEdge> edges = strain_of_edges(patch, pattern);
  const EdgeStrain strain = figures_of(edges);
  std::vector<StrainLimitCheck> checks;
  for (const Kind kind : k_strain_limit_kinds) {
    const double asked = limits.of(kind);
    if (!(asked > 0.0)) continue;
    const auto [v, w] = worst_edge(edges, kind);
    const Vec3 middle = 0.5 * patch.positions()[v] + 0.5 * patch.positions()[w];
    checks.push_back(
        {kind, asked, figure_of(strain, kind), share_beyond(edges, kind, asked), {v, w}, middle});
  }
  return checks;
}

bool all_kept(std::span<const StrainLimitCheck> checks) {
  return std::all_of(checks.begin(), checks.end(),
                     [](const StrainLimitCheck& check) { return check.kept(); });
}

}  // namespace planish
