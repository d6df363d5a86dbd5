#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <planish/mesh/imprint.h>

#include "mesh/imprint/constrained_delaunay.h"
#include "mesh/imprint/line_nodes.h"
#include "mesh/imprint/thin_parts.h"

namespace planish {

namespace {

constexpr double k_straight = 1e-6;  // of the diagonal: how far a point is off that is left out
// Of the diagonal: how near to a line what it does not meet may be.
constexpr double k_finest = 5e-6;
constexpr int k_rounds = 12;  // of making angles larger

/// A triangle that is divided.
struct Face {
  ConstrainedDelaunay inside;
  std::vector<Index> nodes = {};    ///< of its own numbers
  std::map<Index, Index> own = {};  ///< node -> its own number
};

/// A straight part of a line; of one that is a single node, that node.
struct Segment {
  Index from, to;
  LineNodes::Way way;
};

class Imprinter {
 public:
  Imprinter(const Patch& patch, const ImprintOptions& options)
      : patch_(patch),
        options_(options),
        nodes_(patch, options),
        finest_(std::min(k_finest, options.farthest_snap) *
                bounding_box_diagonal(nodes_.scaled())) {}

  ImprintedMesh imprint(std::span<const SurfaceLine> lines) {
    for (const SurfaceLine& line : lines)
      lines_.push_back(segments_of(line));
    for (const auto& line : lines_) {
      for (const Segment& segment : line) {
        touch(segment.from);
        touch(segment.to);
      }
    }
    for (const auto& line : lines_) {
      for (const Segment& segment : line) {
        if (segment.way.on == LineNodes::On::face) connect(segment);
      }
    }
    if (options_.least_angle > 0.0) widen_angles();
    return result();
  }

 private:
  /// A node of a line, and the points of the line that it stands for.
  struct Stop {
    Index node;
    std::vector<Vec3> drawn;
  };
  std::vector<Segment> segments_of(const SurfaceLine& line);
  std::vector<Stop> chain_of(const SurfaceLine& line);
  LineNodes::Way way_of(Index from, Index to) const;
  std::vector<SurfacePoint> few_points(const SurfaceLine& line) const;
  void connect(const Segment& segment);
  void touch(Index node);
  Face& face(Index triangle);
  Index own_number(Index triangle, Index node);
  void learn_nodes(Index triangle);

  void widen_angles();
  bool widen(Index triangle, const WidenedBy& by);
  bool divide_edge(Index half, Index from, Index to, double share);
  std::optional<Index> outer_side(const Face& face, Index triangle, Index a, Index b) const;

  ImprintedMesh result() const;
  std::vector<Index> numbers() const;
  std::vector<Index> path_of(const std::vector<Segment>& line) const;

  const Patch& patch_;
  ImprintOptions options_;
  LineNodes nodes_;
  double finest_;
  std::vector<std::vector<Segment>> lines_;
  std::map<Index, Face> faces_;
};

[[noreturn]] void refuse(std::size_t number, const std::string& message) {
  throw Error(ErrorCode::misplaced_cut, "line " + std::to_string(number + 1) + ": " + message,
              {.path = {}, .first = number});
}

bool is_inside(const SurfacePoint& p) {
  return std::all_of(p.shares.begin(), p.shares.end(), [](double share) { return share > 0.0; });
}

/// Whether the place is on the triangle with these corners.
bool is_on(const SurfacePoint& p, const Triangle& corners) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (p.shares[k] > 0.0 &&
        std::find(corners.begin(), corners.end(), p.corners[k]) == corners.end())
      return false;
  }
  return true;
}

/// Beside a straight piece: how far along it, 0 to 1, and how far away.
struct Beside {
  double share, apart;
};

Beside beside(Vec3 p, Vec3 from, Vec3 to) {
  const Vec3 along = to - from, way = p - from;
  const double length = dot(along, along);
  const double share = length > 0.0 ? std::clamp(dot(way, along) / length, 0.0, 1.0) : 0.0;
  return {share, norm(way - share * along)};
}

