#pragma once

#include <optional>
#include <span>
#include <string>

#include <planish/flatten/flatten.h>

namespace planish {

/// One of several files that were measured.
struct MeasuredFile {
  std::string path;                             ///< as it was named
  std::optional<MeasuredPatch> patch = {};      ///< none where it could not be measured
  std::optional<StrainAsDesigned> strain = {};  ///< none where it cannot be laid flat
  std::optional<Failure> failure = {};          ///< why something above is missing; often none
};

/// A header line, then a line a file, as docs/command-line.md has them. What is not known is empty.
std::string measured_csv(std::span<const MeasuredFile> files);

/// One object with "files", a list as docs/command-line.md has it, and "csv".
/// @param csv path of the table; empty where none was written
std::string measured_json(std::span<const MeasuredFile> files, const std::string& csv);

}  // namespace planish
