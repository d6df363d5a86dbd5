#include <array>

#include <planish/io/mesh_format.h>
#include <planish/report/json_report.h>

#include "batch/several_files.h"
#include "commands/commands.h"
#include "commands/jobs.h"
#include "cut/cut_flag.h"
#include "flags/constraint_flags.h"
#include "flags/method_flags.h"
#include "flags/scale_flag.h"
#include "flags/units.h"
#include "model/model_flags.h"
#include "platform/path.h"
#include "shell/failures.h"
#include "shell/output_folder.h"
#include "shell/session.h"
#include "shell/text.h"
#include "shell/values.h"
#include "text/summary.h"

namespace planish::cli {

namespace {

/// The name of the format that the mesh of an input is written in.
std::string mesh_format_for(const std::string& input) {
  try {
    return std::string(to_string(output_format(mesh_format_of(path_of(input)))));
  } catch (const Error&) {  // that reading it will throw again
    return "obj";
  }
}

/// The figures of one of several files for people.
std::string line_of(const EvolveReport& report) {
  const auto ratio = [](const std::optional<double>& value) {
    return value ? shorter_number(*value) : "-";
  };
  return right(short_number(report.before.figures.e_max), 8) +
         right(short_number(report.after.figures.e_max), 9) +
         right(short_number(report.deviation.rms), 9) +
         right(ratio(report.fairness.bending_added), 7) +
         right(ratio(report.fairness.bending_lost), 6) +
         right(report.fairness.is_smooth() ? "yes" : "no", 7) +
         right(shorter_number(report.result.seconds), 7) + "\n";
}

void evolve_into(WorkFile& file, const std::filesystem::path& place, const EvolveRequest& request,
                 const Arguments& arguments, Session& session) {
  const std::string& path = file.report.path;
  TriMesh mesh = read_whole(path, arguments, session);
  const auto [evolved, report, cautions] = about(path, [&] {
    return evolve_as_asked(Patch(std::move(mesh)), path, request, arguments, session);
  });
  note_cautions(session, path, cautions, request.unit);
  file.report.figures = evolved_figures(report, cautions, request.unit);
  file.text = line_of(report);
  file.misses = arguments.has("--require-target") && !report.outcome().target_met();
  if (!place.empty()) file.files = {{place, format_mesh(evolved, mesh_format_of(place))}};
}

CommandResult evolve_several(const Arguments& all, Session& session) {
  const Arguments arguments = with_files_that_are_asked_for(all, session);
  refuse_single_file_flags(
      arguments, std::array{"--cut", "--avoid", "--symmetric", "--mirror-surface", "--history",
                            "--fix", "--weights"});
  const EvolveRequest request = evolve_request_from(arguments);
  const auto format = output_format_from(all, names_of(k_mesh_formats));
  const SeveralFiles job = {
      .columns = evolved_columns(),
      .heads = "  e_max    after  deviat.  added  lost smooth   time",
      .missed_before = "the target is missed by ",
      .missed_behind = "",
      .extension =
          [&](const std::string& path) { return "." + format.value_or(mesh_format_for(path)); },
      .work = [&](WorkFile& file,
                  const auto& place) { evolve_into(file, place, request, arguments, session); }};
  return run_several(job, arguments, session);
}

CommandResult run_evolve(const Arguments& arguments, Session& session) {
  if (takes_several(arguments)) return evolve_several(arguments, session);
  output_format_from(arguments, names_of(k_mesh_formats));
  EvolveRequest request = evolve_request_from(arguments);
  const std::string output = arguments.text("--output");
  const MeshFormat format = mesh_format_of(path_of(output));
  std::vector<OutputFile> files = {{path_of(output), {}}};
  if (arguments.has("--history")) files.push_back({path_of(arguments.text("--history")), {}});
  refuse_shared_places(files);

  const std::string& path = arguments.operands.front();
  CutInput input = cut_as_asked(read_whole(path, arguments, session), path, arguments, session);
  request.symmetric_in = input.symmetric_in;
  const auto [evolved, report, cautions] = about(path, [&] {
    const Patch patch(std::move(input.mesh));
    note_obstruction(session, patch);
    if (!request.remesh) note_memory(session, request.method, patch.vertex_count());
    return evolve_as_asked(patch, path, request, arguments, session);
  });
  note_cautions(session, path, cautions, request.unit);
  files.front().content = format_mesh(evolved, format);
  if (files.size() > 1) files.back().content = history_csv(report.result.history);

  std::string text = path + " -> " + output + "  (" + size_text(evolved) + ")\n";
  const std::string json = json_report(report, cautions, request.unit, figures_of_cut(input.cut));
  CommandResult outcome =
      with_target_checked({text + evolve_text(report), json}, arguments, report);
  session.write(files);
  return outcome;
}

}  // namespace

EvolveRequest evolve_request_from(const Arguments& arguments, const Method& standard) {
  const Unit unit = unit_from(arguments);
  const Method method = method_from(arguments, standard);
  refuse_unsupported_constraints(arguments, method);
  return {unit,
          method,
          stopping_from(arguments, method),
          smooth_first_from(arguments),
          arguments.has("--remesh"),
          {}};
}

Evolved evolve_as_asked(const Patch& patch, const std::string& path, const EvolveRequest& request,
                        const Arguments& arguments, Session& session) {
  const auto& [unit, method, stopping, smooth_first, asks_to_remesh, symmetric_in] = request;
  Constraints constraints = constraints_from(arguments, patch, session);
  constraints.symmetric_in = symmetric_in;
  const Context context = session.job_context(path);
  if (smooth_first > 0.0) {
    const SmoothedDesign design = smooth_design(patch, smooth_first);
    EvolveReport report = with_smoothing(
        evolve_patch(design.patch, method, stopping, constraints, context), patch, design.done);
    return {{report.result.positions, patch.triangles()},
            std::move(report),
            find_cautions(patch, design.patch)};
  }
  if (asks_to_remesh) {
    check_constraints(constraints, patch.vertex_count(), method);
    const RemeshedPatch remeshed = remesh(patch, constraints);
    EvolveReport report = evolve_remeshed(patch, remeshed, method, stopping, context);
    return {{report.result.positions, remeshed.patch.triangles()},
            std::move(report),
            find_cautions(patch)};
  }
  EvolveReport report = evolve_patch(patch, method, stopping, constraints, context);
  return {{report.result.positions, patch.triangles()}, std::move(report), find_cautions(patch)};
}

Command evolve_command() {
  std::vector<FlagGroup> groups = {
      {"Output",
       {{"--output",
         "OUTPUT",
         "the evolved mesh: .obj, .ply, .stl or .off; with several inputs the folder for the "
         "meshes",
         'o',
         true,
         {.extensions = names_of(k_mesh_formats)}},
        unit_flag(),
        scale_flag(),
        remesh_flag(),
        smooth_first_flag(),
        {"--history",
         "FILE",
         "write the figures of every sweep to FILE, as comma-separated values",
         0,
         false,
         {.extensions = {"csv"}}},
        {"--require-target", "", "end with exit code 3 if e_max ends above --target-e-max"},
        csv_flag(),
        output_format_flag(names_of(k_mesh_formats), "that of the input, obj for .stl")}}};
  for (Flag& flag : cut_flags())
    groups.front().flags.push_back(std::move(flag));
  groups.push_back(model_flags());
  for (FlagGroup& group : method_flags(Method{}))
    groups.push_back(std::move(group));
  groups.push_back(constraint_flags());
  mark_first(groups,
             {"--output", "--unit", "--cut", "--remesh", "--history", "--method", "--sweeps",
              "--target-e-max", "--max-deviation", "--max-strain", "--prefer", "--fix"});
  return {"evolve",
          "change a patch as little as needed to make it more flattenable",
          "INPUT ... -o OUTPUT",
          "Moves the inner vertices of a patch by one method. The border, the triangles and the "
          "order of the vertices stay as they are, except with --cut and --remesh. OUTPUT may be "
          "INPUT. For several inputs, or all mesh files of a folder, prints one line each and "
          "writes the meshes into the folder OUTPUT, which is not needed with --csv. If one fails "
          "the others go on, and the exit code is 1.",
          {"INPUT"},
          std::move(groups),
          {"planish evolve panel.obj -o evolved.obj",
           "planish evolve panel.obj -o evolved.ply --sweeps 100 --max-deviation 2mm",
           "planish evolve panel.obj -o evolved.obj --method classical --lambda 0.5",
           "planish evolve panel.obj -o evolved.obj --method auto --max-strain 2%",
           "planish evolve panel.obj -o evolved.obj --fix seams.obj",
           "planish evolve patches -o evolved --method auto --csv figures.csv"},
          run_evolve,
          false,
          true,
          {{.extensions = names_of(k_mesh_formats)}}};
}

}  // namespace planish::cli
