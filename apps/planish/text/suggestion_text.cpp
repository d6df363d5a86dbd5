#include "text/suggestion_text.h"

#include <optional>

#include <planish/core/version.h>
#include <planish/io/read_features.h>

#include <planish_json/json.h>

#include "report/json_parts.h"
#include "shell/text.h"
#include "text/summary.h"

namespace planish::cli {

namespace {

std::string strain_text(const EdgeStrain& strain) {
  return percent(strain.max) + " (rms " + percent(strain.rms) + ")";
}

/// "dart, 42 mm: strain 7.61 % (rms 2.10 %) -> 0.90 % (rms 0.20 %)"
std::string cut_text(const SuggestedCut& cut, const std::string& unit) {
  std::string what =
      std::string(cut.is_dart ? "dart" : "seam") + ", " + digits(cut.length) + " " + unit;
  if (!cut.after) return what;  // no pattern yet
  return what + ": strain " + (cut.before ? strain_text(*cut.before) + " -> " : "") +
         strain_text(*cut.after);
}

/// Why there are no more darts, where the limit is not met.
std::string why_no_more(SuggestStop stop) {
  switch (stop) {
    case SuggestStop::strain_met:
      break;
    case SuggestStop::dart_limit:
      return "all darts of --max-cuts are there";
    case SuggestStop::no_gain:
      return "no dart that was tried lowers the rms strain by 5 % more";
    case SuggestStop::overlap:
      return "the darts that would lower the strain make the pattern overlap itself";
  }
  return {};
}

/// What a limit of this kind does to the pattern: "strained", "stretched" or "compressed".
std::string verb_of(StrainLimitKind kind) {
  using Kind = StrainLimitKind;
  if (kind == Kind::max_stretch || kind == Kind::p99_stretch) return "stretched";
  if (kind == Kind::max_compression || kind == Kind::p99_compression) return "compressed";
  return "strained";
}

Json limits_json(const StrainLimits& limits, const EdgeStrain& strain) {
  Json list = Json::array();
  for (const StrainLimitKind kind : k_strain_limit_kinds) {
    const double asked = limits.of(kind), reached = figure_of(strain, kind);
    if (asked == 0.0) continue;
    list.push_back({{"kind", to_string(kind)},
                    {"asked", asked},
                    {"kept", reached <= asked},
                    {"reached", reached}});
  }
  return list;
}

/// That of stretch and compression alike; null where they have limits of their own.
Json one_limit_json(const StrainLimits& limits) {
  if (limits.p99 > 0.0) return limits.p99;
  return limits.max > 0.0 ? Json(limits.max) : Json(nullptr);
}

bool is_of_area(StrainLimitKind kind) {
  return to_string(kind).starts_with("p99");
}

std::string kept_words(StrainLimitKind kind, double limit) {
  return is_of_area(kind)
             ? "99 % of the pattern's area is " + verb_of(kind) + " by " + percent(limit) +
                   " at most"
             : "no edge of the pattern is " + verb_of(kind) + " by more than " + percent(limit);
}

std::string missed_words(StrainLimitKind kind, double reached) {
  return is_of_area(kind)
             ? "99 % of the pattern's area is still " + verb_of(kind) + " by up to " +
                   percent(reached)
             : "an edge of the pattern is still " + verb_of(kind) + " by " + percent(reached);
}

std::string joined_by_and(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t k = 0; k < parts.size(); ++k)
    text += (k == 0 ? "" : k + 1 < parts.size() ? ", " : " and ") + parts[k];
  return text;
}

std::string ending_text(const CutSuggestion& suggestion, const SuggestOptions& options) {
  const EdgeStrain& strain = suggestion.last.strain;
  if (suggestion.met()) {
    const std::string how = suggestion.last.pattern.overlaps ? "The limit is met: "
                            : suggestion.cuts.empty()        ? "Met without a cut: "
                                                             : "Met with these cuts: ";
    std::vector<std::string> kept;
    for (const StrainLimitKind kind : k_strain_limit_kinds) {
      if (options.limits.of(kind) > 0.0) kept.push_back(kept_words(kind, options.limits.of(kind)));
    }
    return how + joined_by_and(kept) + ".";
  }
  std::vector<std::string> missed;
  for (const StrainLimitKind kind : k_strain_limit_kinds) {
    const double limit = options.limits.of(kind), reached = figure_of(strain, kind);
    if (limit > 0.0 && reached > limit)
      missed.push_back(missed_words(kind, reached) + ", the limit is " + percent(limit));
  }
  return "Not met: " + joined_by_and(missed) + "; " + why_no_more(suggestion.stop) + ".";
}

/// What to do where the limit is not met or the pattern cannot be cut; empty where all is well.
std::string way_on(const CutSuggestion& suggestion) {
  if (suggestion.last.pattern.overlaps)
    return std::string(suggestion.met() ? "But the" : "The") +
           " pattern overlaps itself: it cannot be cut from one sheet. Divide the patch by cuts of "
           "your own (--cut takes lines drawn over the model).";
  if (suggestion.met()) return {};
  std::string more = suggestion.stop == SuggestStop::dart_limit ? "allow more darts (--max-cuts)"
                                                                : "draw cuts of your own (--cut)";
  if (suggestion.divide_at) {
    more = "divide the patch by a line of your own through vertex " +
           std::to_string(*suggestion.divide_at) + ", near " +
           place_text(suggestion.last.cut.mesh.positions[*suggestion.divide_at]) +
           " (--cut takes lists of vertices and lines drawn over the model)";
  }
  return "You can " + more +
         ", take a material that stretches more, or let \"planish flatten\" change the form "
         "within the limit, with these cuts or without.";
}

/// {vertex, at}, or null.
Json place_json(const CutSuggestion& suggestion) {
  if (!suggestion.divide_at) return nullptr;
  return {{"vertex", *suggestion.divide_at},
          {"at", suggestion.last.cut.mesh.positions[*suggestion.divide_at]}};
}

}  // namespace

