#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <planish/flatten/flatten.h>

namespace planish {

/// How much the pattern is stretched, for everything that says so: headline, ticks and marks.
enum class Flatness {
  flat,          ///< every length is kept to within 0.1 %
  not_known,     ///< without limits or flat, of a mesh that cannot show it: unjudged_by()
  limit_kept,    ///< stretched, within all limits of strain that were given
  limit_missed,  ///< not within some limit of strain that was given
  unmeasurable,  ///< no limit was given, and the rms strain is too small to measure
  stretched      ///< no limit was given, and the pattern is stretched more than that
};

Flatness flatness_of(const FlattenReport& report);

/// The rms is that of the usual end of auto, or less: no material shows it.
bool is_too_small_to_measure(const EdgeStrain& strain);

/// "the 10 % that neoprene takes" where the limit is that of a material that was named, else "the
/// limit of 2.0 %". The area that the limit is for is named where an edge of the pattern is beyond
/// it. Plain UTF-8 text.
/// @param check of strain
std::string strain_limit_name(const LimitCheck& check, const FlattenReport& report);

/// "Needs a sheet that takes 8.2 %: neoprene (10 %) does, cotton (5.0 %) does not", of the known
/// materials the stiffest one that takes it and the one before. Plain UTF-8 text.
std::string sheet_needed_text(const EdgeStrain& strain);

/// The largest |strain|: "5.7 %", or where the sheet is pressed together there "5.7 %
/// (compression)". Plain UTF-8 text.
std::string largest_strain_text(const EdgeStrain& strain);

/// Why it cannot be judged whether the surface lies flat, in a few words: "no vertex inside". Empty
/// where it can.
std::string not_judged_text(const FlattenReport& report);

/// What came out, in plain words: whether the pattern can be cut, how much it is stretched, and
/// what became of the form. Plain UTF-8 text; its first sentence is short.
std::string verdict_text(const FlattenReport& report);

/// What the sweeps did to energy and strain, in the terms of the paper. Plain UTF-8 text.
std::string computed_text(const FlattenReport& report);

/// "smooth", or what is not: "folded" in one place, "rippled", "crumpled" where it is much.
std::string_view smoothness_word(const Fairness& fairness);

/// Why Fairness::keeps_form() is false: "height 25 % of the design's". Empty where it is true.
std::string form_loss_text(const Fairness& fairness);

/// Whether the longer side of the pattern is below 5 mm: too small for a real piece, so that the
/// unit is probably wrong.
bool is_absurdly_small(const UnfoldReport& unfold);

/// What the mesh cannot show, sentence by sentence; empty where it shows all.
std::string cautions_text(std::span<const Caution> cautions, Unit unit);

/// Asks about the unit where a pattern of that size is unlikely, and names a likelier one: mesh
/// files do not say their unit, and a wrong guess is common and costly. Empty elsewhere.
std::string unit_question(const UnfoldReport& unfold);

/// That the border of the design is too short for its surface, by how much and what to do
/// about it: one sentence, plain UTF-8 text. Empty where little area is at stake.
std::string border_text(const FlattenReport& report);

/// What is wrong with the form, after "the form": "is crumpled and lost"; empty where nothing is.
std::string form_faults(const EvolveReport& evolve);

}  // namespace planish
