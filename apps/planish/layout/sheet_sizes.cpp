#include "layout/sheet_sizes.h"

#include <algorithm>
#include <utility>

#include <planish/sheet/nest_sheet.h>
#include <planish/unfold/unfold.h>

namespace planish::cli {

namespace {

// A pattern may become smaller than the design. Of so much of it we are sure.
constexpr double k_sure_length = 0.8;

/// In square model units.
double area_of(const Patch& patch) {
  const std::vector<Vec3>& p = patch.positions();
  double doubled = 0.0;
  for (const Triangle& t : patch.triangles())
    doubled += norm(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
  return 0.5 * doubled;
}

Pattern design_of(const Patch& patch, const Session& session) {
  try {
    return unfold(patch, {.least_stretch = true}, session.silent_context());
  } catch (const Error& error) {
    if (error.code() == ErrorCode::unfold_failed) return {};
    throw;
  }
}

NestJob job_of(const Patch& patch, const std::string& name, std::vector<Vec2> positions,
               const PatternPlan& plan) {
  PatternOptions annotations;
  annotations.label = plan.annotations.label;
  annotations.grain = plan.annotations.grain;
  return {{{name, patch.mesh(), std::move(positions), std::move(annotations)}},
          plan.unit,
          *plan.sheets};
}

void check_sheets(const Patch& patch, const std::string& name, const PatternPlan& plan,
                  const Session& session) {
  const std::vector<Vec2> design = design_of(patch, session).positions;
  std::vector<Vec2> least = design;
  for (Vec2& p : least)
    p = k_sure_length * p;
  NestOptions quick = *plan.sheets;
  quick.tries = 0;
  // How the pattern will lie is not known, unless a grain says so.
  if (!plan.annotations.grain) quick.turns = Turns::free;
  try {
    nest(nest_pieces(job_of(patch, name, std::move(least), plan)), quick, session.silent_context());
  } catch (const Error& error) {
    if (error.code() != ErrorCode::piece_too_large) throw;
    // With the size that the design has.
    nest(nest_pieces(job_of(patch, name, design, plan)), quick, session.silent_context());
  }
}

}  // namespace

void check_pattern_size(const Patch& patch, const std::string& name, const PatternPlan& plan,
                        const Session& session) {
  if (plan.output.pages) {
    const double sure = k_sure_length * millimetres_per(plan.unit);
    check_page_area(sure * sure * area_of(patch), *plan.output.pages);
  }
  if (plan.sheets == nullptr) return;
  check_copies_of(1, plan);
  check_sheets(patch, name, plan, session);
}

void check_copies_of(std::size_t patches, const PatternPlan& plan) {
  if (plan.sheets == nullptr) return;
  check_copies(static_cast<double>(patches) * std::max(1, plan.annotations.label.quantity));
}

}  // namespace planish::cli
