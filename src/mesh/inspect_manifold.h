#pragma once

#include <planish/mesh/inspect.h>
#include <planish/mesh/patch.h>

namespace planish {

/// Sizes, and problems of single numbers: with these nothing else can be looked for.
Inspection inspect_entries(const TriMesh& mesh);

/// What inspect() finds in a mesh whose connectivity is known.
Inspection inspect_manifold(const TriMesh& mesh, const Connectivity& connectivity);

/// The same for a mesh of which only positions differ from one that was inspected: looks at
/// positions alone, unless a position was not finite there.
Inspection inspect_moved(const Inspection& inspected, const TriMesh& mesh,
                         const Connectivity& connectivity);

}  // namespace planish
