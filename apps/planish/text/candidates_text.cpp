#include "text/candidates_text.h"

#include <algorithm>
#include <optional>

#include "shell/text.h"

namespace planish::cli {

namespace {

constexpr std::size_t k_name = 21, k_length = 8, k_strain = 8, k_ratio = 6, k_least = 5;

/// In per cent without the sign, which the head has.
std::string in_percent(double share) {
  constexpr double least = 5e-6, little = 1e-4;
  if (share < least) return "0";
  return share < little ? fixed(100.0 * share, 3) : digits(100.0 * share, 3);
}

std::string ratio(const std::optional<double>& value) {
  return value ? fixed(*value, 2) : "-";
}

struct CandidateCells {
  std::string name, strain, most_strain, moved, most_moved, bending, added, lost, fold, smooth;
};

/// Never without a blank before it.
std::string column(const std::string& text, std::size_t width) {
  return " " + right(text, width - 1);
}

std::string row(const CandidateCells& cells) {
  const std::string text = left(cells.name, k_name) + column(cells.strain, k_strain) +
                           column(cells.most_strain, k_strain) + column(cells.moved, k_length) +
                           column(cells.most_moved, k_length) + column(cells.bending, k_length) +
                           column(cells.added, k_ratio) + column(cells.lost, k_least) +
                           column(cells.fold, k_least);
  return text + (cells.smooth.empty() ? "" : "  " + cells.smooth) + "\n";
}

/// The numbers and names of those that were not computed and would not be the design again.
std::string others_text(const FlattenReport& report, const std::vector<Candidate>& computed) {
  const double least_stretch = report.design_least_stretch.strain.rms;
  const std::optional<int> dropped =
      report.rejected ? preset_of(*report.evolve.method) : std::nullopt;
  const auto is_computed = [&](int number) {
    return std::any_of(computed.begin(), computed.end(),
                       [&](const Candidate& candidate) { return candidate.preset == number; });
  };
  std::string text;
  for (int number = 1; number <= k_candidates; ++number) {
    const bool is_design_again = preset_options(number).limits.rms >= least_stretch;
    if (is_computed(number) || number == dropped || is_design_again) continue;
    text += (text.empty() ? "" : ", ") + std::to_string(number) + " (" + preset_name(number) + ")";
  }
  return text;
}

}  // namespace

std::string candidate_head(const ShownLengths& lengths) {
  return row({"", "strain", "most", "moved", "most", "bending", "added", "lost", "fold", ""}) +
         row({"", "rms %", "%", "rms " + lengths.unit(), lengths.unit(), "ratio", "", "", "deg",
              ""});
}

std::string candidate_row(const std::string& mark, const Candidate& candidate,
                          const ShownLengths& lengths) {
  const Fairness& form = candidate.fairness;
  const auto beside_design = [&](const std::optional<double>& value) {
    return candidate.is_design() ? "-" : ratio(value);
  };
  const std::string number = candidate.preset ? std::to_string(*candidate.preset) + " " : "";
  return row({left(mark, 2) + number + candidate_name(candidate), in_percent(candidate.strain.rms),
              in_percent(candidate.strain.max), lengths.number(candidate.deviation.rms),
              lengths.number(candidate.deviation.max), beside_design(form.bending_ratio),
              beside_design(form.bending_added), beside_design(form.bending_lost),
              form.sharpest_fold ? fixed(form.sharpest_fold->degrees, 0) : "-",
              form.is_smooth() && form.keeps_form() ? "" : "!"});
}

std::string candidates_text(const FlattenReport& report) {
  const std::vector<Candidate> candidates = report.candidates();
  const ShownLengths lengths(report.unfold.unit);
  std::string text = candidate_head(lengths);
  for (const Candidate& candidate : candidates)
    text += candidate_row(&candidate == &candidates.back() ? "> " : "", candidate, lengths);
  const Fairness& last = candidates.back().fairness;
  const bool is_faulty = !last.is_smooth() || !last.keeps_form();
  const std::string others = others_text(report, candidates);
  return text + "\n" +
         wrapped(std::string("> is what was written.") +
                     (is_faulty ? " ! is not smooth, or the form is not kept." : "") +
                     " Others to choose" +
                     (report.unfold.limits.empty() ? "" : ", without the limit") + ": --pick " +
                     others + "; \"planish frontier\" computes them all.",
                 0) +
         "\n";
}

}  // namespace planish::cli
