#pragma once

// Files that are wrong or odd, made from a sound patch: each kind of fault in each format that can
// have it, at several positions, with what is promised of it.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <planish/core/error.h>
#include <planish/mesh/inspect.h>
#include <planish/mesh/tri_mesh.h>

namespace planish::bad {

enum class Verdict {
  same,    ///< odd, but the sound patch: same sizes, same figures
  accept,  ///< processed by every verb
  refuse,  ///< by the verbs that need what is missing
  either,  ///< processed or refused; never a crash, a NaN or an output of half a run
};

struct BadMesh {
  std::string name;       ///< letters, digits and underscores
  std::string extension;  ///< with the point
  std::string bytes;
  Verdict verdict = Verdict::same;

  // Of what is refused: the code, from which step on, and the place. Of others, the code of a
  // problem that is told, if any.
  std::optional<ErrorCode> code = {};
  bool unreadable = false;  ///< refused by the reader, and so by every verb
  Purpose blocks = Purpose::measure;
  std::optional<std::size_t> line = {}, byte = {}, first = {};
  std::string part = {};  ///< of the message or a note
};

using BadMeshes = std::vector<BadMesh>;

// One function a source file.
BadMeshes bad_numbers();    ///< words that are no numbers, and numbers in other notations
BadMeshes bad_indices();    ///< words that name no vertex
BadMeshes bad_encodings();  ///< line ends, byte order marks, archives, other kinds of file
BadMeshes bad_obj();
BadMeshes bad_ply();
BadMeshes bad_off();
BadMeshes bad_stl();
BadMeshes bad_topology();
BadMeshes bad_geometry();

/// All of them.
BadMeshes bad_meshes();

}  // namespace planish::bad