std::string suggestion_text(const CutSuggestion& suggestion, const SuggestOptions& options,
                            Unit unit) {
  std::string text;
  if (!suggestion.cuts.empty()) {
    text += "Cuts, with the largest strain of an edge of the pattern before and after:\n";
  }
  for (std::size_t k = 0; k < suggestion.cuts.size(); ++k) {
    text += "  " + std::to_string(k + 1) + "  " +
            wrapped(cut_text(suggestion.cuts[k], std::string(to_string(unit))), 5) + "\n";
  }
  if (!suggestion.cuts.empty()) text += "\n";
  text += wrapped(ending_text(suggestion, options), 0) + "\n";
  const std::string way = way_on(suggestion);
  if (!way.empty()) text += wrapped(way, 0) + "\n";
  return text;
}

std::string suggestion_json(const CutSuggestion& suggestion, const SuggestOptions& options,
                            Unit unit, const std::map<std::string, std::string>& files) {
  Json cuts = Json::array();
  for (const SuggestedCut& cut : suggestion.cuts) {
    cuts.push_back({{"kind", cut.is_dart ? "dart" : "seam"},
                    {"vertices", cut.path},
                    {"length", cut.length},
                    {"strain_before", cut.before},
                    {"strain_after", cut.after}});
  }
  const Json object = {{"version", k_version},
                       {"unit", to_string(unit)},
                       {"max_strain", one_limit_json(options.limits)},
                       {"limit_of_area", options.limits.p99 > 0.0},
                       {"limits", limits_json(options.limits, suggestion.last.strain)},
                       {"met", suggestion.met()},
                       {"stop", to_string(suggestion.stop)},
                       {"divide_at", place_json(suggestion)},
                       {"cuts", std::move(cuts)},
                       {"edges", suggestion.last.cut.edges},
                       {"length", suggestion.last.cut.length},
                       {"strain_before", suggestion.first.strain},
                       {"strain", suggestion.last.strain},
                       {"overlaps", suggestion.last.pattern.overlaps},
                       {"cautions", to_json(suggestion.cautions, unit)},
                       {"files", Json(files)}};
  return json_document(object) + "\n";
}

std::string suggestion_file(const CutSuggestion& suggestion, Unit unit) {
  std::string text = "# Cuts for planish --cut: vertices from 0, a cut a line\n";
  for (const SuggestedCut& cut : suggestion.cuts) {
    text += "# " + cut_text(cut, std::string(to_string(unit))) + "\n" +
            format_cuts(std::span(&cut.path, 1));
  }
  return text;
}

}  // namespace planish::cli
