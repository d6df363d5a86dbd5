#include "product/seams.h"

#include <planish/flatten/product.h>
#include <planish/pattern/notches.h>
#include <planish/pattern/read_annotations.h>

#include "flags/quantities.h"
#include "flags/units.h"
#include "platform/path.h"
#include "shell/failures.h"

namespace planish::cli {

double seam_tolerance_from(const Arguments& arguments) {
  if (!arguments.has("--seam-tolerance")) return 0.0;
  return quantity_value("--seam-tolerance", arguments.flags.at("--seam-tolerance"),
                        Quantity::length, {.min = 0.0}, arguments);
}

std::vector<SeamNotch> seam_notches_from(const Arguments& arguments) {
  if (!arguments.has("--seam-notches")) return {};
  return read_seam_notches(path_of(arguments.flags.at("--seam-notches")));
}

std::vector<std::vector<Notch>> notches_on_seams(const Arguments& arguments,
                                                 std::span<const TriMesh> meshes,
                                                 std::span<const std::string> names) {
  if (!arguments.has("--seam-notches")) return std::vector<std::vector<Notch>>(meshes.size());
  const std::vector<SeamNotch> notches = seam_notches_from(arguments);
  return about(arguments.flags.at("--seam-notches"), [&] {
    return notches_of_patches(notches, find_sound_seams(meshes, seam_tolerance_from(arguments)),
                              meshes, names, millimetres_per(unit_from(arguments)));
  });
}

PatternOptions annotations_on(PatternOptions annotations, const Arguments& arguments,
                              const Patch& patch, const std::string& name) {
  const bool seams = arguments.has("--seam-notches");
  if (named_vertices(annotations).empty() && annotations.notches.empty() && !seams)
    return annotations;
  check_pattern_options(annotations, patch.vertex_count(), patch.border_loops(), name);
  const std::vector<std::vector<Notch>> on_seams =
      notches_on_seams(arguments, {&patch.mesh(), 1}, {&name, 1});
  annotations.notches.insert(annotations.notches.end(), on_seams.front().begin(),
                             on_seams.front().end());
  return annotations;
}

}  // namespace planish::cli
