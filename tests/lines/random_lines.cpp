// Draws lines of many kinds at random over meshes, makes them edges and cuts there, and checks what
// must hold of all (line_checks.h). Prints the figures of each kind.
//
//     planish_random_lines [--lines N] [--seed N] [MESH or FOLDER ...]
//
// N lines on each mesh, from one seed on; without meshes on a few that are made here. Ends with 1
// where anything is wrong, and says on which mesh and with which seed: `--lines 1 --seed N` with
// that mesh does it again.

#include "lines/random_lines.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <planish/io/read_mesh.h>
#include <planish/mesh/shapes.h>

#include "lines/line_checks.h"
#include "support/meshes.h"
#include "support/solids.h"

namespace planish::lines {
namespace {

/// By kind.
using AllFigures = std::array<Figures, k_kinds.size()>;

std::string seed_text(std::uint64_t seed, Kind kind) {
  return std::string(k_kinds[static_cast<std::size_t>(kind)]) + ", seed " + std::to_string(seed) +
         ": ";
}

/// Lines that are no lines are refused, and lead to nothing else.
std::string wrong_refusal(const Patch& patch, Drawer& drawer) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Triangle t = patch.triangles()[drawer.pick(patch.triangles().size())];
  const auto beyond = static_cast<Index>(patch.vertex_count());
  const std::array<SurfaceLine, 5> bad = {
      SurfaceLine{{t, {nan, 0.5, 0.5}}, {t, {0.0, 0.5, 0.5}}},
      SurfaceLine{{t, {1.5, -0.5, 0.0}}, {t, {0.0, 0.5, 0.5}}},
      SurfaceLine{{t, {0.2, 0.2, 0.2}}, {t, {0.0, 0.5, 0.5}}},
      SurfaceLine{{{beyond, t[1], t[2]}, {0.2, 0.2, 0.6}}, {t, {0.0, 0.5, 0.5}}},
      SurfaceLine{{{t[0], t[0], t[1]}, {0.2, 0.2, 0.6}}, {t, {0.0, 0.5, 0.5}}}};
  for (const SurfaceLine& line : bad) {
    try {
      imprint(patch, std::span(&line, 1));
      return "a line that is none is taken";
    } catch (const Error& error) {
      if (error.code() != ErrorCode::misplaced_cut) return error.what();
    }
  }
  try {
    trace_lines(patch, {{DrawnLine{{{nan, 0.0, 0.0}, {0.0, 0.0, 0.0}}}}, {}});
    return "a drawn line that is none is taken";
  } catch (const Error&) {
    return {};
  }
}

/// One run: some lines of one kind.
std::string wrong_run(const Patch& patch, Kind kind, std::size_t count, std::uint64_t seed,
                      Figures& figures) {
  Drawer drawer(patch, seed);
  std::vector<SurfaceLine> lines = drawer.lines(kind, count);
  constexpr std::size_t most_joined = 50;  // each end is looked for on the whole mesh
  if (drawer.pick(3) == 0 && lines.size() <= most_joined) {
    const auto is_short = [](const SurfaceLine& line) { return line.size() < 2; };
    std::erase_if(lines, is_short);
    lines = join_lines(patch, std::move(lines), join_tolerance(patch.mesh())).lines;
  }
  std::string wrong = wrong_imprint(patch, lines, imprint(patch, lines), figures);
  if (wrong.empty() && kind == Kind::points) wrong = wrong_refusal(patch, drawer);
  return wrong;
}

/// @return how many runs went wrong
int try_mesh(const std::string& name, const TriMesh& mesh, std::size_t lines, std::uint64_t seed,
             AllFigures& all) {
  const Patch patch(mesh);
  Figures sum;
  int wrong_runs = 0;
  for (std::uint64_t now = seed; sum.lines < lines; ++now) {
    const auto kind = static_cast<Kind>(now % k_kinds.size());
    // Few lines show what one line does, many what their crossings do.
    const bool is_few = kind == Kind::geodesics || (now / k_kinds.size()) % 2 == 0;
    const std::size_t count = is_few ? 3 : 10;
    Figures figures;
    std::string wrong;
    try {
      wrong = wrong_run(patch, kind, count, now, figures);
    } catch (const std::exception& error) {
      wrong = error.what();
    }
    if (!wrong.empty()) {
      ++wrong_runs;
      std::printf("%s, %s%s\n", name.c_str(), seed_text(now, kind).c_str(), wrong.c_str());
    }
    figures.lines = count;
    sum.add(figures);
    all[static_cast<std::size_t>(kind)].add(figures);
  }
  std::printf("%-24s %6zu triangles, %6zu lines, %d wrong\n", name.c_str(), mesh.triangles.size(),
              sum.lines, wrong_runs);
  std::fflush(stdout);
  return wrong_runs;
}

void print(const std::string& name, const Figures& figures) {
  const auto percent = [&](std::size_t count) {
    const auto all = static_cast<double>(std::max<std::size_t>(figures.triangles, 1));
    return 100.0 * static_cast<double>(count) / all;
  };
  std::printf(
      "%-10s %6zu lines %8zu new triangles, thin %5.2f %%, of these not given %5.2f %%; "
      "snapped by %.1e, beside that %.1e of the diagonal, length %.1e\n",
      name.c_str(), figures.lines, figures.triangles, percent(figures.thin),
      percent(figures.thin - figures.given), figures.snap, figures.farthest, figures.stretch);
}

/// The mesh with a vertex on each third triangle, close to one of its edges.
TriMesh with_needles(TriMesh mesh, std::uint64_t seed) {
  meshes::Random random(seed);
  const std::size_t count = mesh.triangles.size();
  for (std::size_t t = 0; t < count; t += 3) {
    const Triangle old = mesh.triangles[t];
    const double small = 1e-7 + 1e-3 * std::abs(random.number()),
                 share = 0.5 + 0.4 * random.number();
    const auto v = static_cast<Index>(mesh.positions.size());
    mesh.positions.push_back(position_of(
        SurfacePoint{old, {small, (1.0 - small) * share, (1.0 - small) * (1.0 - share)}},
        mesh.positions));
    mesh.triangles[t] = {old[0], old[1], v};
    mesh.triangles.push_back({old[1], old[2], v});
    mesh.triangles.push_back({old[2], old[0], v});
  }
  return mesh;
}

TriMesh squeezed(TriMesh mesh, Vec3 by) {
  for (Vec3& p : mesh.positions)
    p = {by.x * p.x, by.y * p.y, by.z * p.z};
  return mesh;
}

std::vector<std::pair<std::string, TriMesh>> made_meshes() {
  return {
      {"plane", meshes::flat_grid(9, 7)},
      {"one triangle", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}},
      {"rough", meshes::rough_grid(20, 20, 1, 0.25, 1.0)},
      {"needles", with_needles(meshes::rough_grid(12, 12, 3), 5)},
      {"long triangles", squeezed(meshes::rough_grid(20, 20, 2), {1.0, 1e-4, 1.0})},
      {"handle", meshes::torus(12, 20)},
      {"sphere", solids::sphere(1.0, 12)},
      {"cube", solids::cube()},
      {"tube", meshes::tube(14, 20)},
      {"ruffles", meshes::ruffled_fan(14, 0.8)},
      {"dome", make_shape("dome", 800)},
  };
}

