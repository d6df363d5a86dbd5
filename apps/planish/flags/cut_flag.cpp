#include "flags/cut_flag.h"

#include <utility>

#include <planish/io/read_features.h>

#include "flags/scale_flag.h"
#include "flags/units.h"
#include "platform/path.h"
#include "shell/failures.h"
#include "shell/session.h"
#include "shell/text.h"
#include "text/lengths.h"

namespace planish::cli {

Flag cut_flag() {
  return {"--cut", "FILE",
          "cut the patch open first: a cut a line by its vertices from 0, or an .obj whose lines "
          "are snapped to the mesh"};
}

CutInput cut_as_asked(TriMesh mesh, const std::string& path, const Arguments& arguments,
                      Session& session) {
  if (!arguments.has("--cut")) return {std::move(mesh)};
  const std::string& file = arguments.flags.at("--cut");
  return about(path, [&]() -> CutInput {
    const CutLines lines = read_cuts(path_of(file), as_in_file(mesh, arguments));
    CutMesh cut = cut_open(Patch(mesh), lines.paths);
    const ShownLengths lengths(unit_from(arguments));
    std::string text =
        file + ": cut open along " + counted(cut.edges, "edge") + ", " + lengths.text(cut.length);
    if (lines.farthest > 0.0) {
      text += "; what is drawn is at most " + lengths.text(scale_from(arguments) * lines.farthest) +
              " from the vertices that stand for it, and between them the cut follows edges";
    }
    session.note(text);
    return {std::move(cut.mesh), CutOutcome{cut.edges, cut.length}};
  });
}

std::vector<MoreFigures> figures_of_cut(const std::optional<CutOutcome>& cut) {
  if (!cut) return {};
  return {{"cut", {{"edges", cut->edges}, {"length", cut->length}}}};
}

}  // namespace planish::cli