/// The point between two that is farthest from the straight way, or where the line turns back on
/// it; nothing where neither is more than `most`.
std::optional<std::size_t> bend_between(std::span<const Vec3> line, std::size_t first,
                                        std::size_t last, double most) {
  std::optional<std::size_t> bend;
  double farthest = most, along = 0.0;
  std::size_t foremost = first;
  const double length = norm(line[last] - line[first]);
  for (std::size_t i = first + 1; i < last; ++i) {
    const Beside at = beside(line[i], line[first], line[last]);
    if (at.apart > farthest) farthest = at.apart, bend = i;
    if (at.share * length < along - most && !bend) bend = foremost;
    if (at.share * length > along) along = at.share * length, foremost = i;
  }
  return bend;
}

/// Of points inside one triangle only those that a straight line would miss (Douglas and Peucker).
std::vector<SurfacePoint> Imprinter::few_points(const SurfaceLine& points) const {
  const double most = k_straight * bounding_box_diagonal(nodes_.scaled());
  std::vector<Vec3> places;
  places.reserve(points.size());
  for (const SurfacePoint& point : points)
    places.push_back(position_of(point, nodes_.scaled().positions));
  std::vector<unsigned char> kept(points.size(), 1);
  const auto thin = [&](std::size_t first, std::size_t last) {
    std::vector<std::array<std::size_t, 2>> open = {{first, last}};
    while (!open.empty()) {
      const auto [a, b] = open.back();
      open.pop_back();
      if (const auto bend = bend_between(places, a, b, most)) {
        open.push_back({a, *bend});
        open.push_back({*bend, b});
      } else {
        std::fill(kept.begin() + static_cast<std::ptrdiff_t>(a) + 1,
                  kept.begin() + static_cast<std::ptrdiff_t>(b), 0);
      }
    }
  };
  for (std::size_t begin = 0; begin + 1 < points.size(); ++begin) {
    const Triangle& corners = points[begin + 1].corners;
    if (!is_inside(points[begin + 1]) || !is_on(points[begin], corners)) continue;
    std::size_t end = begin + 1;
    while (end + 1 < points.size() && is_inside(points[end]) && is_on(points[end + 1], corners))
      ++end;
    thin(begin, end);
    begin = end - 1;
  }
  std::vector<SurfacePoint> few;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (kept[i] != 0) few.push_back(points[i]);
  }
  return few;
}

/// The nodes of a line, each other than the one before.
std::vector<Imprinter::Stop> Imprinter::chain_of(const SurfaceLine& line) {
  for (const SurfacePoint& point : line) {
    if (std::any_of(point.corners.begin(), point.corners.end(),
                    [&](Index v) { return v >= nodes_.vertex_count(); }))
      refuse(lines_.size(), "it names a vertex that the mesh does not have");
  }
  std::vector<Stop> chain;
  for (const SurfacePoint& point : few_points(line)) {
    const auto node = nodes_.add(point);
    if (!node) refuse(lines_.size(), "a point of it is on no triangle of the mesh");
    if (chain.empty() || chain.back().node != *node) chain.push_back({*node, {}});
    chain.back().drawn.push_back(position_of(point, nodes_.scaled().positions));
  }
  return chain;
}

LineNodes::Way Imprinter::way_of(Index from, Index to) const {
  const auto way = nodes_.way(from, to);
  if (!way)
    refuse(lines_.size(), "two points of it that follow each other are on no triangle together");
  return *way;
}

/// Where a point was put onto a vertex, the line takes the short way past points beside it that it
/// was drawn no farther from than points are snapped.
std::vector<Segment> Imprinter::segments_of(const SurfaceLine& line) {
  const std::vector<Stop> chain = chain_of(line);
  std::vector<Index> straight;
  std::vector<Vec3> passed;  // since the last of them
  const double most = nodes_.farthest_snap();
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const bool is_between = !straight.empty() && i + 1 < chain.size();
    if (is_between && most > 0.0 && nodes_.node(chain[i].node).on == LineNodes::On::edge) {
      const Index from = straight.back(), to = chain[i + 1].node;
      passed.insert(passed.end(), chain[i].drawn.begin(), chain[i].drawn.end());
      const auto is_beside = [&](Vec3 p) {
        return beside(p, nodes_.position(from), nodes_.position(to)).apart <= most;
      };
      if (std::all_of(passed.begin(), passed.end(), is_beside) && nodes_.way(from, to)) continue;
    }
    passed.clear();
    if (straight.empty() || straight.back() != chain[i].node) straight.push_back(chain[i].node);
  }
  std::vector<Segment> segments;
  if (straight.size() == 1)
    segments.push_back({straight[0], straight[0], {LineNodes::On::vertex, straight[0]}});
  for (std::size_t i = 1; i < straight.size(); ++i) {
    segments.push_back({straight[i - 1], straight[i], way_of(straight[i - 1], straight[i])});
  }
  return segments;
}

