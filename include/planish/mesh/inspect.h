#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <planish/core/error.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// One kind of fault or oddity of a mesh, with how often it occurs and where first.
struct Problem {
  ErrorCode code;         ///< its kind
  std::string message;    ///< names the first element and says what to do
  std::size_t count = 0;  ///< how many elements have it
  std::size_t first = 0;  ///< vertex or triangle number, from 0, as the message says
};

/// Sizes and topology, without unreferenced vertices from components on. inner_vertices,
/// border_loops and genus are 0 where the mesh is not an oriented manifold.
struct Topology {
  std::size_t vertices = 0, triangles = 0, inner_vertices = 0, edges = 0;  ///< how many there are
  std::size_t components = 0, border_loops = 0, genus = 0;  ///< how many; genus: handles
  long long euler_characteristic = 0;                       ///< vertices - edges + triangles
};

/// What inspect() finds.
struct Inspection {
  Topology topology;              ///< sizes and connectedness
  std::vector<Problem> problems;  ///< what blocks measuring first; one of each code at most
};

/// Finds every defect by kind; of a mesh with coordinates or indices that cannot be used, these
/// only. Never throws for what the mesh holds. O((n + m) log m).
Inspection inspect(const TriMesh& mesh);

/// What a mesh is wanted for; each asks for all that the one before it asks for.
enum class Purpose {
  measure,  ///< finite, manifold, consistently oriented, no edge of length zero
  evolve,   ///< and with a border, as something must hold the surface
  unfold,   ///< and a topological disk, perhaps with holes: one component, no handle, no tube
};

/// The first problem that stands in the way of the purpose, if any does.
std::optional<Problem> blocking_problem(const Inspection& inspection, Purpose purpose);

/// @throws Error with the code, message, first element and count of blocking_problem(), if any.
void require(const Inspection& inspection, Purpose purpose);

}  // namespace planish
