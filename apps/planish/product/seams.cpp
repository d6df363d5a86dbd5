#include "product/seams.h"

#include <utility>

#include <planish/mesh/inspect.h>
#include <planish/mesh/patch.h>
#include <planish/pattern/notches.h>
#include <planish/pattern/read_annotations.h>

#include "flags/quantities.h"
#include "flags/units.h"
#include "platform/path.h"
#include "shell/failures.h"

namespace planish::cli {

namespace {

double tolerance_from(const Arguments& arguments) {
  if (!arguments.has("--seam-tolerance")) return 0.0;
  return quantity_value("--seam-tolerance", arguments.flags.at("--seam-tolerance"),
                        Quantity::length, {.min = 0.0}, arguments);
}

}  // namespace

std::vector<Seam> seams_from(const Arguments& arguments, std::span<const TriMesh> meshes) {
  std::vector<std::size_t> numbers;
  std::vector<TriMesh> sound;
  numbers.reserve(meshes.size());
  sound.reserve(meshes.size());
  for (std::size_t p = 0; p < meshes.size(); ++p) {
    if (blocking_problem(inspect(meshes[p]), Purpose::measure)) continue;
    numbers.push_back(p);
    sound.push_back(meshes[p]);
  }
  std::vector<Seam> seams = find_seams(sound, tolerance_from(arguments));
  for (Seam& seam : seams) {
    for (SeamSide& side : seam.sides)
      side.patch = numbers[side.patch];
  }
  return seams;
}

std::vector<std::vector<Notch>> seam_notches_from(const Arguments& arguments,
                                                  std::span<const TriMesh> meshes,
                                                  std::span<const std::string> names) {
  if (!arguments.has("--seam-notches")) return std::vector<std::vector<Notch>>(meshes.size());
  const std::string& path = arguments.flags.at("--seam-notches");
  const std::vector<SeamNotch> notches = read_seam_notches(path_of(path));
  return about(path, [&] {
    return notches_of_patches(notches, seams_from(arguments, meshes), meshes, names,
                              millimetres_per(unit_from(arguments)));
  });
}

PatternOptions annotations_on(PatternOptions annotations, const Arguments& arguments,
                              const Patch& patch, const std::string& name) {
  const bool seams = arguments.has("--seam-notches");
  if (named_vertices(annotations).empty() && annotations.notches.empty() && !seams)
    return annotations;
  check_pattern_options(annotations, patch.vertex_count(), patch.border_loops(), name);
  const std::vector<std::vector<Notch>> on_seams =
      seam_notches_from(arguments, {&patch.mesh(), 1}, {&name, 1});
  annotations.notches.insert(annotations.notches.end(), on_seams.front().begin(),
                             on_seams.front().end());
  return annotations;
}

}  // namespace planish::cli
