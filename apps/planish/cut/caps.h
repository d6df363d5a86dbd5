#pragma once

#include <planish/mesh/tri_mesh.h>

#include "shell/command.h"

namespace planish::cli {

/// The mesh without triangles that are lower than 5e-6 of the diagonal, at which lines cannot be
/// apart: where a line crosses such a cap, it meets two edges at one place, and its pieces get
/// edges without a direction. A note counts them.
TriMesh without_caps(TriMesh mesh, const Arguments& arguments, Session& session);

}  // namespace planish::cli
