#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <planish/io/read_mesh.h>

namespace planish {

/// What the comments before the first vertex of a file say of its unit of length.
struct UnitFinding {
  std::optional<StatedUnit> unit = {};  ///< that all of them agree on
  std::vector<std::string> notes = {};  ///< what is not used, with the flags that say it
};

/// Looks for it: in the comments of OBJ and OFF, in comment and obj_info of PLY, in the first line
/// or the header of STL. unit_said_by() tells which comments count. Looks at a fixed number of
/// bytes at most.
UnitFinding find_unit(std::string_view bytes, MeshFormat format);

}  // namespace planish
