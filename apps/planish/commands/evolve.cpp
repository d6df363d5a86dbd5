#include <planish/io/mesh_format.h>
#include <planish/report/json_report.h>

#include "commands/commands.h"
#include "flags/constraint_flags.h"
#include "flags/cut_flag.h"
#include "flags/method_flags.h"
#include "flags/units.h"
#include "platform/path.h"
#include "shell/failures.h"
#include "shell/session.h"
#include "shell/text.h"
#include "text/summary.h"

namespace planish::cli {

namespace {

struct Evolved {
  TriMesh mesh;  ///< with the evolved positions
  EvolveReport report;
};

Evolved evolve_with_progress(const Patch& patch, const Arguments& arguments, Session& session) {
  const Method method = method_from(arguments, Method{});
  const Stopping stopping = stopping_from(arguments, method);
  const Constraints constraints = constraints_from(arguments, patch, session);
  const Context context = session.job_context(arguments.operands.front());
  if (const double length = smooth_first_from(arguments); length > 0.0) {
    const SmoothedDesign design = smooth_design(patch, length);
    EvolveReport report = with_smoothing(
        evolve_patch(design.patch, method, stopping, constraints, context), patch, design.done);
    return {{report.result.positions, patch.triangles()}, std::move(report)};
  }
  if (arguments.has("--remesh")) {
    check_constraints(constraints, patch.vertex_count(), method);
    const RemeshedPatch remeshed = remesh(patch, constraints);
    EvolveReport report = evolve_remeshed(patch, remeshed, method, stopping, context);
    return {{report.result.positions, remeshed.patch.triangles()}, std::move(report)};
  }
  EvolveReport report = evolve_patch(patch, method, stopping, constraints, context);
  return {{report.result.positions, patch.triangles()}, std::move(report)};
}

CommandResult run_evolve(const Arguments& arguments, Session& session) {
  // What can be wrong with the request is told before any work.
  unit_from(arguments);
  const std::string& output = arguments.flags.at("--output");
  const MeshFormat format = mesh_format_of(path_of(output));
  std::vector<OutputFile> files = {{path_of(output), {}}};
  if (arguments.has("--history")) files.push_back({path_of(arguments.flags.at("--history")), {}});
  refuse_shared_places(files);
  const Method method = method_from(arguments, Method{});
  smooth_first_from(arguments);
  refuse_unsupported_constraints(arguments, method);
  stopping_from(arguments, method);

  const std::string& path = arguments.operands.front();
  const CutInput input = cut_as_asked(session.read(path).mesh, path, arguments, session);
  const auto [evolved, report] = about(path, [&] {
    const Patch patch(input.mesh);
    note_obstruction(session, patch);
    if (!arguments.has("--remesh")) note_memory(session, method, patch.vertex_count());
    return evolve_with_progress(patch, arguments, session);
  });
  files.front().content = format_mesh(evolved, format);
  if (files.size() > 1) files.back().content = history_csv(report.result.history);

  std::string text = path + " -> " + output + "  (" + size_text(evolved) + ")\n";
  const std::string json = json_report(report, figures_of_cut(input.cut));
  CommandResult outcome =
      with_target_checked({text + evolve_text(report), json}, arguments, report);
  session.write(files);
  return outcome;
}

}  // namespace

Command evolve_command() {
  std::vector<FlagGroup> groups = {
      {"Output",
       {{"--output", "OUTPUT", "the evolved mesh: .obj, .ply, .stl or .off", 'o', true},
        unit_flag(),
        cut_flag(),
        remesh_flag(),
        smooth_first_flag(),
        {"--history", "FILE", "the figures of every sweep, as comma-separated values"},
        {"--require-target", "", "end with exit code 3 where e_max misses --target-e-max"}}}};
  for (FlagGroup& group : method_flags(Method{}))
    groups.push_back(std::move(group));
  groups.push_back(constraint_flags());
  mark_first(groups,
             {"--output", "--unit", "--cut", "--remesh", "--history", "--method", "--sweeps",
              "--target-e-max", "--max-deviation", "--max-strain", "--prefer", "--fix"});
  return {
      "evolve",
      "change a patch as little as needed towards flattenable",
      "INPUT -o OUTPUT",
      "Moves the inner vertices of a patch by one method. The border, the triangles and the "
      "order of the vertices stay as they are, but for --cut and --remesh. OUTPUT may be INPUT.",
      {"INPUT"},
      std::move(groups),
      {"planish evolve panel.obj -o evolved.obj",
       "planish evolve panel.obj -o evolved.ply --sweeps 100 --max-deviation 2mm",
       "planish evolve panel.obj -o evolved.obj --method classical --lambda 0.5",
       "planish evolve panel.obj -o evolved.obj --method auto --max-strain 2%",
       "planish evolve panel.obj -o evolved.obj --fix seams.obj"},
      run_evolve};
}

}  // namespace planish::cli
