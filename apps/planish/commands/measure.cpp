#include <planish/report/json_report.h>

#include "commands/commands.h"
#include "failures.h"
#include "session.h"
#include "summary.h"

namespace planish::cli {

namespace {

/// The mesh cannot be measured: tells all that is wrong with it, not only what came first.
Outcome refused(const std::string& path, const TriMesh& mesh, const Error& error) {
  return {refused_text(path, inspect(mesh)), json_report(error), k_exit_failed, error.what()};
}

Outcome run_measure(const Arguments& arguments, Session& session) {
  const std::string& path = arguments.operands.front();
  const TriMesh mesh = session.read(path).mesh;
  try {
    const MeasuredPatch patch = about(path, [&] { return measure_patch(mesh); });
    return {measure_text(path, patch), json_report(patch)};
  } catch (const Error& error) {
    return refused(path, mesh, error);
  }
}

}  // namespace

Command measure_command() {
  return {"measure",
          "tell how far a patch is from flattenable",
          "INPUT",
          "Prints sizes, topology and the figures of the angle defects of a triangle mesh (.obj, "
          ".ply, .stl or .off), and every problem that stands in the way of evolving it or laying "
          "it flat. Nothing is written.",
          {"INPUT"},
          {},
          {"planish measure panel.obj", "planish measure panel.obj --json"},
          run_measure};
}

}  // namespace planish::cli
