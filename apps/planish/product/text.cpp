#include "product/text.h"

#include <algorithm>
#include <optional>

#include "flatten/product/piece_verdict.h"
#include "flatten/twin_report.h"
#include "shell/text.h"
#include "text/lengths.h"

namespace planish::cli {

namespace {

constexpr std::size_t k_name_width = 20;

/// A name cut to the width of its column.
std::string short_name(const std::string& name) {
  return name.size() <= k_name_width ? name : beginning(name, k_name_width - 1) + "~";
}

/// What the piece is judged by: "strain limit of 5 % kept: 3.2 %; ...".
std::string checks_text(const PatchResult& patch) {
  std::string text;
  for (const PieceCheck& check : piece_checks(patch))
    text += (text.empty() ? "" : "; ") + check.text;
  return text;
}

/// How far the form was changed; empty where it was not.
std::string moved_text(const FinishedPatch& patch) {
  if (patch.deviation.max == 0.0) return {};
  return "  moved up to " + ShownLengths(patch.unfold.unit).text(patch.deviation.max);
}

}  // namespace

std::string patch_line(const PatchResult& patch) {
  const bool is_judged = !patch.finished || patch.finished->not_judged.empty();
  const std::string mark = !patch.outcome().usable() ? "[no] " : is_judged ? "[ok] " : "[? ] ";
  const std::string name = mark + left(short_name(patch.name), k_name_width) + " ";
  std::string checks = checks_text(patch);
  if (!patch.finished) return name + checks;
  if (!is_judged)
    checks += (checks.empty() ? "" : "; ") + ("cannot be judged: " + patch.finished->not_judged);
  const UnfoldReport& unfold = patch.finished->unfold;
  const Pattern& pattern = unfold.pattern;
  const auto& twin = patch.finished->twin_of;
  const ShownLengths lengths(unfold.unit);
  return name + right(lengths.number(pattern.width), 7) + " x " +
         right(lengths.number(pattern.height), 7) + " " + lengths.unit() + "  strain rms " +
         right(percent(unfold.strain.rms), 8) + ", largest " +
         right(percent(unfold.strain.max), 8) + moved_text(*patch.finished) +
         (checks.empty() ? "" : "  " + checks) + (twin ? "  " + twin_text(*twin) : "") +
         (patch.resumed ? "  (from the earlier run)" : "");
}

std::string pieces_text(const ProductReport& report) {
  std::string text;
  std::size_t missing = 0;
  for (const std::size_t p : missed_first(report)) {
    text += "  " + patch_line(report.patches[p]) + "\n";
    missing += report.patches[p].outcome().usable() ? 0 : 1;
  }
  const std::string unit = "; model in " + std::string(to_string(report.unit));
  const std::string verdict = product_verdict(report);
  return counted(report.patches.size(), "piece") + unit +
         (missing == 0 ? "" : "; " + std::to_string(missing) + " to look at, first") + "\n" +
         (verdict.empty() ? "" : "\n" + wrapped(verdict, 0) + "\n") + "\n" + text;
}

std::string twins_text(const ProductReport& report) {
  const auto count = std::count_if(
      report.patches.begin(), report.patches.end(),
      [](const PatchResult& patch) { return patch.finished && patch.finished->twin_of; });
  if (count == 0) return {};
  return "\nOf " + std::to_string(report.patches.size()) + " patches " + std::to_string(count) +
         (count == 1 ? " is" : " are") + " made from another one, of the same shape or mirrored.\n";
}

namespace {

/// Borders that look like seams and are none.
std::string near_text(const ProductReport& report) {
  if (report.near_borders.empty()) return {};
  std::string text = "\nBorders beside each other that could not be matched to seams, in mm:\n";
  for (const NearBorders& near : report.near_borders) {
    text += right(digits(near.length, 3), 8) + "  " + near_borders_name(report, near) + "\n";
  }
  return text + "They are too short, too ragged or too far apart (--seam-tolerance).\n";
}

}  // namespace

namespace {

/// How to have sides of one length, where they are not as that was not wanted.
std::string matching_advice(const ProductReport& report) {
  constexpr double k_notable = 1.0;  // millimetres
  const bool is_matched =
      std::any_of(report.patches.begin(), report.patches.end(), [](const PatchResult& patch) {
        return patch.finished && (patch.finished->unfold.unmatched_strain ||
                                  patch.finished->unfold.pattern.is_unmatchable);
      });
  double most = 0.0;
  for (const MeasuredSeam& seam : report.seams)
    most = std::max(most, seam.difference().value_or(0.0));
  if (is_matched || most < k_notable) return {};
  return "Sides of a seam differ by up to " + fixed(most, 1) +
         " mm; without --no-match-seams they are as long as on the model.\n";
}

}  // namespace

void note_cautions_and_sizes(Session& session, const ProductReport& report, bool is_unit_given) {
  for (const PatchResult& patch : report.patches) {
    if (!patch.finished) continue;
    const UnfoldReport& unfold = patch.finished->unfold;
    if (unfold.pattern.is_unmatchable)
      session.note(
          patch.name +
          ": its border cannot keep its lengths in the plane, so its sides of seams may be "
          "longer or shorter than the other ones; remesh it more evenly, or divide it");
    if (!patch.finished->cautions.empty())
      session.note(patch.name + ": " + patch.finished->cautions);
    if (is_unit_given) continue;
    if (const auto size = unusual_size_text(unfold.pattern, unfold.unit))
      session.note(patch.name + ": " + *size);
  }
}

std::string seams_text(const ProductReport& report, bool is_batch) {
  const std::vector<MeasuredSeam>& seams = report.seams;
  const std::string near = near_text(report);
  if (seams.empty() && is_batch)
    return "\nEach file by itself; --product searches for seams between them.\n" + near;
  if (seams.empty() && near.empty())
    return "\nNo two borders run along each other: there are no seams.\n";
  if (seams.empty()) return "\nThere are no seams.\n" + near;
  std::string text = "\nSeams, in mm:   model     pattern of both sides   difference\n";
  for (std::size_t s = 0; s < seams.size(); ++s) {
    const MeasuredSeam& seam = seams[s];
    const auto length = [](const std::optional<double>& value) {
      return right(value ? fixed(*value, 2) : "-", 11);
    };
    const auto difference = seam.difference();
    const std::string easing = easing_text(report, seam);
    text += right(std::to_string(s + 1), 4) + "  " + right(fixed(seam.on_model[0], 2), 15) + " " +
            length(seam.in_pattern[0]) + " " + length(seam.in_pattern[1]) + "   " +
            (difference ? right(fixed(*difference, 2), 8) + "  " +
                              fixed(100.0 * *difference / seam.on_model[0], 3) + " %"
                        : right("-", 8)) +
            "\n      " + report.patches[seam.seam.sides[0].patch].name + " - " +
            report.patches[seam.seam.sides[1].patch].name +
            (seam.name.empty() ? "" : "  (" + seam.name + ")") + "\n" +
            (easing.empty() ? "" : "      " + easing + "\n");
  }
  return text + matching_advice(report) + near;
}

}  // namespace planish::cli
