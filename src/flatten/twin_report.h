#pragma once

#include <optional>
#include <span>
#include <string>

#include <planish/flatten/flatten.h>

#include "mesh/match/twins.h"

namespace planish {

/// The report of a patch made from that of its twin (find_twins()), without evolving and unfolding
/// again. The pattern is the same with the other sign of every x where the patch is mirrored, to
/// the bit: then its lower right corner is at the origin. Vertices move as those of the twin do,
/// turned by the match's motion; those that do not move there stay where they are, to the bit.
/// Figures are measured on this patch and its pattern; iterations, history and the reason to stop
/// are the twin's, and no time is counted. A limit of strain that the twin keeps, and this patch
/// misses by less than 1 % of it, counts as kept with what the twin reached: that is the rounding
/// of a file.
///
/// Nothing where the patch would have less than its twin: a limit (of strain, deviation, angles,
/// the target of e_max) or flattenability that the twin keeps and this patch misses, by rounding;
/// with match_seams, a stretch of the border whose length in the pattern differs from that on the
/// patch by more than 1e-5 of the whole border; with remesh, a vertex of options.keep that the twin
/// has not. It is to be flattened by itself then.
/// @param patch the input, before smoothing and remeshing
/// @param match from the twin's input mesh
/// @param options that the twin was flattened with, and the vertices to keep of this patch
std::optional<FlattenReport> twin_report(const FlattenReport& twin, const Patch& patch,
                                         const MeshMatch& match, std::string name,
                                         const FlattenOptions& options);

/// The largest difference between a stretch of the border on the patch and in its pattern, model
/// units: of all stretches of each loop without free edges.
/// @param pattern one position per vertex
/// @param free_edges as UnfoldOptions has them
double border_mismatch(const Patch& patch, std::span<const Vec2> pattern,
                       std::span<const std::array<Index, 2>> free_edges = {});

/// In words: "mirror image of left_sleeve", or "equal to front-1".
std::string twin_text(const TwinOf& twin);

}  // namespace planish
