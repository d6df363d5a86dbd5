#include "cut/caps.h"

#include <utility>

#include <planish/mesh/repair.h>

#include "flags/scale_flag.h"
#include "flags/units.h"
#include "shell/session.h"
#include "shell/text.h"
#include "text/lengths.h"

namespace planish::cli {

TriMesh without_caps(TriMesh mesh, const Arguments& arguments, Session& session) {
  constexpr double k_cap = 5e-6;  // of the diagonal
  const double height = k_cap * bounding_box_diagonal(mesh);
  FlippedMesh flipped = flip_caps(mesh, height);
  if (flipped.flipped == 0) return mesh;
  session.note(counted(flipped.flipped, "triangle") +
               " nearly without area: flipped at the long side; the surface moves by less than " +
               ShownLengths(unit_from(arguments)).text(scale_from(arguments) * height));
  return std::move(flipped.mesh);
}

}  // namespace planish::cli
