#include "report/product/drawn_product.h"

#include <algorithm>
#include <map>

#include "mesh/symmetry/moments.h"
#include "report/page/display_mesh.h"

namespace planish {

namespace {

constexpr std::size_t k_least_of_piece = 300;  // vertices

/// By their numbers.
std::vector<std::size_t> pieces_in_place(const ProductReport& report) {
  std::map<std::size_t, std::vector<std::size_t>> groups;
  for (std::size_t p = 0; p < report.patches.size(); ++p) {
    if (report.patches[p].finished) groups[report.patches[p].group].push_back(p);
  }
  std::vector<std::size_t> most;
  for (auto& [group, pieces] : groups) {
    if (pieces.size() > most.size()) most = std::move(pieces);
  }
  return most.size() < 2 ? std::vector<std::size_t>() : most;
}

/// The vertices of a side from end to end.
std::vector<Index> whole_vertices(const SeamSide& side) {
  std::vector<Index> vertices = side.vertices;
  if (vertices.size() > 2 && side.last_share < 0.5) vertices.pop_back();
  if (vertices.size() > 2 && side.first_share >= 0.5) vertices.erase(vertices.begin());
  return vertices;
}

std::vector<DrawnSeam> seams_of(const ProductReport& report, std::size_t patch) {
  std::vector<DrawnSeam> seams;
  for (std::size_t s = 0; s < report.seams.size(); ++s) {
    for (const SeamSide& side : report.seams[s].seam.sides) {
      if (side.patch == patch) seams.push_back({s + 1, patch, whole_vertices(side)});
    }
  }
  return seams;
}

/// Puts pieces behind one another.
class Assembly {
 public:
  Assembly(const ProductReport& report, std::size_t most) : report_(report), most_(most) {}

  DrawnProduct of(const std::vector<std::size_t>& patches) {
    double scale = 0.0;
    for (const std::size_t p : patches) {
      all_ += report_.patches[p].finished->processed.positions.size();
      const double own = unit_scale(report_.patches[p].finished->processed);
      scale = scale == 0.0 ? own : std::min(scale, own);
      moved_ = moved_ || !report_.patches[p].design.empty();
    }
    for (const std::size_t p : patches)
      add(p, scale);
    if (area_ > 0.0) drawn_.middle = 1.0 / area_ * sum_;
    return std::move(drawn_);
  }

 private:
  void add(std::size_t p, double scale) {
    const PatchResult& piece = report_.patches[p];
    const TriMesh& mesh = piece.finished->processed;
    const std::size_t count = mesh.positions.size();
    std::vector<DrawnSeam> seams = seams_of(report_, p);
    std::vector<Index> ends;
    for (const DrawnSeam& seam : seams)
      ends.insert(ends.end(), {seam.vertices.front(), seam.vertices.back()});
    const std::size_t share = std::max(k_least_of_piece, most_ * count / all_);
    const DisplayMesh shown = display_mesh(Patch(mesh), share, ends);
    add_seams(std::move(seams), shown);
    add_mesh(shown, mesh, piece.design.empty() ? mesh.positions : piece.design);
    const SurfaceMoments moments = moments_of(mesh.triangles, mesh.positions, scale);
    const Eigen::Vector3d middle = 1.0 / scale * moments.middle;
    drawn_.pieces.push_back({p, shown.source.size(), {middle.x(), middle.y(), middle.z()}});
    area_ += moments.area;
    sum_ += moments.area * drawn_.pieces.back().middle;
  }

  /// Before the vertices themselves.
  void add_seams(std::vector<DrawnSeam> seams, const DisplayMesh& shown) {
    const auto first = static_cast<Index>(drawn_.mesh.positions.size());
    for (DrawnSeam& seam : seams) {
      std::vector<Index> left;
      for (const Index v : seam.vertices) {
        const auto found = std::lower_bound(shown.source.begin(), shown.source.end(), v);
        if (found != shown.source.end() && *found == v)
          left.push_back(first + static_cast<Index>(found - shown.source.begin()));
      }
      seam.vertices = std::move(left);
      drawn_.seams.push_back(std::move(seam));
    }
  }

  void add_mesh(const DisplayMesh& shown, const TriMesh& mesh, const std::vector<Vec3>& design) {
    const auto first = static_cast<Index>(drawn_.mesh.positions.size());
    for (const Index v : shown.source) {
      drawn_.mesh.positions.push_back(mesh.positions[v]);
      if (moved_) drawn_.design.push_back(design[v]);
    }
    for (const Triangle& t : shown.triangles)
      drawn_.mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }

  const ProductReport& report_;
  std::size_t most_, all_ = 0;
  bool moved_ = false;
  double area_ = 0.0;
  Vec3 sum_;
  DrawnProduct drawn_;
};

}  // namespace

DrawnProduct drawn_product(const ProductReport& report, std::size_t most) {
  return Assembly(report, most).of(pieces_in_place(report));
}

}  // namespace planish