Face& Imprinter::face(Index triangle) {
  if (const auto found = faces_.find(triangle); found != faces_.end()) return found->second;
  const Triangle& t = nodes_.scaled().triangles[triangle];
  const auto length = [&](std::size_t k) {
    return norm(nodes_.scaled().positions[t[(k + 1) % 3]] - nodes_.scaled().positions[t[k]]);
  };
  Face face{ConstrainedDelaunay({length(0), length(1), length(2)}, finest_), {t[0], t[1], t[2]}};
  return faces_.emplace(triangle, std::move(face)).first->second;
}

/// The number of a node in a triangle, which gets it where it has not.
Index Imprinter::own_number(Index triangle, Index node) {
  Face& at = face(triangle);
  const Index own = at.inside.add(nodes_.grid_in(triangle, node));
  if (own >= at.nodes.size()) at.nodes.resize(own + 1, node);
  at.own[node] = own;
  return own;
}

/// Gives nodes that are only known to a triangle numbers among all.
void Imprinter::learn_nodes(Index triangle) {
  Face& at = faces_.at(triangle);
  for (std::size_t own = at.nodes.size(); own < at.inside.nodes().size(); ++own)
    at.nodes.push_back(nodes_.new_in_face(triangle, at.inside.nodes()[own]));
}

void Imprinter::connect(const Segment& segment) {
  const Index triangle = segment.way.element;
  const Index a = own_number(triangle, segment.from), b = own_number(triangle, segment.to);
  faces_.at(triangle).inside.connect(a, b);
  learn_nodes(triangle);
}

/// The triangles at a node on an edge are divided on both sides.
void Imprinter::touch(Index node) {
  const LineNodes::Node at = nodes_.node(node);
  if (at.on == LineNodes::On::vertex) return;
  if (at.on == LineNodes::On::face) {
    own_number(at.element, node);
    return;
  }
  own_number(at.element / 3, node);
  const Index twin = nodes_.half_edges().twin(at.element);
  if (twin != HalfEdges::none) own_number(twin / 3, node);
}

/// The half-edge of the triangle that two of its nodes lie on.
std::optional<Index> Imprinter::outer_side(const Face& face, Index triangle, Index a,
                                           Index b) const {
  const Vec2 p = face.inside.nodes()[a], q = face.inside.nodes()[b];
  if (p.y == 0.0 && q.y == 0.0) return 3 * triangle;
  if (p.x + p.y == k_cells && q.x + q.y == k_cells) return 3 * triangle + 1;
  if (p.x == 0.0 && q.x == 0.0) return 3 * triangle + 2;
  return std::nullopt;
}

/// Puts a node onto an edge of the mesh, between two that are there.
/// @return whether it is new
bool Imprinter::divide_edge(Index half, Index from, Index to, double share) {
  const std::vector<Index> nodes = nodes_.along(half, from, to);
  if (nodes.size() != 2) return false;  // another triangle has divided the side already
  const std::size_t before = nodes_.count();
  touch(nodes_.add_between(half, from, to, share));
  return nodes_.count() > before;
}

/// @return whether there is a new node
bool Imprinter::widen(Index triangle, const WidenedBy& by) {
  Face& at = faces_.at(triangle);
  const std::size_t before = at.inside.nodes().size();
  if (by.side) {
    const auto [a, b] = *by.side;
    if (const auto half = outer_side(at, triangle, a, b))
      return divide_edge(*half, at.nodes[a], at.nodes[b], by.share);
    if (!at.inside.is_segment(a, b)) return false;
    const Vec2 from = at.inside.place(a), to = at.inside.place(b);
    if (std::min(by.share, 1.0 - by.share) * norm(to - from) < finest_) return false;
    if (at.inside.distance_to_corner(from + by.share * (to - from)) < finest_) return false;
    at.inside.divide(a, b, by.share);
  } else {
    const Vec2 grid = at.inside.grid_at(by.place);
    const bool is_inside = grid.x > 0.0 && grid.y > 0.0 && grid.x + grid.y < k_cells;
    if (!is_inside || at.inside.distance_to_corner(by.place) < by.reach) return false;
    at.inside.add(grid);
  }
  learn_nodes(triangle);
  return at.inside.nodes().size() > before;
}

