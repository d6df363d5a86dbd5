#include <array>
#include <iterator>
#include <optional>
#include <utility>

#include <planish/core/ways_on.h>
#include <planish/io/mesh_format.h>
#include <planish/report/json_report.h>

#include "batch/several_files.h"
#include "commands/commands.h"
#include "commands/jobs.h"
#include "flags/fields_flag.h"
#include "flags/limit_flags.h"
#include "flags/scale_flag.h"
#include "flags/units.h"
#include "model/model_flags.h"
#include "platform/path.h"
#include "report/pictures/direction_map.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/session.h"
#include "shell/text.h"
#include "shell/values.h"
#include "text/json_text.h"
#include "text/summary.h"
#include "text/written_text.h"

namespace planish::cli {

namespace {

/// The figures of one of several files for people.
std::string line_of(const MeasuredPatch& patch, const std::optional<StrainAsDesigned>& strain) {
  const auto share = [&](double EdgeStrain::*figure, std::size_t width) {
    return right(strain ? percent(strain->least_stretch.*figure) : "-", width);
  };
  return right(std::to_string(patch.inspection.topology.vertices), 9) + " " +
         right(digits(patch.figures.e_max), 10) + " " +
         right(digits(patch.figures.sum_abs_defect), 10) + share(&EdgeStrain::rms, 12) +
         share(&EdgeStrain::max, 10) + "\n";
}

/// @param file gets what can be measured before something fails
void measure_into(WorkFile& file, const StrainLimits& limits, const Arguments& arguments,
                  Session& session) {
  const std::string& path = file.report.path;
  const Unit unit = unit_from(arguments);
  std::vector<Caution> cautions;
  const auto take = [&](const MeasuredPatch& measured,
                        const std::optional<StrainAsDesigned>& strain) {
    file.report.figures = measured_figures(measured, strain, cautions, unit);
    file.text = line_of(measured, strain);
    file.misses = strain && !all_kept(strain->limits);
  };
  const Patch patch = about(path, [&] { return Patch(read_whole(path, arguments, session)); });
  about(path, [&] {
    const MeasuredPatch measured = measure_patch(patch, session.job_context(path));
    cautions = find_cautions(patch);
    note_cautions(session, path, cautions, unit);
    take(measured, std::nullopt);
    take(measured, strain_as_asked(patch, limits, session));
  });
}

CommandResult measure_several(const Arguments& all, Session& session) {
  const Arguments arguments = with_files_that_are_asked_for(all, session);
  refuse_single_file_flags(arguments, std::array{"--map", "--picture", "--fields", "--unit"});
  const StrainLimits limits = limits_from(arguments);
  const SeveralFiles job = {
      .columns = measured_columns(),
      .heads = " vertices      e_max  sum |d_v|  rms strain   largest",
      .missed_before = "no pattern of ",
      .missed_behind = " keeps the limit",
      .work = [&](WorkFile& file, const auto&) { measure_into(file, limits, arguments, session); }};
  return run_several(job, arguments, session);
}

/// The mesh cannot be measured: tells all that is wrong with it, not only what came first.
CommandResult refused(const std::string& path, const TriMesh& mesh, const Error& error) {
  return {refused_text(path, inspect(mesh)), json_report(error), k_exit_failed, with_way_on(error)};
}

/// @throws Error unsupported_format
void check_picture_format(const std::string& path) {
  if (extension_of(path) == ".svg") return;
  throw Error(ErrorCode::unsupported_format, "the picture is an .svg file", {.path = path});
}

/// The files of directions that the flags ask for, without content.
/// @throws UsageError where one of them has the path of another output
std::vector<OutputFile> places_from(const Arguments& arguments) {
  std::vector<OutputFile> files;
  for (const char* flag : {"--map", "--picture"}) {
    if (arguments.has(flag)) files.push_back({path_of(arguments.text(flag)), {}});
  }
  if (arguments.has("--picture")) check_picture_format(arguments.text("--picture"));
  std::vector<OutputFile> all = files;
  for (const auto& [role, path] : fields_paths(arguments))
    all.push_back({path_of(path), {}});
  refuse_shared_places(all);
  return files;
}

struct DrawnDirections {
  std::vector<OutputFile> files;
  DirectionCounts counts;
};

/// @param files without content
DrawnDirections directions_of(const Patch& patch, std::vector<OutputFile> files,
                              const Arguments& arguments) {
  const auto directions = laplacian_directions(patch);
  const std::string name = stem_of(arguments.operands.front());
  if (arguments.has("--map")) files.front().content = direction_csv(directions);
  if (arguments.has("--picture"))
    files.back().content = direction_svg(patch.mesh(), directions, name);
  return {std::move(files), count_directions(directions)};
}

CommandResult run_measure(const Arguments& arguments, Session& session) {
  if (takes_several(arguments)) return measure_several(arguments, session);
  std::vector<OutputFile> files = places_from(arguments);
  const std::string& path = arguments.operands.front();
  const StrainLimits limits = limits_from(arguments);
  const Unit unit = unit_from(arguments);
  const TriMesh mesh = read_whole(path, arguments, session);
  Patch patch;
  MeasuredPatch measured;
  try {
    about(path, [&] {
      patch = Patch(mesh);
      measured = measure_patch(patch);
    });
  } catch (const Error& error) {
    return refused(path, mesh, error);
  }
  const auto strain = about(path, [&] { return strain_as_asked(patch, limits, session); });
  const std::vector<Caution> cautions = find_cautions(patch);
  std::string text = measure_text(path, measured, strain, cautions, unit);
  std::vector<MoreFigures> more;
  if (!files.empty()) {
    DrawnDirections drawn = directions_of(patch, std::move(files), arguments);
    files = std::move(drawn.files);
    text += directions_text(drawn.counts);
    more.push_back(figures_of(drawn.counts));
  }
  if (arguments.has("--fields")) {
    const Pattern pattern = strain ? strain->pattern : Pattern{};
    std::vector<OutputFile> fields =
        fields_files(mesh, fields_of(patch, pattern.positions), fields_paths(arguments));
    std::move(fields.begin(), fields.end(), std::back_inserter(files));
  }
  if (!files.empty()) text += written_text(files);
  CommandResult outcome = {std::move(text), json_report(measured, strain, cautions, unit, more)};
  if (!files.empty()) session.write(files);
  return strain ? with_limits_checked(std::move(outcome), strain->limits) : outcome;
}

}  // namespace

std::optional<StrainAsDesigned> strain_as_asked(const Patch& patch, const StrainLimits& limits,
                                                Session& session) {
  if (!limits.any() && blocking_problem(patch.inspection(), Purpose::unfold)) return std::nullopt;
  try {
    return strain_as_designed(patch, limits, session.job_context({}));
  } catch (const Error& error) {
    const bool is_no_fault =
        error.code() == ErrorCode::unfold_failed || error.code() == ErrorCode::too_large;
    if (limits.any() || !is_no_fault) throw;
    return std::nullopt;
  }
}

Command measure_command() {
  return {
      "measure",
      "print how far a patch is from flattenable",
      "INPUT ...",
      "Prints the size, the topology and the angle defects of a triangle mesh (.obj, .ply, .stl or "
      ".off), and every problem that prevents evolving it or laying it flat. Also lays the patch "
      "flat as it is, and prints the strain of that pattern and how much a sheet must take to be "
      "formed to the patch. Ends with exit code 3 if no pattern keeps a limit that was asked for. "
      "With --map or --picture also says for each vertex whether it is flat, on a dome or cup, or "
      "on a saddle, and whether its Laplacian direction lowers the energy of its ring; without "
      "these flags no file is written. For several inputs, or all mesh files of a folder, prints "
      "one line each; if one fails the others go on, and the exit code is 1.",
      {"INPUT"},
      {{"Output",
        {{"--map",
          "FILE",
          "write classes and directions of all vertices to FILE, as comma-separated values",
          0,
          false,
          {.extensions = {"csv"}}},
         {"--picture",
          "FILE",
          "the same as pictures side by side: .svg",
          0,
          false,
          {.extensions = {"svg"}}},
         unit_flag(),
         scale_flag(),
         fields_flag(),
         csv_flag()}},
       model_flags(),
       {"Limits of the pattern", limit_flags()}},
      {"planish measure panel.obj", "planish measure panel.obj --json",
       "planish measure panel.obj --material neoprene",
       "planish measure panel.obj --map panel.csv --picture panel.svg",
       "planish measure panel.obj --fields panel-fields.vtp",
       "planish measure front.obj back.ply patches --csv figures.csv"},
      run_measure,
      false,
      true,
      {{.extensions = names_of(k_mesh_formats)}}};
}

}  // namespace planish::cli
