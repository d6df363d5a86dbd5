#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include <planish/core/context.h>
#include <planish/mesh/carry.h>

#include "mesh/geodesic/sleeve.h"
#include "mesh/geodesic/unfolded_mesh.h"

namespace planish {

/// Finds the triangles of a shortest path: windows (parts of edges that are seen in a straight line
/// from the start or from a vertex that paths bend at) are propagated over the triangles, those
/// first that can be on the shortest path (Chen and Han 1990, Xin and Wang 2009, ordered as in A*).
class WindowSearch {
 public:
  /// @param at_most length of a path that is known, at the scale of the mesh; nothing longer is
  ///   looked at
  WindowSearch(const UnfoldedMesh& mesh, const SurfacePoint& from, const SurfacePoint& to,
               double at_most);

  /// Those of a path that is not longer than the known one; `known` if there is none other.
  Sleeve run(const Sleeve& known, const Context& context);

 private:
  static constexpr Index none = HalfEdges::none;
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  /// A window as paths are found back through it: kept while something refers to it.
  struct Trace {
    Index edge;    ///< the window is seen across it into its triangle
    Index root;    ///< the vertex that it is seen from; none: the start
    Index parent;  ///< trace of the window that it is seen through; none: it is the first
    Index users;   ///< windows, traces, vertices and the goal that refer to it
  };

  /// A part of an edge that is seen in a straight line: kept while it is in the queue.
  struct Window {
    Index edge;
    Index trace;
    double begin, end;  ///< on the edge, from its first vertex
    Vec2 source;        ///< where it is seen from, in the frame of the edge
    double before;      ///< distance of that from the start
  };

  /// The shortest path to a vertex that is known so far: its length and its last part.
  struct Arrival {
    double distance = infinite;
    double passed_on = infinite;  ///< the distance when windows from it were made last
    Index trace = none;   ///< of the window it comes through; none: along an edge or directly
    Index root = none;    ///< from this vertex; none: from the start
    Index corner = none;  ///< half-edge from the vertex in the triangle it comes through
    double turn = 0.0;    ///< from that half-edge to the path, counter-clockwise
  };

  struct Entry {
    double bound;  ///< no path to the goal through it is shorter
    Index item;
    bool is_vertex;

    bool operator<(const Entry& other) const {  // of a queue with its largest on top
      if (bound != other.bound) return bound > other.bound;
      return is_vertex != other.is_vertex ? is_vertex : item > other.item;
    }
  };

  /// The nearest window that sees the third vertex through an edge, and where.
  struct Split {
    double distance = infinite;
    double at = 0.0;
  };

  struct Goal {
    double distance = infinite;
    Index trace = none;  ///< of the window it is seen through, else from the vertex
    Index vertex = none;
    Index triangle = none;
  };

  void start();
  void arrive(Index v, const Arrival& arrival);
  void reach_goal(const Goal& goal);
  bool may_bend(Index v);
  void push(Entry entry);
  void add(Window window, Index root, Index parent);
  void release(Index trace);
  double bound_of(const Window& window) const;
  bool is_beaten(const Window& window) const;
  void pass_on_vertex(Index v);
  void add_seen(Index corner, double low, double high, double before, Index root);
  void pass_on_window(const Window& window);
  void add_children(const Window& window, double of_left, double of_right, bool left, bool right);
  Sleeve found() const;

  const UnfoldedMesh& mesh_;
  const HalfEdges& half_edges_;
  SurfacePoint from_, to_;
  Vec3 goal_place_;
  std::vector<Index> goal_triangles_;
  Goal goal_;
  std::vector<Window> windows_;
  std::vector<Trace> traces_;
  std::vector<Index> unused_windows_, unused_traces_;  ///< that may be overwritten
  std::vector<Arrival> arrivals_;
  std::vector<double> angles_;  ///< around each vertex; negative where not yet known
  std::vector<Split> splits_;   ///< by half-edge
  std::vector<Entry> queue_;
};

}  // namespace planish
