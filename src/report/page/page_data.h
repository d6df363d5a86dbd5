#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <planish/core/unit.h>
#include <planish/mesh/patch.h>
#include <planish/unfold/strain.h>

#include "sheet/limit_map.h"

namespace planish {

/// A form of the patch that a page can show.
struct PageState {
  std::string name;  ///< plain text
  Patch patch;
  std::span<const Vec2> pattern = {};  ///< of all vertices, model units; may be none
};

/// What goes into a page for its script.
struct PageInput {
  std::vector<PageState> states;  ///< of one topology; the first is the input patch
  Unit unit = Unit::mm;
  double defect_limit = 0.0;           ///< |defect| at which colours end, radians
  double strain_limit = 0.001;         ///< |strain| at which colours end
  std::span<const Index> source = {};  ///< vertex of the patch -> number that people know it by
  /// Of all vertices in the drawing of the pattern, in its own coordinates; may be none.
  std::span<const Vec2> drawn = {};
  /// The limit that edges have; with one the page shows how much of it they use up, and the
  /// principal stretches.
  std::optional<MapLimit> limit = {};
  std::size_t shown = 1;  ///< the state that is shown beside the first at the start
  /// Meshes with more are simplified; 0: the number whose data take about four and a half
  /// megabytes, which are some 42,000 for two states.
  std::size_t most_vertices = 0;

  const Patch& patch() const { return states.front().patch; }
};

/// The data of a page as JSON in a <script> element that is never run: positions of 16 bits a
/// coordinate, figures of 32 bits, packed; docs/report.md has the format. No text in it can end the
/// element.
std::string page_data(const PageInput& input);

/// JSON as it may stand inside of a <script> element: every "<" as its escape.
std::string json_for_script(std::string json);

}  // namespace planish
