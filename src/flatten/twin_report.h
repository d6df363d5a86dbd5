#pragma once

#include <optional>
#include <string>

#include <planish/flatten/flatten.h>

#include "mesh/match/twins.h"

namespace planish {

/// The report of a patch as an instance of the one that it is a twin of (find_twins()). The pattern
/// is the same, with the other sign of every x where the patch is mirrored, to the bit: then its
/// lower right corner is at the origin. Vertices move as those of the other one do, turned by the
/// match's motion; those that do not move there stay where they are, to the bit. Figures are those
/// of the other one, places and numbers of vertices and triangles brought to this patch; extent and
/// problems are its own, and no time is counted.
///
/// Nothing where the other one was remeshed without a vertex that options.keep has: this patch is
/// to be flattened by itself then.
/// @param patch the input, before smoothing and remeshing
/// @param match from the other one's input mesh
/// @param options the vertices to keep of this patch, and its material
std::optional<FlattenReport> twin_report(const FlattenReport& other, const Patch& patch,
                                         const MeshMatch& match, std::string name,
                                         const FlattenOptions& options);

/// In words: "mirror image of left_sleeve", or "equal to front-1".
std::string twin_text(const TwinOf& twin);

}  // namespace planish