void Imprinter::widen_angles() {
  std::set<Index> open;
  for (const auto& [triangle, face] : faces_)
    open.insert(triangle);
  for (int round = 0; round < k_rounds && !open.empty(); ++round) {
    std::vector<std::pair<Index, WidenedBy>> all;
    for (const Index triangle : open) {
      const ConstrainedDelaunay& inside = faces_.at(triangle).inside;
      for (const WidenedBy& by : widening_nodes(inside, options_.least_angle, finest_))
        all.emplace_back(triangle, by);
    }
    open.clear();
    for (const auto& [triangle, by] : all) {
      if (!widen(triangle, by)) continue;
      open.insert(triangle);
      if (!by.side) continue;
      const auto half = outer_side(faces_.at(triangle), triangle, (*by.side)[0], (*by.side)[1]);
      const Index twin = half ? nodes_.half_edges().twin(*half) : HalfEdges::none;
      if (twin != HalfEdges::none) open.insert(twin / 3);
    }
  }
}

std::vector<Index> Imprinter::path_of(const std::vector<Segment>& line) const {
  std::vector<Index> path;
  for (const Segment& segment : line) {
    std::vector<Index> part = {segment.from};
    if (segment.way.on == LineNodes::On::edge) {
      part = nodes_.along(segment.way.element, segment.from, segment.to);
    } else if (segment.way.on == LineNodes::On::face) {
      part.clear();
      const Face& at = faces_.at(segment.way.element);
      for (const Index node : at.inside.path(at.own.at(segment.from), at.own.at(segment.to)))
        part.push_back(at.nodes[node]);
    }
    path.insert(path.end(), part.begin() + (path.empty() ? 0 : 1), part.end());
  }
  return path;
}

/// Of nodes in the result: those that lines were led past get none.
std::vector<Index> Imprinter::numbers() const {
  std::vector<Index> numbers(nodes_.count(), HalfEdges::none);
  std::iota(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(nodes_.vertex_count()),
            Index{0});
  for (const auto& [triangle, face] : faces_) {
    for (const Index node : face.nodes)
      numbers[node] = node;
  }
  auto next = static_cast<Index>(nodes_.vertex_count());
  for (std::size_t node = next; node < numbers.size(); ++node) {
    if (numbers[node] != HalfEdges::none) numbers[node] = next++;
  }
  return numbers;
}

ImprintedMesh Imprinter::result() const {
  ImprintedMesh result;
  const TriMesh& mesh = patch_.mesh();
  const std::vector<Index> number = numbers();
  result.mesh.positions = mesh.positions;
  for (auto node = static_cast<Index>(nodes_.vertex_count()); node < nodes_.count(); ++node) {
    if (number[node] == HalfEdges::none) continue;
    result.new_vertices.push_back(nodes_.place(node));
    result.mesh.positions.push_back(position_of(result.new_vertices.back(), mesh.positions));
  }
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const auto found = faces_.find(t);
    if (found == faces_.end()) {
      result.mesh.triangles.push_back(mesh.triangles[t]);
      result.triangle_of.push_back(t);
      continue;
    }
    for (const Triangle& own : found->second.inside.triangles()) {
      const auto& nodes = found->second.nodes;
      result.mesh.triangles.push_back(
          {number[nodes[own[0]]], number[nodes[own[1]]], number[nodes[own[2]]]});
      result.triangle_of.push_back(t);
    }
  }
  for (const auto& line : lines_) {
    std::vector<Index>& path = result.paths.emplace_back();
    for (const Index node : path_of(line)) {
      if (number[node] != HalfEdges::none) path.push_back(number[node]);
    }
  }
  result.snapped = nodes_.snapped();
  double farthest = nodes_.farthest_snap();
  for (const auto& [triangle, face] : faces_)
    farthest = std::max(farthest, face.inside.farthest());
  result.farthest_snap = farthest / patch_.unit_scale();
  return result;
}

}  // namespace

ImprintedMesh imprint(const Patch& patch, std::span<const SurfaceLine> lines,
                      const ImprintOptions& options) {
  if (!(options.snap >= 0.0 && options.snap <= 0.25) || !(options.farthest_snap >= 0.0))
    throw Error(ErrorCode::option_out_of_range, "a snap must be from 0 to 0.25 of an edge");
  return Imprinter(patch, options).imprint(lines);
}

}  // namespace planish