std::vector<std::pair<std::string, TriMesh>> read_meshes(const std::vector<std::string>& names) {
  std::vector<std::filesystem::path> files;
  for (const std::string& name : names) {
    if (!std::filesystem::is_directory(name)) {
      files.emplace_back(name);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(name)) {
      const auto extension = entry.path().extension();
      if (extension == ".obj" || extension == ".ply") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<std::pair<std::string, TriMesh>> meshes;
  meshes.reserve(files.size());
  for (const auto& file : files)
    meshes.emplace_back(file.stem().native(), read_mesh(file).mesh);
  return meshes;
}

int run(const std::vector<std::string>& arguments) {
  std::size_t lines = 300, seed = 1;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    const bool has_value = k + 1 < arguments.size();
    if (arguments[k] == "--lines" && has_value) {
      lines = std::stoul(arguments[++k]);
    } else if (arguments[k] == "--seed" && has_value) {
      seed = std::stoul(arguments[++k]);
    } else {
      names.push_back(arguments[k]);
    }
  }
  AllFigures all;
  int wrong = 0;
  for (const auto& [name, mesh] : names.empty() ? made_meshes() : read_meshes(names))
    wrong += try_mesh(name, mesh, lines, seed, all);
  Figures sum;
  for (std::size_t k = 0; k < k_kinds.size(); ++k) {
    print(std::string(k_kinds[k]), all[k]);
    sum.add(all[k]);
  }
  print("all", sum);
  std::printf("%d runs went wrong\n", wrong);
  return wrong == 0 ? 0 : 1;
}

}  // namespace
}  // namespace planish::lines

int main(int count, char** words) {
  return planish::lines::run({words + 1, words + count});
}
