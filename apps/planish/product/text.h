#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <planish/mesh/seams.h>

#include "product/run.h"

namespace planish::cli {

/// What is known of a patch in the end.
struct PatchOutcome {
  std::optional<Failure> failure;
  std::string report;         ///< report.json; empty where it was not reached
  TriMesh mesh;               ///< as it was processed; as it came where it was not reached
  std::vector<Vec2> pattern;  ///< of that, model units; empty where it was not reached
  bool is_twin = false;       ///< made from what was made of another one
  bool resumed = false;
};

/// A seam with its lengths in millimetres: on the model, then in the patterns of both sides, which
/// are not known where a patch failed.
struct SeamLengths {
  Seam seam;
  double on_model = 0.0;
  std::array<std::optional<double>, 2> in_pattern;

  std::optional<double> difference() const;
};

std::vector<SeamLengths> measure_seams(const std::vector<PatchOutcome>& outcomes,
                                       std::vector<Seam> seams, Unit unit);

/// The content of garment.json.
std::string product_json(const ProductJob& job, const std::vector<PatchOutcome>& outcomes,
                         const std::vector<SeamLengths>& seams);

/// Whether a finished patch ended for another reason than that it reached its target.
bool missed_target(const PatchOutcome& outcome);

/// Whether the pattern of a finished patch does not keep a limit that was asked for.
bool missed_limit(const PatchOutcome& outcome);

/// A line on a finished patch.
std::string patch_line(const ProductPatch& patch, const PatchOutcome& outcome);

/// How many patches were made from others; empty where none was.
std::string twins_text(const std::vector<PatchOutcome>& outcomes);

/// The seams as people read them.
std::string seams_text(const ProductJob& job, const std::vector<SeamLengths>& seams);

}  // namespace planish::cli
