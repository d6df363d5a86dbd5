#include "panels/division.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "core/split_mix.h"
#include "panels/cells/divided_cells.h"
#include "panels/cells/merge_cells.h"
#include "panels/cells/normal_cells.h"
#include "panels/cells/tie_lines.h"
#include "panels/folded_seams.h"

namespace planish {

namespace {

constexpr double k_least_cell = 0.002;  // of the area
constexpr double k_of_limit = 0.5;      // for the strain of cells, before they are merged
constexpr double k_least_spread = 0.5;  // mean edges
constexpr double k_faces = 0.8;         // share of borders that is on creases, of faces
constexpr double k_on_creases = 0.1;    // so that faces stay whole

/// What closing each chain costs, in multiples.
std::vector<double> favours(const SeamNet& net, const DivisionWay& way) {
  std::vector<double> factors(net.chains.size(), 1.0);
  SplitMix dice(way.seed);
  for (std::size_t c = 0; c < factors.size(); ++c) {
    if (way.seed != 0) factors[c] = 0.6 + 0.8 * dice.share();
    const Index edge = net.chains[c].edges.front();
    if (net.mesh.is_mirrored() && net.mesh.image_of_edge(edge) == edge) factors[c] *= way.plane;
  }
  return factors;
}

/// The parts that creases leave of cells; the cells where there are too many, as on a noisy scan.
std::vector<Index> divided_at_creases(const PanelMesh& mesh, const std::vector<Index>& cells) {
  constexpr Index k_more = 3;  // times the number of cells
  OpenEdges open = open_between(mesh, cells);
  for (std::size_t e = 0; e < open.size(); ++e) {
    if (is_crease(mesh, mesh.edges()[e])) open[e] = 1;
  }
  std::vector<Index> parts = parts_of(mesh, open);
  const auto count = [](const std::vector<Index>& numbers) {
    return 1 + *std::max_element(numbers.begin(), numbers.end());
  };
  return count(parts) <= k_more * count(cells) ? parts : cells;
}

/// Of the length of the borders between cells the part that is on creases.
double share_on_creases(const PanelMesh& mesh, std::span<const Index> cells) {
  double on_creases = 0.0, all = 0.0;
  for (const PanelEdge& edge : mesh.edges()) {
    if (edge.is_border() || cells[edge.triangles[0]] == cells[edge.triangles[1]]) continue;
    all += edge.length;
    if (is_crease(mesh, edge)) on_creases += edge.length;
  }
  return all > 0.0 ? on_creases / all : 0.0;
}

/// Fair lines, less so where they would bring a cell over the limit.
CellMesh lined_cells(const PanelMesh& mesh, std::span<const Index> cells, double limit,
                     double spread, ThreadPool& pool) {
  while (true) {
    const Eigen::MatrixXd fields = cell_fields(mesh, cells, spread, pool);
    CellMesh lined = imprinted_cells(mesh.patch(), tie_lines(mesh, fields), k_least_cell);
    const SeamState state(lined.mesh, open_between(lined.mesh, lined.cells), pool);
    const bool keeps =
        std::all_of(state.pieces().begin(), state.pieces().end(),
                    [&](const PanelPiece& piece) { return piece.strain() <= limit; });
    if (keeps || spread < k_least_spread) return lined;
    spread *= 0.6;
  }
}

/// All borders of cells as seams, and the plane.
SeamNet net_of(CellMesh lined, const std::optional<Plane>& plane) {
  OpenEdges seams = open_between(lined.mesh, lined.cells);
  if (plane) {
    SeamNet half{std::move(lined.mesh), seams, {}};
    return unfolded_seams({{std::move(half), std::move(seams)}, {}}, *plane).net;
  }
  std::vector<SeamChain> chains = seam_chains(lined.mesh, seams);
  return {std::move(lined.mesh), std::move(seams), std::move(chains)};
}

}  // namespace

OpenEdges SeamNet::closed(const OpenEdges& open) const {
  OpenEdges closed = seams;
  for (std::size_t e = 0; e < open.size(); ++e)
    closed[e] = closed[e] != 0 && open[e] == 0 ? 1 : 0;
  return closed;
}

DivisionWay way_of_move(std::size_t move) {
  if (move == 0) return {};
  constexpr std::array<std::size_t, 4> cells = {70, 50, 100, 85};
  constexpr std::array<double, 5> limits = {0.3, 0.45, 0.6, 0.25, 0.8};
  constexpr std::array<double, 3> spreads = {1.5, 2.5, 2.0};
  constexpr std::array<double, 3> planes = {1.0, 10.0, 0.1};
  constexpr std::array<double, 4> aims = {0.8, 0.85, 1.0, 0.92};
  constexpr std::array<double, 5> beyond = {1.3, 1.15, 1.5, 1.2, 1.4};
  return {cells[move % 4],  limits[move % 5], spreads[move % 3], move,
          planes[move % 3], aims[move % 4],   beyond[move % 5]};
}

Division divided(const PanelMesh& mesh, const std::optional<Plane>& plane, double limit,
                 const SeamPrices& prices, const DivisionWay& way, ThreadPool& pool) {
  std::vector<Index> all(mesh.triangles().size());
  std::iota(all.begin(), all.end(), Index{0});
  const std::size_t count = plane ? (way.cells + 1) / 2 : way.cells;
  const std::vector<Index> small =
      divided_cells(mesh, normal_cells(mesh, all, count), k_of_limit * limit, pool);
  const double merge_limit = way.merge_limit * limit;
  std::vector<Index> faces = merge_cells(mesh, divided_at_creases(mesh, small),
                                         {.limit = merge_limit, .on_creases = k_on_creases}, pool);
  // As of a box, whose edges are fair lines already.
  CellMesh lined = share_on_creases(mesh, faces) >= k_faces
                       ? CellMesh{mesh, std::move(faces)}
                       : lined_cells(mesh, merge_cells(mesh, small, {.limit = merge_limit}, pool),
                                     limit, way.spread, pool);
  const auto net = std::make_shared<const SeamNet>(net_of(std::move(lined), plane));
  FlatState flat = zipped_flat(SeamState(net->mesh, net->seams, pool), net->chains, limit, prices,
                               favours(*net, way), OpenEdges(net->seams.size(), 0), pool);
  Division division{net, std::move(flat.state), flat.lies_flat, 0.0};
  division.cost = division.state.cost(prices);
  return division;
}

}  // namespace planish
