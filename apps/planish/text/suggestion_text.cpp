#include "text/suggestion_text.h"

#include <optional>

#include <planish/core/version.h>
#include <planish/io/read_features.h>

#include <planish_json/json.h>

#include "flatten/strain_limit_text.h"
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
std::string verb_of(Criterion what) {
  const std::string_view part = bounded_part(what);
  return part == "compression" ? "compressed" : std::string(part) + "ed";
}

Json limits_json(const std::vector<LimitCheck>& checks) {
  Json list = checks;
  for (Json& check : list) {
    check.erase("share_beyond");
    check.erase("where");
  }
  return list;
}

/// That of stretch and compression alike; null where they have limits of their own.
Json one_limit_json(const StrainLimits& limits) {
  if (limits.p99 > 0.0) return limits.p99;
  return limits.max > 0.0 ? Json(limits.max) : Json(nullptr);
}

std::string kept_words(const LimitCheck& check) {
  return is_of_area(check.what) ? "99 % of the pattern's area is " + verb_of(check.what) + " by " +
                                      percent(check.limit) + " at most"
                                : "no edge of the pattern is " + verb_of(check.what) +
                                      " by more than " + percent(check.limit);
}

std::string missed_words(const LimitCheck& check) {
  return (is_of_area(check.what)
              ? "99 % of the pattern's area is still " + verb_of(check.what) + " by up to "
              : "an edge of the pattern is still " + verb_of(check.what) + " by ") +
         percent(check.value) + ", the limit is " + percent(check.limit);
}

std::string joined_by_and(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t k = 0; k < parts.size(); ++k)
    text += (k == 0 ? "" : k + 1 < parts.size() ? ", " : " and ") + parts[k];
  return text;
}

std::string ending_text(const CutSuggestion& suggestion, const SuggestOptions& options) {
  std::vector<std::string> kept, missed;
  for (const LimitCheck& check : check_limits(suggestion.last.strain, options.limits)) {
    kept.push_back(kept_words(check));
    if (!check.met) missed.push_back(missed_words(check));
  }
  if (!suggestion.met())
    return "Not met: " + joined_by_and(missed) + "; " + why_no_more(suggestion.stop) + ".";
  const std::string how = suggestion.last.pattern.overlaps ? "The limit is met: "
                          : suggestion.cuts.empty()        ? "Met without a cut: "
                                                           : "Met with these cuts: ";
  return how + joined_by_and(kept) + ".";
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
  const Json object = {
      {"version", k_version},
      {"unit", to_string(unit)},
      {"max_strain", one_limit_json(options.limits)},
      {"limit_of_area", options.limits.p99 > 0.0},
      {"limits", limits_json(check_limits(suggestion.last.strain, options.limits))},
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
