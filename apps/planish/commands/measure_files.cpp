#include "commands/measure_files.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "flags/limit_flags.h"
#include "platform/path.h"
#include "product/parts.h"
#include "report/measured_files.h"
#include "shell/failures.h"
#include "shell/text.h"
#include "text/summary.h"

namespace planish::cli {

namespace {

bool is_folder(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_directory(path_of(path), ignored);
}

void refuse_single_file_flags(const Arguments& arguments) {
  for (const char* flag : {"--map", "--picture", "--fields"}) {
    if (!arguments.has(flag)) continue;
    throw UsageError("flag " + std::string(flag) + " goes with one file only, without --csv");
  }
}

/// @param file gets what can be measured before something fails
void measure_into(MeasuredFile& file, const StrainLimits& limits, Session& session) {
  try {
    const Patch patch = about(file.path, [&] { return Patch(session.read(file.path).mesh); });
    about(file.path, [&] {
      file.patch = measure_patch(patch, session.job_context(file.path));
      file.strain = strain_of(patch, limits, session);
      if (file.strain) file.strain->pattern = {};  // the table has figures only
    });
  } catch (const std::exception&) {
    file.failure = current_failure();
  }
}

/// The files that are named, and those in folders that are.
std::vector<MeasuredFile> files_named(const std::vector<std::string>& operands, Session& session) {
  std::vector<MeasuredFile> files;
  for (const std::string& operand : operands) {
    if (!is_folder(operand)) {
      files.push_back({operand});
      continue;
    }
    try {
      for (std::string& path : mesh_files_in(session, operand))
        files.push_back({std::move(path)});
    } catch (const Error&) {
      files.push_back({.path = operand, .failure = current_failure()});
    }
  }
  return files;
}

constexpr std::size_t k_name_width = 26;

/// The end of a path, where files of one folder differ.
std::string short_path(const std::string& path) {
  if (path.size() <= k_name_width) return path;
  std::size_t from = path.size() - k_name_width + 1;
  while (from < path.size() && (static_cast<unsigned char>(path[from]) & 0xC0U) == 0x80U)
    ++from;
  return "~" + path.substr(from);
}

std::string line_of(const MeasuredFile& file) {
  const std::string name = left(short_path(file.path), k_name_width) + " ";
  if (file.failure) return name + "failed: " + file.failure->message + "\n";
  const Flattenability& figures = file.patch->figures;
  const auto share = [&](double EdgeStrain::*figure, std::size_t width) {
    return right(file.strain ? percent(file.strain->least_stretch.*figure) : "-", width);
  };
  return name + right(std::to_string(file.patch->inspection.topology.vertices), 9) + " " +
         right(digits(figures.e_max), 10) + " " + right(digits(figures.sum_abs_defect), 10) +
         share(&EdgeStrain::rms, 12) + share(&EdgeStrain::max, 10) + "\n";
}

std::string table_of(const std::vector<MeasuredFile>& files) {
  std::string text =
      left("file", k_name_width) + "  vertices      e_max  sum |d_v|  rms strain" + "   largest\n";
  for (const MeasuredFile& file : files)
    text += line_of(file);
  return text;
}

bool misses_limit(const MeasuredFile& file) {
  return file.strain && !all_kept(file.strain->limits);
}

CommandResult with_failures_counted(CommandResult outcome, const std::vector<MeasuredFile>& files) {
  const auto failed = std::count_if(files.begin(), files.end(),
                                    [](const MeasuredFile& f) { return f.failure.has_value(); });
  const auto missed = std::count_if(files.begin(), files.end(), misses_limit);
  const std::string of = " of " + counted(files.size(), "file");
  if (failed > 0) {
    outcome.exit_code = k_exit_failed;
    outcome.complaint = std::to_string(failed) + of + " failed";
  } else if (missed > 0) {
    outcome.exit_code = k_exit_target_missed;
    outcome.complaint = "no pattern of " + std::to_string(missed) + of + " keeps the limit";
  }
  return outcome;
}

}  // namespace

std::optional<StrainAsDesigned> strain_of(const Patch& patch, const StrainLimits& limits,
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

bool measures_several(const Arguments& arguments) {
  return arguments.operands.size() > 1 || arguments.has("--csv") ||
         is_folder(arguments.operands.front());
}

CommandResult measure_files(const Arguments& arguments, Session& session) {
  refuse_single_file_flags(arguments);
  const StrainLimits limits = limits_from(arguments);
  std::vector<MeasuredFile> files = files_named(arguments.operands, session);
  for (MeasuredFile& file : files) {
    if (!file.failure) measure_into(file, limits, session);
  }
  const std::string csv = arguments.value_or("--csv", "");
  std::string text = table_of(files);
  std::vector<OutputFile> written;
  if (!csv.empty()) {
    written.push_back({path_of(csv), measured_csv(files)});
    text += written_text(written);
  }
  CommandResult outcome =
      with_failures_counted({std::move(text), measured_json(files, csv)}, files);
  if (!written.empty()) session.write(written);
  return outcome;
}

}  // namespace planish::cli
